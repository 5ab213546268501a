//! `effigy devices`: the features of each GPU, what is missing, and what Effigy would use.

mod shaders;

use crate::{advice::NO_TRIANGLES, options::DeviceArgs, progress};
use anyhow::ensure;
use ash::{ext, khr};
use effigy::vulkan::{
    Error, Gpu, GpuOptions, Probe, RendererOptions, Result,
    instance::Instance,
    probe::version,
    sort::{choice::choose, sort_choice::SortChoice},
    trials,
    tuning::{Record, Tuning},
};
use effigy_core::avatar::motion::Player;
use serde_json::json;
use std::path::PathBuf;

/// Size of the images of the demo that are drawn to measure a device, px.
const DEMO_SIZE: [u32; 2] = [512, 512];

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Print what the driver's compiler makes of every shader, in place of the list: instructions,
    /// registers and spills, as the driver counts them
    #[arg(long)]
    shader_stats: bool,
    #[command(flatten)]
    device: DeviceArgs,
    /// Also write the result as comma-separated values
    #[arg(long, value_name = "FILE", requires = "shader_stats")]
    csv: Option<PathBuf>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    if args.shader_stats {
        return shaders::run(&args.device, args.json, args.csv.as_deref());
    }
    ensure!(
        args.device.name.is_none(),
        "--device is for --shader-stats: the list has all devices"
    );
    let instance = Instance::new(false, &[])?;
    let probes = Probe::all(&instance)?;
    if args.json {
        let devices: Vec<_> = probes
            .iter()
            .enumerate()
            .map(|(number, probe)| describe(number, probe))
            .collect();
        println!("{}", serde_json::to_string_pretty(&devices)?);
        return Ok(());
    }
    if probes.is_empty() {
        return Err(Error::NoDevice.into());
    }
    for (number, probe) in probes.iter().enumerate() {
        print(number, probe);
    }
    Ok(())
}

fn print(number: usize, probe: &Probe) {
    let limits = &probe.limits;
    let image_side = limits
        .max_framebuffer_width
        .min(limits.max_image_dimension2_d);
    println!("{number}: {}", probe.name);
    println!("   driver           {}", probe.driver);
    println!("   Vulkan           {}", version(probe.api_version));
    println!("   memory           {} MiB", probe.device_memory >> 20);
    println!(
        "   largest buffer   {} MiB to a shader",
        limits.max_storage_buffer_range >> 20
    );
    println!("   largest image    {image_side} px a side");
    println!(
        "   workgroups       {} invocations, {} KiB shared",
        limits.max_compute_work_group_invocations,
        limits.max_compute_shared_memory_size >> 10
    );
    for part in optional(probe) {
        let has = if part.has { "yes" } else { "no " };
        println!("   {:16} {has} → {}", part.name, part.means);
    }
    match sort(number, probe) {
        Some(Ok(choice)) => {
            println!(
                "   sort             {} → the fastest that passes the self-test",
                choice.variant.name()
            );
            for tested in &choice.tried {
                println!("     {:14} {}", tested.variant.name(), tested.outcome);
            }
        }
        Some(Err(error)) => println!("   sort             {error}"),
        None => {}
    }
    match tunings(number, probe) {
        Some(Ok(tunings)) => {
            for tuning in &tunings {
                print_tuning(tuning);
            }
        }
        Some(Err(error)) => println!("   drawing          {error}"),
        None => {}
    }
    let missing = probe.missing_requirements();
    if missing.is_empty() {
        println!("   can serve\n");
    } else {
        println!("   can't serve: {}\n", missing.join("; "));
    }
}

/// Something that a device may have.
struct Optional {
    name: &'static str,
    has: bool,
    /// Effect of having or lacking it.
    means: String,
}

/// The optional features, and what Effigy does with or without each.
fn optional(probe: &Probe) -> Vec<Optional> {
    let part = |name, has, yes: &str, no: &str| Optional {
        name,
        has,
        means: if has { yes } else { no }.to_string(),
    };
    vec![
        part(
            "16-bit storage",
            probe.half_storage,
            "f16 storage buffers",
            "f16 unpacked from words, same bytes",
        ),
        part(
            "timestamps",
            probe.timestamp_bits > 0,
            "times of each stage",
            "times of whole frames only",
        ),
        Optional {
            name: "subgroup ballots",
            has: probe.subgroup_ballot,
            means: subgroups(probe),
        },
        part(
            "triangles",
            probe.draws_triangles(),
            "quads, windows, occluders",
            &format!(
                "its driver crashes when it draws them with vectors of 512 bits: {NO_TRIANGLES}"
            ),
        ),
        part(
            "swapchain",
            probe.has(khr::swapchain::NAME),
            "windows",
            "images only",
        ),
        part(
            "shader statistics",
            probe.shader_statistics,
            "`effigy devices --shader-stats` prints them",
            "no way to see what became of shaders",
        ),
        part(
            "calibrated clock",
            probe.clock_extension().is_some(),
            "`--trace` aligns both clocks by it",
            "`--trace` aligns both clocks by timestamps that it waits for",
        ),
        part(
            "performance query",
            probe.has(khr::performance_query::NAME),
            "profilers may read its counters; nothing here does",
            "profilers have counters of their own or none",
        ),
        part(
            "memory budget",
            probe.has(ext::memory_budget::NAME),
            "reported by the driver",
            "own count only",
        ),
    ]
}

