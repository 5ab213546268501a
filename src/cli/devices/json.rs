//! The list of devices as JSON. What is measured comes after what is known at once, and a file is
//! written with each: it is not lost if the program is stopped.

use super::facts::{Measured, measured, optional};
use crate::output::Output;
use effigy_render::vulkan::{Probe, probe::version};
use serde_json::{Value, json};

/// Writes the devices.
pub fn write(probes: &[Probe], out: &Output) -> anyhow::Result<()> {
    let mut devices: Vec<Value> = probes.iter().map(describe).collect();
    for (number, probe) in probes.iter().enumerate() {
        out.keep_json(&devices)?;
        [devices[number]["sort"], devices[number]["drawing"]] = match measured(number, probe) {
            Some(Ok(Measured { sort, method })) => [json!(sort), json!(method)],
            Some(Err(error)) => [failed(&error), failed(&error)],
            None => [Value::Null, Value::Null],
        };
    }
    out.write_json(&devices)?;
    println!("wrote {}", out.display());
    Ok(())
}

fn failed(error: &impl std::fmt::Display) -> Value {
    json!({ "failed": error.to_string() })
}

/// A device before anything is measured.
fn describe(probe: &Probe) -> Value {
    let optional: serde_json::Map<_, _> = optional(probe)
        .into_iter()
        .map(|part| {
            (
                part.name.into(),
                json!({ "has": part.has, "use": part.means }),
            )
        })
        .collect();
    let limits = &probe.limits;
    json!({
        "name": probe.name,
        "driver": probe.driver,
        "vulkan": version(probe.api_version),
        "device_memory_bytes": probe.device_memory,
        "max_storage_buffer_range": limits.max_storage_buffer_range,
        "max_image_side": limits.max_framebuffer_width.min(limits.max_image_dimension2_d),
        "max_workgroup_invocations": limits.max_compute_work_group_invocations,
        "max_shared_memory_bytes": limits.max_compute_shared_memory_size,
        "subgroup_size": probe.subgroup_size,
        "optional": optional,
        "sort": Value::Null,
        "drawing": Value::Null,
        "missing": probe.missing_requirements(),
    })
}
