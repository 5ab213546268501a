//! `effigy-lab bench-sort`: keys per second by count, key bits and variant, each result checked
//! against the CPU first.

use crate::sorts::{SCHEMA, SortRow, SortSpeed, SortsReport, sort_name};
use anyhow::ensure;
use clap::ValueEnum;
use effigy_cli::{
    options::{self, DeviceArgs, SortArg},
    output::{JSON, Output},
    progress,
};
use effigy_core::random::hash;
use effigy_measure::{
    WARM_UP,
    report::{DeviceReport, Program},
};
use effigy_render::vulkan::{
    Gpu,
    sort::{
        self, KeyBits, SortOptions, SortVariant,
        choice::choose,
        standalone::{self, StandaloneSort},
    },
};
use std::{
    fmt::Write,
    iter,
    sync::Arc,
    time::{Duration, Instant},
};

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
    #[arg(long, value_enum, value_delimiter = ',', default_value = "16,22,32")]
    keys: Vec<KeysArg>,
    /// Sort variants, separated by commas [default: all that the device can run]
    #[arg(long, value_enum, value_delimiter = ',')]
    sort: Vec<SortArg>,
    /// Also measure variants that use subgroups at each size of subgroups that the device has on
    /// request
    #[arg(long)]
    subgroups: bool,
    /// Times that each sort is run, 1 or more, after a warm-up of 0.5 s; the median counts
    #[arg(
        long,
        value_name = "N",
        default_value_t = 21,
        value_parser = clap::value_parser!(u16).range(1..)
    )]
    runs: u16,
    /// Minutes in all; what would take longer is left out, the most keys first
    #[arg(long, value_name = "N", default_value = "1", value_parser = options::minutes)]
    minutes: f64,
    /// Also write the result as JSON
    #[arg(long, value_name = "FILE", value_parser = JSON.parser())]
    json: Option<Output>,
}

/// [`KeyBits`] as an argument.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum KeysArg {
    /// Two sort passes; depth steps of about 30 µm
    #[value(name = "16")]
    Bits16,
    /// Three sort passes; depth steps under 1 µm
    #[value(name = "22", alias = "24")]
    Bits22,
    /// Four sort passes; the finest steps
    #[value(name = "32")]
    Bits32,
}

impl From<KeysArg> for KeyBits {
    fn from(keys: KeysArg) -> Self {
        match keys {
            KeysArg::Bits16 => Self::Sixteen,
            KeysArg::Bits22 => Self::TwentyTwo,
            KeysArg::Bits32 => Self::ThirtyTwo,
        }
    }
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
    let contenders: Vec<_> = SortVariant::ALL
        .into_iter()
        .filter(is_measured)
        .flat_map(|variant| contenders(variant, &gpu, args.subgroups))
        .collect();
    let mut report = SortsReport {
        schema: SCHEMA.to_owned(),
        program: Program::current(std::env::args().collect()),
        device: DeviceReport::from_vulkan(&gpu),
        runs: args.runs,
        auto: auto.name().to_owned(),
        rows: Vec::new(),
    };
    measure_all(&gpu, &args, &contenders, &mut report)?;
    for row in &report.rows {
        if let Some(failure) = &row.failed {
            println!("{failure}");
        }
    }
    if let Some(out) = &args.json {
        out.write_json(&report)?;
        println!("wrote {}", out.display());
    }
    // A variant that was not asked for and that the self-test does not choose, or that it chooses
    // at another size of subgroups, may be wrong on a device: its failure is printed, and the
    // command succeeds.
    let is_required = |row: &SortRow| {
        if wanted.is_empty() {
            row.variant == auto.name() && row.subgroup.is_none()
        } else {
            wanted.iter().any(|variant| row.variant == variant.name())
        }
    };
    let wrong = report
        .rows
        .iter()
        .any(|row| row.failed.is_some() && is_required(row));
    ensure!(!wrong, "not every sort was right, see above");
    Ok(())
}

/// What is measured: a variant, with subgroups of a size.
struct Contender {
    variant: SortVariant,
    /// Lanes of a subgroup. None: as many as the device reports.
    subgroup: Option<u32>,
}

impl Contender {
    fn name(&self) -> String {
        sort_name(self.variant.name(), self.subgroup)
    }
}

/// A variant at the size of subgroups that the device reports and, with `every_size`, at each other
/// that it has on request, where the variant uses them.
fn contenders(variant: SortVariant, gpu: &Gpu, every_size: bool) -> Vec<Contender> {
    let asked = every_size && variant == SortVariant::OneSweep;
    let [low, high] = gpu.probe.subgroup_sizes.filter(|_| asked).unwrap_or([1, 0]);
    let sizes = iter::successors(Some(low), |lanes| lanes.checked_mul(2));
    let sizes = sizes
        .take_while(|&lanes| lanes <= high)
        .filter(|&lanes| lanes != gpu.probe.subgroup_size);
    iter::once(None)
        .chain(sizes.map(Some))
        .map(|subgroup| Contender { variant, subgroup })
        .collect()
}

