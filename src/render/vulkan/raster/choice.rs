//! Which method draws where the options leave it open: that of the device's class, or its rival if
//! frames of both were measured and it was faster ([`question`](crate::vulkan::question)).

use crate::{
    quirks::leaves_loops,
    vulkan::{
        device::{
            gpu::Gpu,
            probe::Probe,
            trial::{Record, TrialOutcome, Tried},
        },
        pipeline::shaders,
    },
};
use ash::vk;
use effigy_core::frame::RasterMethod;
use serde::Serialize;
use std::path::Path;

/// The rival draws if its frames take less than this of those of the class's method.
const FASTER: f64 = 0.9;

/// The method to draw with, and why.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MethodChoice {
    /// The method.
    pub method: RasterMethod,
    /// That of the device's class.
    pub class: RasterMethod,
    /// What came of the two, if they were measured.
    pub tried: Vec<Tried<RasterMethod>>,
}

impl MethodChoice {
    /// What is known of a device.
    pub fn of(gpu: &Gpu) -> Self {
        Self::in_folder(gpu, gpu.cache_folder())
    }

    /// [`Self::of`], with the record in `folder`.
    pub fn in_folder(gpu: &Gpu, folder: Option<&Path>) -> Self {
        Self::new(class_method(&gpu.probe), record(gpu, folder).read())
    }

    pub(crate) fn new(class: RasterMethod, tried: Vec<Tried<RasterMethod>>) -> Self {
        let ms_of = |method| Tried::ms_of(&tried, method);
        let is_faster = |method: &RasterMethod| {
            let ms = ms_of(*method).zip(ms_of(class));
            ms.is_some_and(|(rival, own)| rival < FASTER * own)
        };
        let faster = RasterMethod::ALL.into_iter().find(is_faster);
        Self {
            method: faster.unwrap_or(class),
            class,
            tried,
        }
    }

    /// Whether it is another method than the class's.
    pub fn is_rival(&self) -> bool {
        self.method != self.class
    }

    /// Why it is this method, in a few words.
    pub fn reason(&self) -> String {
        let other = self.tried.iter().find(|tried| tried.variant != self.method);
        let Some(Tried { variant, outcome }) = other else {
            return "as suits this class of device".into();
        };
        let name = variant.name();
        match (outcome, Tried::ms_of(&self.tried, self.method)) {
            (TrialOutcome::Right(ms), Some(own)) => {
                format!("{own:.2} ms a frame when measured, {name} {ms:.2}")
            }
            (outcome, _) => format!("{name} was tried: {outcome}"),
        }
    }
}

/// The record of what was measured.
pub(crate) fn record(gpu: &Gpu, folder: Option<&Path>) -> Record<RasterMethod> {
    Record::new(gpu, folder, "raster", shaders::all_hash())
}

/// Has nothing draw with a method that was measured to be faster and failed later.
pub(crate) fn strike_off(gpu: &Gpu, method: RasterMethod, why: &str) {
    let name = method.name();
    tracing::warn!("{name} failed, and is not used any more: {why}");
    record(gpu, gpu.cache_folder()).write(&[Tried {
        variant: method,
        outcome: TrialOutcome::Refused(why.to_owned()),
    }]);
}

/// The method for the class of device that one is of; what it can't run gives way to another.
pub(crate) fn class_method(probe: &Probe) -> RasterMethod {
    use RasterMethod::{CooperativeTiles, Quads, SharedTiles};
    let preferred = if !probe.is_cpu() {
        if is_desktop(probe.kind, probe.vendor) {
            [SharedTiles, Quads, CooperativeTiles]
        } else {
            [Quads, SharedTiles, CooperativeTiles]
        }
    } else if leaves_loops(&probe.driver) {
        [Quads, CooperativeTiles, SharedTiles]
    } else {
        [CooperativeTiles, Quads, SharedTiles]
    };
    let can = |method: &RasterMethod| probe.lacks_for(*method).is_none();
    preferred.into_iter().find(can).unwrap_or(Quads)
}

/// The method that a GPU may draw faster with than with its class's. None on CPU drivers, where
/// measuring takes the processor from what is drawn, and where there is no other.
pub fn rival(probe: &Probe) -> Option<RasterMethod> {
    let rival = match class_method(probe) {
        RasterMethod::Quads => RasterMethod::SharedTiles,
        RasterMethod::SharedTiles => RasterMethod::Quads,
        RasterMethod::CooperativeTiles => return None,
    };
    let can = !probe.is_cpu() && probe.lacks_for(rival).is_none();
    can.then_some(rival)
}

/// Whether a GPU is no phone's: those blend in tile memory, and quads suit them. On an H200 quads
/// take ten times as long as tiles (docs/gpu). `vendor`: its PCI number.
fn is_desktop(kind: vk::PhysicalDeviceType, vendor: u32) -> bool {
    const AMD: u32 = 0x1002;
    const NVIDIA: u32 = 0x10de;
    const INTEL: u32 = 0x8086;
    kind == vk::PhysicalDeviceType::DISCRETE_GPU || [AMD, NVIDIA, INTEL].contains(&vendor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phones_alone_are_not_desktops() {
        use vk::PhysicalDeviceType as Kind;
        for (kind, vendor, expected) in [
            (Kind::DISCRETE_GPU, 0x10de, true),
            (Kind::DISCRETE_GPU, 0, true),
            (Kind::INTEGRATED_GPU, 0x8086, true),
            (Kind::VIRTUAL_GPU, 0x10de, true),
            // Adreno, Mali and Apple.
            (Kind::INTEGRATED_GPU, 0x5143, false),
            (Kind::INTEGRATED_GPU, 0x13b5, false),
            (Kind::INTEGRATED_GPU, 0x106b, false),
        ] {
            assert_eq!(is_desktop(kind, vendor), expected, "{kind:?} {vendor:#x}");
        }
    }

    #[test]
    fn a_rival_draws_if_it_is_right_and_a_tenth_faster() {
        use RasterMethod::{Quads, SharedTiles};
        let refused = || TrialOutcome::Refused("its image is wrong".into());
        for (tiles, rival, expected) in [
            (TrialOutcome::Right(10.0), TrialOutcome::Right(8.9), Quads),
            (
                TrialOutcome::Right(10.0),
                TrialOutcome::Right(9.1),
                SharedTiles,
            ),
            (TrialOutcome::Right(10.0), refused(), SharedTiles),
            (refused(), TrialOutcome::Right(1.0), SharedTiles),
            (
                TrialOutcome::Right(10.0),
                TrialOutcome::Unfinished,
                SharedTiles,
            ),
        ] {
            let tried = [(SharedTiles, tiles), (Quads, rival)].map(Tried::from);
            let choice = MethodChoice::new(SharedTiles, tried.into());
            assert_eq!(choice.method, expected, "{choice:?}");
        }
        let unmeasured = MethodChoice::new(Quads, Vec::new());
        assert_eq!(unmeasured.method, Quads);
        assert!(!unmeasured.is_rival());
    }
}
