//! `effigy devices`: what each GPU has, lacks and would use.

mod shaders;

use crate::vulkan::{
    Gpu, GpuOptions, Probe, Result,
    instance::Instance,
    probe::version,
    sort::{choice::choose, verdict::Verdict},
};
use anyhow::Context;
use serde_json::json;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Print what a device's driver makes of every shader, in place of the list: instructions, registers, spills, as the driver counts
    #[arg(long)]
    shader_stats: bool,
    /// GPU whose driver is asked: part of its name, or its number in the list [default: the first that can serve]
    #[arg(long, value_name = "NAME", requires = "shader_stats")]
    device: Option<String>,
    /// Write the statistics as comma-separated values too
    #[arg(long, value_name = "FILE", requires = "shader_stats")]
    csv: Option<PathBuf>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    if args.shader_stats {
        return shaders::run(args.device, args.json, args.csv.as_deref());
    }
    let instance = Instance::new(false, &[])?;
    let probes = Probe::all(&instance)?;
    if args.json {
        let devices: Vec<_> = probes.iter().enumerate().map(|(number, probe)| describe(number, probe)).collect();
        println!("{}", serde_json::to_string_pretty(&devices)?);
        return Ok(());
    }
    probes.first().context("no Vulkan device on this machine: install your GPU's driver, or the CPU driver mesa-vulkan-drivers")?;
    for (number, probe) in probes.iter().enumerate() {
        print(number, probe);
    }
    Ok(())
}

fn print(number: usize, probe: &Probe) {
    let limits = &probe.limits;
    println!("{number}: {}", probe.name);
    println!("   driver           {}", probe.driver);
    println!("   Vulkan           {}", version(probe.api_version));
    println!("   memory           {} MiB", probe.device_memory >> 20);
    println!("   largest buffer   {} MiB to a shader", limits.max_storage_buffer_range >> 20);
    println!("   largest picture  {} px a side", limits.max_framebuffer_width.min(limits.max_image_dimension2_d));
    println!(
        "   workgroups       {} invocations, {} KiB shared",
        limits.max_compute_work_group_invocations,
        limits.max_compute_shared_memory_size >> 10
    );
    for (what, has, use_) in probe.optional() {
        println!("   {what:16} {} → {use_}", if has { "yes" } else { "no " });
    }
    match sort(number, probe) {
        Some(Ok(verdict)) => {
            println!("   sort             {} → the fastest that a test found right", verdict.variant.name());
            verdict.tried.iter().for_each(|(variant, outcome)| println!("     {:14} {outcome}", variant.name()));
        }
        Some(Err(error)) => println!("   sort             {error}"),
        None => (),
    }
    match probe.lacks().as_slice() {
        [] => println!("   can serve\n"),
        lacks => println!("   can't serve: {}\n", lacks.join("; ")),
    }
}

/// How to sort on a device, from a test where this program has not seen it yet. None where it can't serve.
fn sort(number: usize, probe: &Probe) -> Option<Result<Verdict>> {
    probe.lacks().is_empty().then(|| choose(&Gpu::new(&GpuOptions::headless(Some(number.to_string())))?))
}

fn describe(number: usize, probe: &Probe) -> serde_json::Value {
    let optional: serde_json::Map<_, _> =
        probe.optional().into_iter().map(|(what, has, use_)| (what.into(), json!({ "has": has, "use": use_ }))).collect();
    json!({
        "name": probe.name,
        "driver": probe.driver,
        "vulkan": version(probe.api_version),
        "device_memory_bytes": probe.device_memory,
        "max_storage_buffer_range": probe.limits.max_storage_buffer_range,
        "max_picture_side": probe.limits.max_framebuffer_width.min(probe.limits.max_image_dimension2_d),
        "max_workgroup_invocations": probe.limits.max_compute_work_group_invocations,
        "max_shared_memory_bytes": probe.limits.max_compute_shared_memory_size,
        "subgroup_size": probe.subgroup_size,
        "optional": optional,
        "sort": sort(number, probe).map(|verdict| verdict.map_or_else(|error| json!({ "failed": error.to_string() }), |verdict| json!(verdict))),
        "lacks": probe.lacks(),
    })
}
