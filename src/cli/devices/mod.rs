//! `effigy devices`: the features of each GPU, what is missing, and what Effigy would use.

mod facts;
mod json;

use crate::{
    interrupt::Interrupts,
    output::{JSON, Output},
};
use effigy_render::vulkan::{Error, Probe, instance::Instance, probe::version};
use facts::{Measured, measured, optional};

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Print JSON, or write it to a file with what is known so far as it is found
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-", value_parser = JSON.parser())]
    json: Option<Output>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let instance = Instance::new(false, &[])?;
    let probes = Probe::all(&instance)?;
    // Ctrl-C may come while something is measured.
    Interrupts::excuse_trials()?;
    if let Some(out) = &args.json {
        return json::write(&probes, out);
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
    match measured(number, probe) {
        Some(Ok(Measured { sort, method })) => {
            let name = sort.variant.name();
            println!("   sort             {name} → the fastest that passes the self-test");
            for tried in &sort.tried {
                println!("     {:14} {}", tried.variant.name(), tried.outcome);
            }
            let name = method.method.name();
            println!("   drawing          {name} → {}", method.reason());
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
