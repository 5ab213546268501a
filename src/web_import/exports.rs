//! What JavaScript calls.

use crate::{body::SkinnedBody, import};
use wasm_bindgen::prelude::*;

/// A file of another program as one of Effigy's own.
#[wasm_bindgen]
pub struct Imported {
    bytes: Vec<u8>,
    is_splats: bool,
    notes: Vec<String>,
}

#[wasm_bindgen]
impl Imported {
    /// Takes the bytes of the `.avatar` or the `.motion`.
    pub fn take_bytes(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.bytes)
    }

    /// Whether the bytes are splats, for `AvatarCanvas.prepare_splats`.
    pub fn is_splats(&self) -> bool {
        self.is_splats
    }

    /// Takes what the file left open, a line each.
    pub fn take_notes(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notes)
    }
}

fn js_error(error: impl std::fmt::Display) -> JsValue {
    js_sys::Error::new(&error.to_string()).into()
}

/// What a file of another program is: "avatar", "motion" or "unknown".
#[wasm_bindgen]
pub fn kind(bytes: &[u8], name: &str) -> String {
    import::kind(bytes, name).into()
}

/// Reads an avatar of another program.
#[wasm_bindgen]
pub fn import_avatar(bytes: &[u8], name: &str) -> Result<Imported, JsValue> {
    let avatar = import::avatar(bytes, name).map_err(js_error)?;
    Ok(Imported {
        bytes: avatar.bytes,
        is_splats: avatar.is_splats,
        notes: avatar.notes,
    })
}

/// Reads motion of another program. `skeleton` and `skin`: what the main library says of the avatar
/// that it is for.
#[wasm_bindgen]
pub fn import_motion(
    bytes: &[u8],
    name: &str,
    skeleton: &str,
    skin: &[u8],
) -> Result<Imported, JsValue> {
    let body = SkinnedBody::new(skeleton, skin).map_err(js_error)?;
    let motion = import::motion(bytes, name, &body).map_err(js_error)?;
    Ok(Imported {
        bytes: motion.bytes,
        is_splats: false,
        notes: motion.notes,
    })
}
