//! What there is to say about a device: what it may have, and what was measured of it.

use crate::{advice::NO_TRIANGLES, interrupt::Interrupts, progress};
use ash::{ext, khr};
use effigy::{
    quirks::{OLD_LAVAPIPE, leaves_loops},
    vulkan::{
        Gpu, GpuOptions, Probe, RendererOptions, Result,
        sort::{choice::choose, sort_choice::SortChoice},
        trials,
        tuning::{Record, Tuning},
    },
};
use effigy_core::avatar::motion::Player;

/// Size of the images of the demo that are drawn to measure a device, px.
const DEMO_SIZE: [u32; 2] = [512, 512];

/// Something that a device may have.
pub struct Optional {
    pub name: &'static str,
    pub has: bool,
    /// Effect of having or lacking it.
    pub means: String,
}

/// The optional features, and what Effigy does with or without each.
pub fn optional(probe: &Probe) -> Vec<Optional> {
    let part = |name, has, yes: &str, no: &str| Optional {
        name,
        has,
        means: if has { yes } else { no }.to_string(),
    };
    vec![
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
            "quads, windows, small avatars as they should look",
            &format!(
                "its driver crashes when it draws them with vectors of 512 bits: {NO_TRIANGLES}"
            ),
        ),
        part(
            "long loops",
            !leaves_loops(&probe.driver),
            "tiles",
            OLD_LAVAPIPE,
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
pub fn sort(number: usize, probe: &Probe) -> Option<Result<SortChoice>> {
    if !probe.missing_requirements().is_empty() {
        return None;
    }
    let gpu = Gpu::new(&GpuOptions::headless(Some(number.to_string())));
    Some(gpu.and_then(|gpu| choose(&gpu)))
}

/// What was measured of the ways to draw on a device. Where nothing was, the demo is drawn to
/// measure it if `measures` says so; `keep` gets what is found with each candidate. None where the
/// device can't serve.
pub fn tunings(
    number: usize,
    probe: &Probe,
    measures: bool,
    keep: &mut dyn FnMut(&[Tuning]) -> anyhow::Result<()>,
) -> Option<anyhow::Result<Vec<Tuning>>> {
    if !probe.missing_requirements().is_empty() {
        return None;
    }
    Some(measured(number, measures, keep))
}

fn measured(
    number: usize,
    measures: bool,
    keep: &mut dyn FnMut(&[Tuning]) -> anyhow::Result<()>,
) -> anyhow::Result<Vec<Tuning>> {
    let gpu = Gpu::new(&GpuOptions::headless(Some(number.to_string())))?;
    let record = Record::of_device(&gpu);
    let known = record.tunings();
    let is_known = !known.is_empty() && known.iter().all(Tuning::is_done);
    if is_known || !measures {
        return Ok(known);
    }
    let avatar = effigy_demo::avatar()?;
    let player = Player::new(effigy_demo::clip()?, &avatar.skeleton);
    let bar = progress::open_ended();
    let options = RendererOptions::new(DEMO_SIZE);
    let mut kept = Ok(());
    let tuning = Interrupts::of_trials()?.excuse(&record, |record| {
        let mut show = |candidate: &_| {
            bar.set_message(format!("trying {candidate}"));
            if kept.is_ok() {
                kept = keep(&record.tunings());
            }
        };
        trials::measure(&gpu, record, &avatar, &player, options, &mut show)
    })?;
    bar.finish_and_clear();
    kept?;
    let mut tunings = known;
    tunings.retain(|known| known.workload != tuning.workload);
    tunings.push(tuning);
    Ok(tunings)
}
