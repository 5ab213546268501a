//! `effigy soak`: minutes on end at a promised rate, without a window; and two soaks against each other.

use super::{
    options::{self, Quality},
    source::Source,
};
use crate::{
    avatar::motion::Player,
    measure::{
        bench::Setting,
        soak::{self, Report, Session, Settings, Task, compare, files, verdict::Bounds},
        thermals::{Phone, Recorded, Simulated, Thermals},
        trace::Trace,
    },
    vulkan::Gpu,
};
use anyhow::{Context, ensure};
use clap::ValueEnum;
use std::{
    path::{Path, PathBuf},
    sync::{Arc, atomic::AtomicBool},
};

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// How long to draw
    #[arg(long, default_value_t = 20.0, value_parser = options::minutes)]
    minutes: f64,
    /// The rate to hold, frames a second [default: the highest usual one that a short test holds with time to spare]
    #[arg(long, value_name = "N", value_parser = options::rate)]
    fps: Option<f64>,
    /// Width and height, px
    #[arg(long, value_parser = options::size, default_value = "1024x1024")]
    size: [u32; 2],
    /// Whether to give up quality to hold the rate
    #[arg(long, value_enum, default_value_t = Switch::On)]
    governor: Switch,
    /// Slow this device down as a phone that heats: left alone, the paper's would throttle halfway through
    #[arg(long)]
    simulate_heat: bool,
    /// Give the governor the headroom that another soak has recorded, its .csv
    #[arg(long, value_name = "FILE", conflicts_with = "simulate_heat")]
    replay_heat: Option<PathBuf>,
    /// Refreshes that may show nothing new, per cent, once it has settled
    #[arg(long, value_name = "PERCENT", default_value_t = 1.0, value_parser = amount)]
    late: f64,
    /// What memory may grow by, MiB
    #[arg(long, value_name = "MIB", default_value_t = 1.0, value_parser = amount)]
    growth: f64,
    /// Leave out the comparison with the f64 reference at the end, which takes seconds
    #[arg(long)]
    no_check: bool,
    /// Write a timeline of host and device of the last frames too, for Perfetto: a .json
    #[arg(long, value_name = "FILE", value_parser = super::options::trace)]
    trace: Option<PathBuf>,
    /// Name of the files to write: .json, .csv, .svg and .png are put after it
    #[arg(short, long, value_name = "NAME", default_value = "effigy-soak")]
    out: PathBuf,
    /// Set two soaks' .json against each other instead
    #[arg(long, value_names = ["A", "B"], num_args = 2)]
    compare: Option<Vec<PathBuf>>,
    #[command(flatten)]
    quality: Quality,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Switch {
    On,
    Off,
}

fn amount(text: &str) -> Result<f64, String> {
    options::number(text, 0.0, 1e6, "amount")
}

pub fn run(args: Args) -> anyhow::Result<()> {
    if let Some(files) = &args.compare {
        return set_against(&files[0], &files[1]);
    }
    let stop = interrupts()?;
    let (avatar, clips) = args.source.load()?;
    let player = Player::new(clips.into_iter().next().context("there is no clip")?, &avatar.skeleton);
    let gpu = Gpu::new(&args.quality.gpu())?;
    let setting = Setting { options: args.quality.renderer(args.size).settled(&gpu), packed_words: false, rows: 1.0, hold: 1 };
    let rate = args.fps.map_or_else(|| soak::run::suited_rate(&gpu, &avatar, &player, &setting), Ok)?;
    let settings = Settings { rate, governed: args.governor == Switch::On, seconds: 60.0 * args.minutes };
    let bounds = Bounds { dropped: args.late / 100.0, growth: (args.growth * f64::from(1 << 20)) as u64 };
    let mut thermals = thermals(&args, rate)?;
    let command = std::env::args().collect();
    let task = Task { avatar: &avatar, player: &player, setting, settings, bounds, check: !args.no_check, command };
    let [width, height] = args.size;
    println!("soaking {} at {rate} frames a second, {width} × {height}, for {} min with {}", avatar.name, args.minutes, gpu.probe.name);
    let mut last = (0.0, 0);
    let mut tick = |session: &Session| say(session, &mut last);
    let mut trace = args.trace.as_ref().map(|_| Trace::new(&gpu));
    let report = soak::run(&gpu, &task, (&mut thermals, trace.as_mut()), &stop, &mut tick)?;
    args.trace.iter().zip(&trace).try_for_each(|(path, trace)| super::options::write_trace(path, trace, &gpu))?;
    files::write(&report, &args.out)?.iter().for_each(|path| println!("wrote {}", path.display()));
    conclude(&report)
}

