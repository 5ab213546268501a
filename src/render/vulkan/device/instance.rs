//! The Vulkan instance, with validation where it was asked for and debug names where the loader has
//! them.

use super::error::{During, Error, Result};
use ash::{ext, khr, vk};
use std::{
    ffi::{CStr, c_void},
    sync::atomic::{AtomicU32, Ordering},
};

/// Warnings and errors that the validation layer reported in this process.
static VALIDATION_MESSAGES: AtomicU32 = AtomicU32::new(0);

/// How many warnings and errors the validation layer has reported since the program started. Tests
/// expect none.
pub fn validation_messages() -> u32 {
    VALIDATION_MESSAGES.load(Ordering::Relaxed)
}

const VALIDATION: &CStr = c"VK_LAYER_KHRONOS_validation";

/// A Vulkan 1.1 instance. Destroyed when dropped, after everything made from it.
pub struct Instance {
    /// The Vulkan loader.
    pub(crate) entry: ash::Entry,
    /// The instance's functions and handle.
    pub(crate) raw: ash::Instance,
    messenger: Option<(ext::debug_utils::Instance, vk::DebugUtilsMessengerEXT)>,
    /// Whether objects can be named and commands labelled.
    pub(crate) debug_utils: bool,
}

impl Instance {
    /// `surface` names the extensions that a window's surface needs.
    pub fn new(validation: bool, surface: &[&CStr]) -> Result<Self> {
        // SAFETY: the loader is a library of the system's; its initialisers are as trusted as the
        // driver itself.
        let entry =
            unsafe { ash::Entry::load() }.map_err(|error| Error::NoLoader(error.to_string()))?;
        // SAFETY: no pointers are passed in.
        let available = unsafe { entry.enumerate_instance_extension_properties(None) }
            .during("vkEnumerateInstanceExtensionProperties")?;
        let has = |name: &CStr| {
            available
                .iter()
                .any(|e| e.extension_name_as_c_str() == Ok(name))
        };
        let debug_utils = validation || has(ext::debug_utils::NAME);
        let mut extensions: Vec<_> = surface.iter().map(|name| name.as_ptr()).collect();
        if debug_utils {
            extensions.push(ext::debug_utils::NAME.as_ptr());
        }
        let portable = has(khr::portability_enumeration::NAME);
        if portable {
            extensions.push(khr::portability_enumeration::NAME.as_ptr());
        }
        let layers = if validation {
            vec![VALIDATION.as_ptr()]
        } else {
            vec![]
        };
        if validation && !has_layer(&entry)? {
            return Err(Error::NoValidation);
        }
        let application = vk::ApplicationInfo::default()
            .application_name(c"effigy")
            .engine_name(c"effigy")
            .api_version(vk::API_VERSION_1_1);
        let sync = [vk::ValidationFeatureEnableEXT::SYNCHRONIZATION_VALIDATION];
        let mut features = vk::ValidationFeaturesEXT::default().enabled_validation_features(&sync);
        let mut messages = messenger_info();
        let mut info = vk::InstanceCreateInfo::default()
            .application_info(&application)
            .enabled_extension_names(&extensions)
            .enabled_layer_names(&layers);
        if portable {
            info = info.flags(vk::InstanceCreateFlags::ENUMERATE_PORTABILITY_KHR);
        }
        if validation {
            info = info.push_next(&mut features).push_next(&mut messages);
        }
        // SAFETY: `info` and all it points to outlive the call.
        let raw = match unsafe { entry.create_instance(&info, None) } {
            Err(vk::Result::ERROR_INCOMPATIBLE_DRIVER) => return Err(Error::NoDevice),
            created => created.during("vkCreateInstance")?,
        };
        let messenger = if validation {
            let loader = ext::debug_utils::Instance::new(&entry, &raw);
            // SAFETY: the callback is a function of this program and takes no user data.
            let messenger = unsafe { loader.create_debug_utils_messenger(&messenger_info(), None) }
                .during("vkCreateDebugUtilsMessengerEXT")?;
            Some((loader, messenger))
        } else {
            None
        };
        Ok(Self {
            entry,
            raw,
            messenger,
            debug_utils,
        })
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        // SAFETY: everything made from the instance holds a reference to it, so nothing is left.
        unsafe {
            if let Some((loader, messenger)) = &self.messenger {
                loader.destroy_debug_utils_messenger(*messenger, None);
            }
            self.raw.destroy_instance(None);
        }
    }
}

fn has_layer(entry: &ash::Entry) -> Result<bool> {
    // SAFETY: no pointers are passed in.
    let layers = unsafe { entry.enumerate_instance_layer_properties() }
        .during("vkEnumerateInstanceLayerProperties")?;
    Ok(layers
        .iter()
        .any(|layer| layer.layer_name_as_c_str() == Ok(VALIDATION)))
}

fn messenger_info() -> vk::DebugUtilsMessengerCreateInfoEXT<'static> {
    vk::DebugUtilsMessengerCreateInfoEXT::default()
        .message_severity(
            vk::DebugUtilsMessageSeverityFlagsEXT::WARNING
                | vk::DebugUtilsMessageSeverityFlagsEXT::ERROR,
        )
        .message_type(vk::DebugUtilsMessageTypeFlagsEXT::VALIDATION)
        .pfn_user_callback(Some(report))
}

/// A function that nothing of this program asks for: with NVIDIA's driver 580 and the loader
/// 1.3.239 the layer reports a call of vkGetDeviceProcAddr for it within vkCreateDevice.
const NOT_ASKED_FOR: &str = "vkGetPhysicalDeviceVideoEncodeQualityLevelPropertiesKHR";

/// Counts and prints what the validation layer says of this program's calls.
unsafe extern "system" fn report(
    _severity: vk::DebugUtilsMessageSeverityFlagsEXT,
    _kind: vk::DebugUtilsMessageTypeFlagsEXT,
    data: *const vk::DebugUtilsMessengerCallbackDataEXT,
    _user: *mut c_void,
) -> vk::Bool32 {
    // SAFETY: the layer passes a valid structure and string for the time of the call.
    let message = unsafe { data.as_ref().and_then(|data| data.message_as_c_str()) };
    let message = message.map_or("(no text)".into(), CStr::to_string_lossy);
    if !message.contains(NOT_ASKED_FOR) {
        VALIDATION_MESSAGES.fetch_add(1, Ordering::Relaxed);
        eprintln!("validation: {message}");
    }
    vk::FALSE
}
