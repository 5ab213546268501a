//! SPIR-V goes in, the same shader in WGSL comes out.

use anyhow::Context;
use naga::{
    AddressSpace, StorageAccess,
    back::wgsl::{self, WriterFlags},
    front::spv,
    valid::{Capabilities, GlobalUse, ValidationFlags, Validator},
};

/// Rewrites a module with one entry point.
pub fn translate(spirv: &[u8]) -> anyhow::Result<String> {
    let mut module = spv::parse_u8_slice(spirv, &spv::Options::default())?;
    let validate = |module: &naga::Module| {
        let info = Validator::new(ValidationFlags::all(), Capabilities::SHADER_FLOAT16_IN_FLOAT32).validate(module);
        info.map_err(|error| anyhow::anyhow!(error.emit_to_string("")))
    };
    // What WebGPU has no word for.
    for (_, variable) in module.global_variables.iter_mut() {
        if let AddressSpace::Storage { access } = &mut variable.space {
            *access = StorageAccess::LOAD | StorageAccess::STORE;
        }
    }
    let info = validate(&module)?;
    let used = info.get_entry_point(0);
    // Vertex shaders may not see what they could write, and barriers may not depend on it; SPIR-V says of both only that they don't.
    for (handle, variable) in module.global_variables.iter_mut() {
        if let AddressSpace::Storage { access } = &mut variable.space
            && !used[handle].intersects(GlobalUse::WRITE | GlobalUse::ATOMIC)
        {
            *access = StorageAccess::LOAD;
        }
    }
    let info = validate(&module)?;
    wgsl::write_string(&module, &info, WriterFlags::empty()).context("naga can't write it as WGSL")
}
