//! What a display tells of its refreshes, and is told of when to show an image: `VK_GOOGLE_display_timing`.

use super::{device::Gpu, probe::Probe};
use ash::{google, khr, vk};
use std::{ffi::c_char, time::Duration};

/// Extensions that windows need, and those that they use where they are there.
pub fn extensions(probe: &Probe) -> impl Iterator<Item = *const c_char> {
    let timing = is_used(probe).then_some(google::display_timing::NAME);
    [khr::swapchain::NAME].into_iter().chain(timing).map(std::ffi::CStr::as_ptr)
}

/// Its times are those of the system's monotonic clock, which is known how to be read on Android only. No other windows have it so far.
fn is_used(probe: &Probe) -> bool {
    cfg!(target_os = "android") && probe.has(google::display_timing::NAME)
}

/// The display of a swapchain.
pub struct Timing {
    loader: google::display_timing::Device,
    /// Number of the next image that is shown.
    next: u32,
}

/// What it has told. Times are nanoseconds of the system's monotonic clock.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Told {
    /// From one refresh to the next.
    pub period: Option<Duration>,
    /// When images were shown that it did not tell of before, in order.
    pub shown: Vec<u64>,
}

impl Timing {
    /// None where the device was opened without it.
    pub fn new(gpu: &Gpu) -> Option<Self> {
        is_used(&gpu.probe).then(|| Self { loader: google::display_timing::Device::new(&gpu.instance.raw, &gpu.raw), next: 0 })
    }

    /// What to say with an image that is not to be shown before a time; as soon as can be where None.
    pub fn wish(&mut self, at: Option<u64>) -> vk::PresentTimeGOOGLE {
        self.next = self.next.wrapping_add(1);
        vk::PresentTimeGOOGLE { present_id: self.next, desired_present_time: at.unwrap_or(0) }
    }

    /// Asks it. A display that answers with an error tells nothing.
    pub fn told(&self, swapchain: vk::SwapchainKHR) -> Told {
        // SAFETY: the swapchain is alive and of the device that the functions are of, which was opened with the extension.
        let (cycle, past) =
            unsafe { (self.loader.get_refresh_cycle_duration(swapchain), self.loader.get_past_presentation_timing(swapchain)) };
        let mut shown: Vec<u64> = past.unwrap_or_default().iter().map(|past| past.actual_present_time).filter(|&at| at > 0).collect();
        shown.sort_unstable();
        let period = cycle.ok().map(|cycle| Duration::from_nanos(cycle.refresh_duration)).filter(|period| !period.is_zero());
        Told { period, shown }
    }
}
