//! What there is to say about a device: what it may have, and what was measured of it.

use crate::{advice::NO_TRIANGLES, progress};
use ash::{ext, khr};
use effigy_core::avatar::motion::Player;
use effigy_render::{
    quirks::{OLD_LAVAPIPE, leaves_loops},
    vulkan::{
        Gpu, Probe, RendererOptions,
        question::{Question, QuestionScene},
        raster::choice::MethodChoice,
        sort::choice::choose,
        trial::SortChoice,
    },
};

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
            "`effigy-lab shader-stats` prints them",
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

/// What was measured of a device.
pub struct Measured {
    /// The variant of the sort.
    pub sort: SortChoice,
    /// The method that draws.
    pub method: MethodChoice,
}

/// What was measured of a device, after measuring it by the demo where nobody has. None where the
/// device can't serve.
pub fn measured(number: usize, probe: &Probe) -> Option<anyhow::Result<Measured>> {
    let serves = probe.missing_requirements().is_empty();
    serves.then(|| measure(number))
}

fn measure(number: usize) -> anyhow::Result<Measured> {
    let gpu = Gpu::new(&effigy_runtime::cache::headless(Some(number.to_string())))?;
    let sort = choose(&gpu)?;
    let options = RendererOptions::new(DEMO_SIZE);
    if !Question::is_open(&gpu, &options) {
        let method = MethodChoice::of(&gpu);
        return Ok(Measured { sort, method });
    }
    let avatar = effigy_demo::avatar()?;
    let player = Player::new(effigy_demo::clip()?, &avatar.skeleton);
    let question = Question {
        avatar: &avatar,
        options,
        scenes: &QuestionScene::of_clip(&avatar, &player, options.size),
    };
    let bar = progress::open_ended();
    bar.set_message("comparing quads and tiles");
    let method = question.ask(&gpu)?;
    bar.finish_and_clear();
    Ok(Measured { sort, method })
}
