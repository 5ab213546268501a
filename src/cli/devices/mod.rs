//! `effigy devices`: the features of each GPU, what is missing, and what Effigy would use.

mod facts;
mod json;
mod shaders;

use crate::{
    options::DeviceArgs,
    output::{CSV, JSON, Output},
};
use anyhow::ensure;
use effigy::vulkan::{Error, Probe, instance::Instance, probe::version, tuning::Tuning};
use facts::{optional, sort, tunings};

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Print JSON, or write it to a file with what is known so far as it is found
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-", value_parser = JSON.parser())]
    json: Option<Output>,
    /// Also time ways to draw on CPU drivers beside a GPU, which takes them half a minute and more
    #[arg(long)]
    cpu: bool,
    /// Print what the driver's compiler makes of every shader, in place of the list: instructions,
    /// registers and spills, as the driver counts them
    #[arg(long)]
    shader_stats: bool,
    #[command(flatten)]
    device: DeviceArgs,
    /// Also write the result as comma-separated values
    #[arg(long, value_name = "FILE", requires = "shader_stats", value_parser = CSV.parser())]
    csv: Option<Output>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    if args.shader_stats {
        return shaders::run(&args.device, args.json.as_ref(), args.csv.as_ref());
    }
    ensure!(
        args.device.name.is_none(),
        "--device is for --shader-stats: the list has all devices"
    );
    let instance = Instance::new(false, &[])?;
    let probes = Probe::all(&instance)?;
    let has_gpu = probes
        .iter()
        .any(|probe| !probe.is_cpu() && probe.missing_requirements().is_empty());
    let measures = |probe: &Probe| measures(probe.is_cpu(), has_gpu, args.cpu);
    if let Some(out) = &args.json {
        return json::write(&probes, out, measures);
    }
    if probes.is_empty() {
        return Err(Error::NoDevice.into());
    }
    for (number, probe) in probes.iter().enumerate() {
        print(number, probe, measures(probe));
    }
    Ok(())
}

/// Whether ways to draw on a device are timed. `asked`: for those on CPU drivers.
fn measures(is_cpu: bool, has_gpu: bool, asked: bool) -> bool {
    !is_cpu || !has_gpu || asked
}

/// `measures`: whether ways to draw are timed that nobody timed yet.
fn print(number: usize, probe: &Probe, measures: bool) {
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
    match tunings(number, probe, measures, &mut |_| Ok(())) {
        Some(Ok(tunings)) => {
            for tuning in &tunings {
                print_tuning(tuning);
            }
            if tunings.is_empty() && !measures {
                println!("   drawing          not timed beside a GPU; --cpu times it");
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

fn print_tuning(tuning: &Tuning) {
    println!("   drawing          {}", tuning.workload);
    println!("     {}", tuning.best);
    println!("     {}", tuning.reason());
    for tried in &tuning.tried {
        println!("       {}: {}", tried.candidate, tried.outcome);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cpu_drivers_are_timed_where_there_is_no_gpu_or_they_are_asked_for() {
        let cpu = |has_gpu, asked| measures(true, has_gpu, asked);
        assert!(cpu(false, false) && cpu(true, true) && !cpu(true, false));
        assert!(measures(false, true, false), "a GPU always is");
    }
}
