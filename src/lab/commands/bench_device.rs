//! `effigy-lab bench-device`: what the GPU itself manages, whatever is drawn: bandwidth of copies, and
//! fill rates.

use anyhow::ensure;
use effigy_cli::{
    options::{self, DeviceArgs},
    output::{JSON, Output},
    progress,
};
use effigy_measure::rates::{CopyReport, FillReport, RatesReport, RatesSettings, measure_rates};
use effigy_render::vulkan::Gpu;
use std::time::Duration;

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    device: DeviceArgs,
    /// Width and height of the image that is filled, pixels
    #[arg(long, value_name = "WxH", value_parser = options::size, default_value = "2048x2048")]
    size: [u32; 2],
    /// Largest copy, MiB
    #[arg(long, value_name = "MIB", default_value_t = 256, value_parser = options::count(1, 256))]
    max_copy: usize,
    /// Least time of a measurement, milliseconds
    #[arg(long, value_name = "MS", default_value_t = 20, value_parser = options::count(1, 10_000))]
    min_ms: usize,
    /// Also write the result as JSON
    #[arg(long, value_name = "FILE", value_parser = JSON.parser())]
    json: Option<Output>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let gpu = Gpu::new(&args.device.gpu())?;
    println!("device   {} ({})\n", gpu.probe.name, gpu.probe.driver);
    let settings = RatesSettings {
        size: args.size,
        least: Duration::from_millis(args.min_ms as u64),
        largest: (args.max_copy as u64) << 20,
    };
    let command = std::env::args().collect();
    let bar = progress::items(0, "measurements");
    let mut show = |what: &str, done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        bar.set_message(what.to_owned());
    };
    let mut kept = Ok(());
    // What is measured by then is not lost if the program is stopped.
    let mut keep = |report: &RatesReport| {
        if let (Some(out), Ok(())) = (&args.json, &kept) {
            kept = out.keep_json(report);
        }
        true
    };
    let report = measure_rates(&gpu, &settings, command, &mut show, &mut keep)?;
    bar.finish_and_clear();
    kept?;
    print_copies(&report.copies);
    print_fills(&report.fills, report.fill_size);
    if let Some(out) = &args.json {
        out.write_json(&report)?;
        println!("wrote {}", out.display());
    }
    let wrong = report.copies.iter().filter(|copy| !copy.right).count();
    ensure!(
        wrong == 0,
        "{wrong} kinds of copies differ from what was copied"
    );
    Ok(())
}

fn print_copies(copies: &[CopyReport]) {
    println!("Each copy waits for the one before. Bytes count when read and when written:");
    println!("{:>12} {:>9} {:>12} {:>9}", "bytes", "method", "µs", "GB/s");
    for copy in copies {
        println!(
            "{:>12} {:>9} {:>12.2} {:>9.2}",
            copy.bytes,
            copy.method,
            copy.us,
            copy.bytes_a_second / 1e9
        );
    }
}

fn print_fills(fills: &[FillReport], [width, height]: [u32; 2]) {
    println!("\nLayers over {width} × {height} px:");
    if fills.is_empty() {
        println!("none, since the driver crashes when it draws triangles");
    }
    for fill in fills {
        println!(
            "{:<44} {:>12.1} µs a layer {:>9.3} Gpix/s",
            fill.title(),
            fill.us,
            fill.fragments_a_second / 1e9
        );
    }
}