fn thermals(args: &Args, rate: f64) -> anyhow::Result<Thermals> {
    /// How long the phone takes for what a simulated run shows: ten minutes cool, ten hot; seconds.
    const CURVE: f64 = 1200.0;
    Ok(match &args.replay_heat {
        _ if args.simulate_heat => Thermals::Simulated(Simulated::new(Phone::default(), (CURVE / (60.0 * args.minutes)).max(1.0), rate)),
        Some(path) => {
            let text = std::fs::read_to_string(path).with_context(|| format!("{} can't be read", path.display()))?;
            let recorded = Recorded::read(&text).map_err(anyhow::Error::msg);
            Thermals::Recorded(recorded.with_context(|| format!("{} can't be replayed", path.display()))?)
        }
        None => Thermals::System(Box::default()),
    })
}

/// Set when the user wants an end; a second time ends the program at once.
fn interrupts() -> anyhow::Result<Arc<AtomicBool>> {
    let stop = Arc::new(AtomicBool::new(false));
    #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
    {
        use signal_hook::{consts::SIGINT, flag};
        let listening = "Ctrl-C can't be listened to";
        flag::register_conditional_shutdown(SIGINT, 130, stop.clone()).context(listening)?;
        flag::register(SIGINT, stop.clone()).context(listening)?;
    }
    Ok(stop)
}

/// A line every ten seconds, and where the governor steps.
fn say(session: &Session, (said, rung): &mut (f64, usize)) {
    let (Some(second), (ladder, now)) = (session.each().last(), session.ladder()) else { return };
    if now == *rung && second.seconds - *said < 9.99 {
        return;
    }
    (*said, *rung) = (second.seconds, now);
    let heat = second.headroom.map_or(String::new(), |headroom| format!(", headroom used {headroom:.2}"));
    let memory = second.device_bytes as f64 / 1e6;
    println!(
        "{:5.0} s  {:6.1} fps, p50 {:.1} p95 {:.1} p99 {:.1} ms, {} late, {} dropped, step {now} ({}){heat}, {memory:.0} MB",
        second.seconds,
        second.fps,
        second.frame_ms_p50,
        second.frame_ms_p95,
        second.frame_ms_p99,
        session.totals().late,
        session.totals().dropped,
        ladder[now].name,
    );
}

fn conclude(report: &Report) -> anyhow::Result<()> {
    if report.lasted_seconds < report.planned_seconds {
        println!("interrupted after {:.0} s of {:.0} s", report.lasted_seconds, report.planned_seconds);
    }
    println!(
        "{:.1} frames a second of {} promised, {:.2} % of the refreshes without a new one, {} steps of the governor",
        report.fps,
        report.rate,
        100.0 * report.dropped_share,
        report.changes
    );
    if let Some(growth) = &report.growth {
        let resident = growth.resident_bytes.map_or("unknown".into(), |bytes| format!("{:+.2} MiB", bytes as f64 / f64::from(1 << 20)));
        let (judged, from, device) = (growth.judged_seconds, growth.from_seconds, growth.device_bytes);
        println!(
            "memory in {judged:.0} s from second {from:.0} on, new steps' first minutes left out: process {resident}, device {device:+} bytes"
        );
    }
    if let Some(drift) = &report.drift {
        let db = |error: &crate::measure::bench::report::ErrorReport| error.psnr_db.map_or("no error".into(), |db| format!("{db:.2} dB"));
        let same = if drift.same { "the same to the bit" } else { "not the same to the bit" };
        println!("against the reference: {} before, {} after, {same}", db(&drift.before), db(&drift.after));
    }
    ensure!(report.faults.is_empty(), "{}", report.faults.join("; "));
    Ok(())
}

fn set_against(a: &Path, b: &Path) -> anyhow::Result<()> {
    let read = |path: &Path| {
        let text = std::fs::read_to_string(path).with_context(|| format!("{} can't be read", path.display()))?;
        compare::read(&text).with_context(|| format!("{} can't be compared", path.display()))
    };
    let (lines, differ) = compare::compare(&read(a)?, &read(b)?);
    differ.iter().for_each(|line| println!("note: {line}"));
    println!("  {:26}{:>16}{:>16}{:>12}", "", "first", "second", "change");
    let cell = |value: Option<f64>| value.map_or("–".to_owned(), super::compare::number);
    for line in lines {
        let change = match line.values {
            [Some(a), Some(b)] if a != 0.0 && b != 0.0 => format!("{:.3}×", b / a),
            _ => "–".to_owned(),
        };
        println!("  {:26}{:>16}{:>16}{change:>12}", line.name, cell(line.values[0]), cell(line.values[1]));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amounts_out_of_range_are_refused_with_the_range() {
        assert_eq!((options::minutes("0.5"), options::rate("120")), (Ok(0.5), Ok(120.0)));
        for refused in [options::minutes("0"), options::minutes("NaN"), options::rate("0"), options::rate("fast"), amount("-1")] {
            assert!(refused.is_err_and(|error| error.contains("write a number from")));
        }
    }
}