/// Whether the device can sort with subgroups, and their sizes.
fn subgroups(probe: &Probe) -> String {
    let sorts = if probe.subgroup_ballot {
        "OneSweep may sort"
    } else {
        "sorts without"
    };
    let size = probe.subgroup_size;
    match probe.subgroup_sizes {
        Some([low, high]) => format!("{sorts} (subgroups of {size}; {low} to {high} on request)"),
        None => format!("{sorts} (subgroups of {size})"),
    }
}

/// The self-test's choice of the sort variant, from its record or by running it. None where the
/// device can't serve.
fn sort(number: usize, probe: &Probe) -> Option<Result<SortChoice>> {
    if !probe.missing_requirements().is_empty() {
        return None;
    }
    let gpu = Gpu::new(&GpuOptions::headless(Some(number.to_string())));
    Some(gpu.and_then(|gpu| choose(&gpu)))
}

/// What was measured of the ways to draw on a device. Where nothing was, the demo is drawn to
/// measure it. None where the device can't serve.
fn tunings(number: usize, probe: &Probe) -> Option<anyhow::Result<Vec<Tuning>>> {
    if !probe.missing_requirements().is_empty() {
        return None;
    }
    Some(measured(number))
}

fn measured(number: usize) -> anyhow::Result<Vec<Tuning>> {
    let gpu = Gpu::new(&GpuOptions::headless(Some(number.to_string())))?;
    let known = Record::of_device(&gpu).tunings();
    if !known.is_empty() && known.iter().all(Tuning::is_done) {
        return Ok(known);
    }
    let avatar = effigy_demo::avatar()?;
    let player = Player::new(effigy_demo::clip()?, &avatar.skeleton);
    let bar = progress::tuning();
    let options = RendererOptions::new(DEMO_SIZE);
    let tuning = trials::measure(&gpu, &avatar, &player, options, &mut |candidate| {
        bar.set_message(format!("trying {candidate}"));
    })?;
    bar.finish_and_clear();
    let mut tunings = known;
    tunings.retain(|known| known.workload != tuning.workload);
    tunings.push(tuning);
    Ok(tunings)
}

fn print_tuning(tuning: &Tuning) {
    println!("   drawing          {}", tuning.workload);
    println!("     {}", tuning.best);
    println!("     {}", tuning.reason());
    for tried in &tuning.tried {
        println!("       {}: {}", tried.candidate, tried.outcome);
    }
}

/// A device as JSON.
fn describe(number: usize, probe: &Probe) -> serde_json::Value {
    let optional: serde_json::Map<_, _> = optional(probe)
        .into_iter()
        .map(|part| {
            (
                part.name.into(),
                json!({ "has": part.has, "use": part.means }),
            )
        })
        .collect();
    let sort = sort(number, probe).map(|choice| match choice {
        Ok(choice) => json!(choice),
        Err(error) => json!({ "failed": error.to_string() }),
    });
    let drawing = tunings(number, probe).map(|tunings| match tunings {
        Ok(tunings) => json!(tunings),
        Err(error) => json!({ "failed": error.to_string() }),
    });
    json!({
        "name": probe.name,
        "driver": probe.driver,
        "vulkan": version(probe.api_version),
        "device_memory_bytes": probe.device_memory,
        "max_storage_buffer_range": probe.limits.max_storage_buffer_range,
        "max_image_side": probe.limits.max_framebuffer_width.min(probe.limits.max_image_dimension2_d),
        "max_workgroup_invocations": probe.limits.max_compute_work_group_invocations,
        "max_shared_memory_bytes": probe.limits.max_compute_shared_memory_size,
        "subgroup_size": probe.subgroup_size,
        "optional": optional,
        "sort": sort,
        "drawing": drawing,
        "missing": probe.missing_requirements(),
    })
}
