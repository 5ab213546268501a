//! `effigy bench-sort`: keys per second by count, key bits and variant, each result checked against
//! the CPU first.

use crate::{
    files,
    options::{DeviceArgs, KeysArg, SortArg},
};
use anyhow::ensure;
use effigy::vulkan::{
    Gpu,
    sort::{
        self, KeyBits, SortOptions, SortVariant,
        choice::choose,
        standalone::{SortTimes, StandaloneSort},
    },
};
use effigy_core::random::hash;
use serde_json::{Value, json};
use std::{iter, path::PathBuf, sync::Arc};

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    device: DeviceArgs,
    /// Fewest keys to sort, 1 or more; each step has four times as many
    #[arg(long, alias = "smallest", value_name = "N", default_value_t = 1 << 10, value_parser = clap::value_parser!(u32).range(1..1 << 30))]
    min_keys: u32,
    /// Most keys to sort, below 2^30
    #[arg(long, alias = "largest", value_name = "N", default_value_t = 1 << 24, value_parser = clap::value_parser!(u32).range(1..1 << 30))]
    max_keys: u32,
    /// Bits of the keys, separated by commas
    #[arg(long, value_enum, value_delimiter = ',', default_value = "16,24,32")]
    keys: Vec<KeysArg>,
    /// Sort variants, separated by commas [default: all that the device can run]
    #[arg(long, value_enum, value_delimiter = ',')]
    sort: Vec<SortArg>,
    /// Times that each sort is run, 1 or more; the median counts
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..))]
    runs: u16,
    /// Also write the result as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    ensure!(
        args.min_keys <= args.max_keys,
        "--min-keys {} is more than --max-keys {}",
        args.min_keys,
        args.max_keys
    );
    let gpu = Gpu::new(&args.device.gpu())?;
    println!("device   {} ({})", gpu.probe.name, gpu.probe.driver);
    let auto = choose(&gpu)?.variant;
    println!("auto     {}", auto.name());
    let clock = if gpu.probe.timestamp_bits > 0 {
        "the device's timestamps"
    } else {
        "the host's clock"
    };
    println!("time     {clock}");
    println!(
        "Keys are sorted with their indices, and the order of the indices is read. Mkeys/s:\n"
    );
    let wanted: Vec<SortVariant> = args
        .sort
        .iter()
        .map(|&sort| Option::from(sort).unwrap_or(auto))
        .collect();
    let is_measured = |variant: &SortVariant| {
        if wanted.is_empty() {
            sort::unsupported(*variant, &gpu).is_none()
        } else {
            wanted.contains(variant)
        }
    };
    let variants: Vec<_> = SortVariant::ALL.into_iter().filter(is_measured).collect();
    let rows = measure_all(&gpu, &args, &variants);
    for row in &rows {
        if let Some(failure) = row["failed"].as_str() {
            println!("{failure}");
        }
    }
    if let Some(path) = &args.json {
        let result = json!({ "device": gpu.probe.name, "driver": gpu.probe.driver, "runs": args.runs, "rows": rows });
        files::write_json(path, &result)?;
        println!("wrote {}", path.display());
    }
    // A variant that was not asked for and that the self-test does not choose may be wrong on a
    // device: its failure is printed, and the command succeeds.
    let required = if wanted.is_empty() {
        vec![auto]
    } else {
        wanted
    };
    let wrong = rows
        .iter()
        .filter(|row| !row["failed"].is_null())
        .any(|row| {
            required
                .iter()
                .any(|variant| row["variant"] == variant.name())
        });
    ensure!(!wrong, "not every sort was right, see above");
    Ok(())
}

/// Measures every count, key size and variant, printing a line per count and key size.
fn measure_all(gpu: &Arc<Gpu>, args: &Args, variants: &[SortVariant]) -> Vec<Value> {
    print!("{:>9} {:>4}", "keys", "bits");
    for variant in variants {
        print!(" {:>10}", variant.name());
    }
    println!();
    let mut rows = Vec::new();
    for &bits in &args.keys {
        let bits = KeyBits::from(bits);
        let counts = iter::successors(Some(args.min_keys), |count| count.checked_mul(4));
        for count in counts.take_while(|&count| count <= args.max_keys) {
            let keys = keys(count);
            print!("{count:>9} {:>4}", 8 * bits.passes());
            for &variant in variants {
                let row = row(gpu, &keys, SortOptions::new(bits, variant), args.runs);
                match row["mkeys_per_s"].as_f64() {
                    Some(rate) => print!(" {rate:>10.2}"),
                    None => print!(" {:>10}", "–"),
                }
                rows.push(row);
            }
            println!();
        }
    }
    rows
}

/// Checks and measures one variant; the row holds its times, or how it failed.
fn row(gpu: &Arc<Gpu>, keys: &[u32], options: SortOptions, runs: u16) -> Value {
    let mut row = json!({ "keys": keys.len(), "bits": 8 * options.bits.passes(), "variant": options.variant.name() });
    match measure(gpu, keys, options, runs) {
        Ok((times, bytes)) => {
            let ms = times.device.as_secs_f64() * 1e3;
            row["ms"] = json!(ms);
            row["wall_ms"] = json!(times.wall.as_secs_f64() * 1e3);
            row["mkeys_per_s"] = json!(keys.len() as f64 / ms / 1e3);
            row["memory_bytes"] = json!(bytes);
        }
        Err(error) => {
            row["failed"] = json!(format!(
                "{} keys, {}: {error:#}",
                keys.len(),
                options.variant.name()
            ))
        }
    }
    row
}

/// Times of the median run, and the sort's memory in bytes.
fn measure(
    gpu: &Arc<Gpu>,
    keys: &[u32],
    options: SortOptions,
    runs: u16,
) -> anyhow::Result<(SortTimes, u64)> {
    let sorter = StandaloneSort::new(gpu, keys.len() as u32, options)?;
    sorter.load(keys)?;
    sorter.run()?;
    if let Some(difference) = sorter.difference(keys)? {
        anyhow::bail!("wrong: {difference}");
    }
    let mut times = (0..runs)
        .map(|_| sorter.run())
        .collect::<Result<Vec<_>, _>>()?;
    times.sort_by_key(|times| times.device);
    Ok((times[times.len() / 2], sorter.sort().memory()))
}

/// Keys of 31 bits without pattern.
fn keys(count: u32) -> Vec<u32> {
    (0..u64::from(count))
        .map(|at| (hash(at) >> 33) as u32)
        .collect()
}
