//! Times at which a display shows images, requested and reported: `VK_GOOGLE_display_timing`.

use crate::vulkan::device::gpu::Gpu;
use ash::{google, vk};
use std::time::Duration;

/// The display of a swapchain.
pub struct Timing {
    loader: google::display_timing::Device,
    /// Number of the next image that is shown.
    next: u32,
}

/// Feedback of a display. Times are nanoseconds of the system's monotonic clock.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PresentFeedback {
    /// From one refresh to the next.
    pub period: Option<Duration>,
    /// When images were shown, in order, each reported once.
    pub shown: Vec<u64>,
}

impl Timing {
    /// None where the device was opened without it.
    pub fn new(gpu: &Gpu) -> Option<Self> {
        gpu.probe.has_display_timing().then(|| Self {
            loader: google::display_timing::Device::new(&gpu.instance.raw, &gpu.raw),
            next: 0,
        })
    }

    /// The request that goes with the next image: to be shown no earlier than `at`, or as soon as
    /// possible where None.
    pub fn present_time(&mut self, at: Option<u64>) -> vk::PresentTimeGOOGLE {
        self.next = self.next.wrapping_add(1);
        vk::PresentTimeGOOGLE {
            present_id: self.next,
            desired_present_time: at.unwrap_or(0),
        }
    }

    /// Asks the display. Where it answers with an error, the feedback is empty.
    ///
    /// # Safety
    /// The swapchain must be alive and of the device that this was made for.
    pub unsafe fn feedback(&self, swapchain: vk::SwapchainKHR) -> PresentFeedback {
        // SAFETY: the caller promises that the swapchain is alive; its device was opened with the
        // extension.
        let cycle = unsafe { self.loader.get_refresh_cycle_duration(swapchain) };
        // SAFETY: the caller promises that the swapchain is alive; its device was opened with the
        // extension.
        let past = unsafe { self.loader.get_past_presentation_timing(swapchain) };
        let mut shown: Vec<u64> = past
            .unwrap_or_default()
            .iter()
            .map(|past| past.actual_present_time)
            .filter(|&at| at > 0)
            .collect();
        shown.sort_unstable();
        let period = cycle
            .ok()
            .map(|cycle| Duration::from_nanos(cycle.refresh_duration))
            .filter(|period| !period.is_zero());
        PresentFeedback { period, shown }
    }
}
