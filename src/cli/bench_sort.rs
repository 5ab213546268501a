//! `effigy bench-sort`: keys a second by count, key bits and variant, each result checked against the CPU first.

use super::options::{Keys, SortBy};
use crate::vulkan::{
    Gpu, GpuOptions,
    sort::{
        SortOptions, Variant,
        choice::choose,
        trial::{Times, Trial},
    },
};
use anyhow::{Context, ensure};
use serde_json::{Value, json};
use std::{path::PathBuf, sync::Arc};

#[derive(clap::Args)]
pub struct Args {
    /// GPU to use: part of its name, or its number in `effigy devices` [default: the first that can serve]
    #[arg(long, value_name = "NAME")]
    device: Option<String>,
    /// Fewest keys; each step has four times as many
    #[arg(long, default_value_t = 1 << 10, value_parser = clap::value_parser!(u32).range(1..1 << 30))]
    smallest: u32,
    /// Most keys
    #[arg(long, default_value_t = 1 << 24, value_parser = clap::value_parser!(u32).range(1..1 << 30))]
    largest: u32,
    /// Bits of the keys, with commas between
    #[arg(long, value_enum, value_delimiter = ',', default_value = "16,24,32")]
    keys: Vec<Keys>,
    /// Variants, with commas between [default: all that the device can run]
    #[arg(long, value_enum, value_delimiter = ',', value_name = "VARIANT")]
    sort: Vec<SortBy>,
    /// Runs of which the median counts
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..))]
    runs: u16,
    /// Write the result as JSON too
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    ensure!(args.smallest <= args.largest, "--smallest {} is more than --largest {}", args.smallest, args.largest);
    let gpu = Gpu::new(&GpuOptions::headless(args.device.clone()))?;
    println!("device   {} ({})", gpu.probe.name, gpu.probe.driver);
    let auto = choose(&gpu)?.variant;
    println!("auto     {}", auto.name());
    println!("time     {}", if gpu.probe.timestamp_bits > 0 { "the device's timestamps" } else { "the host's clock" });
    println!("A key and its index are sorted; the order of the indices comes out. Mkeys/s:\n");
    let wanted: Vec<Variant> = args.sort.iter().map(|&sort| Option::from(sort).unwrap_or(auto)).collect();
    let able = |variant: &Variant| if wanted.is_empty() { variant.lacks(&gpu).is_none() } else { wanted.contains(variant) };
    let variants: Vec<_> = Variant::ALL.into_iter().filter(able).collect();
    print!("{:>9} {:>4}", "keys", "bits");
    variants.iter().for_each(|variant| print!(" {:>10}", variant.name()));
    println!();
    let mut rows = Vec::new();
    for &bits in &args.keys {
        let steps = std::iter::successors(Some(args.smallest), |count| count.checked_mul(4)).take_while(|&count| count <= args.largest);
        for count in steps {
            let keys = keys(count);
            print!("{count:>9} {:>4}", 8 * crate::vulkan::sort::KeyBits::from(bits).passes());
            for &variant in &variants {
                let row = row(&gpu, &keys, SortOptions::new(bits.into(), variant), args.runs);
                match row["mkeys_per_s"].as_f64() {
                    Some(rate) => print!(" {rate:>10.2}"),
                    None => print!(" {:>10}", "–"),
                }
                rows.push(row);
            }
            println!();
        }
    }
    rows.iter().filter_map(|row| row["failed"].as_str()).for_each(|failed| println!("{failed}"));
    if let Some(path) = args.json {
        let result = json!({ "device": gpu.probe.name, "driver": gpu.probe.driver, "runs": args.runs, "rows": rows });
        std::fs::write(&path, serde_json::to_string_pretty(&result)? + "\n")
            .with_context(|| format!("{} can't be written", path.display()))?;
        println!("wrote {}", path.display());
    }
    // What nobody asked for and the start-up test does not pick may be wrong on a device: that was said.
    let meant: Vec<_> = if wanted.is_empty() { vec![auto] } else { wanted }.into_iter().map(Variant::name).collect();
    let wrong = |row: &&Value| !row["failed"].is_null() && meant.iter().any(|name| row["variant"] == **name);
    ensure!(rows.iter().find(wrong).is_none(), "not every sort was right, see above");
    Ok(())
}

/// Checks and measures one variant.
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
        Err(error) => row["failed"] = json!(format!("{} keys, {}: {error:#}", keys.len(), options.variant.name())),
    }
    row
}

/// Median times, and the sort's memory.
fn measure(gpu: &Arc<Gpu>, keys: &[u32], options: SortOptions, runs: u16) -> anyhow::Result<(Times, u64)> {
    let trial = Trial::new(gpu, keys.len() as u32, options)?;
    trial.load(keys)?;
    trial.run()?;
    if let Some(difference) = trial.difference(keys)? {
        anyhow::bail!("wrong: {difference}");
    }
    let mut times = (0..runs).map(|_| trial.run()).collect::<Result<Vec<_>, _>>()?;
    times.sort_by_key(|times| times.device);
    Ok((times[times.len() / 2], trial.sort().memory()))
}

/// Keys without pattern (the finaliser of splitmix64).
fn keys(count: u32) -> Vec<u32> {
    let mix = |at: u32| {
        let z = (u64::from(at) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        (z >> 32) as u32 & 0x7fff_ffff
    };
    (0..count).map(mix).collect()
}