/// Measures every count, key size and contender, printing a line per count and key size, as long as
/// the next line is expected to fit into the time. With each line the report is written: it is not
/// lost if the program is stopped.
fn measure_all(
    gpu: &Arc<Gpu>,
    args: &Args,
    contenders: &[Contender],
    report: &mut SortsReport,
) -> anyhow::Result<()> {
    let mut heading = format!("{:>9} {:>4}", "keys", "bits");
    for contender in contenders {
        write!(heading, " {:>10}", contender.name())?;
    }
    println!("{heading}");
    let limit = Duration::from_secs_f64(60.0 * args.minutes);
    let bar = progress::within(limit);
    // What the last count took, by key size. But for the warm-up, four times as many keys take at
    // most four times as long.
    let mut took = vec![Duration::ZERO; args.keys.len()];
    let counts = iter::successors(Some(args.min_keys), |count| count.checked_mul(4));
    for count in counts.take_while(|&count| count <= args.max_keys) {
        let unsorted = keys(count);
        for (&bits, took) in args.keys.iter().zip(&mut took) {
            let bits = KeyBits::from(bits);
            let name = format!("{count} keys of {} bits", bits.bits());
            let warm_up = WARM_UP * contenders.len() as u32;
            if bar.elapsed() + warm_up + 4 * took.saturating_sub(warm_up) > limit {
                bar.finish_and_clear();
                println!(
                    "left out: {name} and more, which need more than --minutes {}",
                    args.minutes
                );
                return Ok(());
            }
            let begun = Instant::now();
            let sorted = SortInput {
                order: standalone::expected(&unsorted, bits),
                keys: unsorted.clone(),
                bits,
            };
            let mut line = format!("{count:>9} {:>4}", bits.bits());
            for contender in contenders {
                bar.set_message(format!("{name}, {}", contender.name()));
                let row = row(gpu, &sorted, contender, args.runs);
                match row.speed {
                    Some(speed) => write!(line, " {:>10.2}", speed.mkeys_per_s)?,
                    None => write!(line, " {:>10}", "–")?,
                }
                report.rows.push(row);
            }
            *took = begun.elapsed();
            bar.suspend(|| println!("{line}"));
            if let Some(out) = &args.json {
                out.keep_json(report)?;
            }
        }
    }
    bar.finish_and_clear();
    Ok(())
}

/// The keys that are sorted.
struct SortInput {
    keys: Vec<u32>,
    bits: KeyBits,
    /// The order that a sort must give.
    order: Vec<u32>,
}

/// Checks and measures one sort; the row holds its times, or how it failed.
fn row(gpu: &Arc<Gpu>, keys: &SortInput, contender: &Contender, runs: u16) -> SortRow {
    let options = SortOptions {
        subgroup: contender.subgroup,
        ..SortOptions::new(keys.bits, contender.variant)
    };
    let count = keys.keys.len();
    let (speed, failed) = match measure(gpu, keys, options, runs) {
        Ok(speed) => (Some(speed), None),
        Err(error) => {
            let name = contender.name();
            (None, Some(format!("{count} keys, {name}: {error:#}")))
        }
    };
    SortRow {
        keys: count,
        bits: keys.bits.bits(),
        variant: contender.variant.name().to_owned(),
        subgroup: contender.subgroup,
        speed,
        failed,
    }
}

/// Speed of the median run of a sort that is right.
fn measure(
    gpu: &Arc<Gpu>,
    keys: &SortInput,
    options: SortOptions,
    runs: u16,
) -> anyhow::Result<SortSpeed> {
    let count = keys.keys.len();
    let sorter = StandaloneSort::new(gpu, count as u32, options)?;
    sorter.load(&keys.keys)?;
    sorter.run()?;
    if let Some(difference) = sorter.difference_from(&keys.order, count)? {
        anyhow::bail!("wrong: {difference}");
    }
    let begin = Instant::now();
    while begin.elapsed() < WARM_UP {
        sorter.run()?;
    }
    let mut times = (0..runs)
        .map(|_| sorter.run())
        .collect::<Result<Vec<_>, _>>()?;
    times.sort_by_key(|times| times.device);
    let median = times[times.len() / 2];
    let ms = median.device.as_secs_f64() * 1e3;
    Ok(SortSpeed {
        ms,
        wall_ms: median.wall.as_secs_f64() * 1e3,
        // A clock may not resolve so few keys.
        mkeys_per_s: if ms > 0.0 {
            count as f64 / ms / 1e3
        } else {
            0.0
        },
        memory_bytes: sorter.sort().memory(),
    })
}

/// Keys of 31 bits without pattern.
fn keys(count: u32) -> Vec<u32> {
    (0..u64::from(count))
        .map(|at| (hash(at) >> 33) as u32)
        .collect()
}
