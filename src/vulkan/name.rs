//! Names for validation messages and GPU profilers.

use super::device::Gpu;
use ash::vk;
use std::ffi::CString;

impl Gpu {
    /// Gives an object the name that validation messages and GPU profilers show.
    pub fn name<H: vk::Handle + Copy>(&self, object: H, name: &str) {
        let (Some(labels), Ok(name), false) = (&self.labels, CString::new(name), object.as_raw() == 0) else { return };
        let info = vk::DebugUtilsObjectNameInfoEXT::default().object_handle(object).object_name(&name);
        // SAFETY: the object is alive and of this device. A name that can't be set costs nothing.
        let _ = unsafe { labels.set_debug_utils_object_name(&info) };
    }
}
