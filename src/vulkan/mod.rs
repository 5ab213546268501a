//! The stages on the GPU, on Vulkan 1.1 and what each device has beyond it.

pub mod shaders;
