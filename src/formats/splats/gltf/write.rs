//! Writing of a `.glb`: all numbers as f32, and colours for viewers that draw the points.

use super::EXTENSION;
use crate::splats::logit;
use effigy_core::io::splats::{Splats, Up, functions_of};
use serde_json::{Value, json};

const FLOAT: u32 = 5126;
const UNSIGNED_BYTE: u32 = 5121;

/// The attributes' bytes, and what the document says of them.
#[derive(Default)]
struct AttributeBytes {
    binary: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    attributes: serde_json::Map<String, Value>,
}

impl AttributeBytes {
    fn add(&mut self, name: &str, bytes: Vec<u8>, mut accessor: Value) {
        let index = self.views.len();
        self.views.push(json!({
            "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len(), "target": 34962,
        }));
        self.binary.extend(bytes);
        accessor["bufferView"] = index.into();
        self.accessors.push(accessor);
        self.attributes.insert(name.into(), index.into());
    }

    fn floats<const N: usize>(
        &mut self,
        name: &str,
        rows: impl ExactSizeIterator<Item = [f32; N]>,
    ) {
        let shape = ["SCALAR", "VEC2", "VEC3", "VEC4"][N - 1];
        let accessor = json!({"componentType": FLOAT, "count": rows.len(), "type": shape});
        let bytes = rows.flatten().flat_map(f32::to_le_bytes).collect();
        self.add(name, bytes, accessor);
    }
}

/// The bytes of a file, with y up.
pub fn write(splats: Splats) -> Vec<u8> {
    let splats = splats.with_up(Up::Y);
    let mut parts = AttributeBytes::default();
    parts.floats("POSITION", splats.position.iter().copied());
    let [mut min, mut max] = [splats.position[0]; 2];
    for position in &splats.position {
        for k in 0..3 {
            min[k] = min[k].min(position[k]);
            max[k] = max[k].max(position[k]);
        }
    }
    parts.accessors[0]["min"] = json!(min);
    parts.accessors[0]["max"] = json!(max);
    let of = |name: &str| format!("{EXTENSION}:{name}");
    let unit = |[w, x, y, z]: [f32; 4]| {
        let q = [x, y, z, w].map(f64::from);
        let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
        q.map(|v| (v / length) as f32)
    };
    parts.floats(&of("ROTATION"), splats.rotation.iter().map(|&q| unit(q)));
    let deviations = splats.log_scale.iter().map(|row| row.map(f32::exp));
    parts.floats(&of("SCALE"), deviations);
    let opacities = splats.opacity.iter().map(|&o| [logit::to_part(o)]);
    parts.floats(&of("OPACITY"), opacities);
    parts.floats(&of("SH_DEGREE_0_COEF_0"), splats.color.iter().copied());
    let functions = functions_of(splats.degree);
    for degree in 1..=splats.degree {
        for k in 0..2 * degree + 1 {
            let function = functions_of(degree - 1) + k;
            let rows = (0..splats.len()).map(|g| splats.harmonics[functions * g + function]);
            parts.floats(&of(&format!("SH_DEGREE_{degree}_COEF_{k}")), rows);
        }
    }
    // The points' colours are linear, other than the splats'.
    let colors = splats.color.iter().zip(&splats.opacity);
    let colors = colors.flat_map(|(color, &opacity)| {
        let [r, g, b] = color.map(|c| linear_byte(logit::color_to_byte(c)));
        [r, g, b, logit::to_byte(opacity)]
    });
    let colors = colors.collect();
    let accessor = json!({
        "componentType": UNSIGNED_BYTE, "normalized": true, "count": splats.len(), "type": "VEC4",
    });
    parts.add("COLOR_0", colors, accessor);
    let document = json!({
        "asset": {"version": "2.0", "generator": "Effigy"},
        "extensionsUsed": [EXTENSION],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{
            "mode": 0,
            "attributes": parts.attributes,
            "extensions": {EXTENSION: {
                "kernel": "ellipse",
                "colorSpace": "srgb_rec709_display",
                "sortingMethod": "cameraDistance",
                "projection": "perspective",
            }},
        }]}],
        "buffers": [{"byteLength": parts.binary.len()}],
        "bufferViews": parts.views,
        "accessors": parts.accessors,
    });
    glb(document.to_string().into_bytes(), parts.binary)
}

/// Joins document and numbers.
fn glb(mut document: Vec<u8>, binary: Vec<u8>) -> Vec<u8> {
    document.resize(document.len().next_multiple_of(4), b' ');
    let word = |length: usize| (length as u32).to_le_bytes();
    let total = 12 + 8 + document.len() + 8 + binary.len();
    let mut bytes = Vec::with_capacity(total);
    bytes.extend(b"glTF");
    bytes.extend(word(2));
    bytes.extend(word(total));
    bytes.extend(word(document.len()));
    bytes.extend(b"JSON");
    bytes.extend(document);
    bytes.extend(word(binary.len()));
    bytes.extend(b"BIN\0");
    bytes.extend(binary);
    bytes
}

/// A byte of sRGB as a byte of light.
fn linear_byte(byte: u8) -> u8 {
    let value = f64::from(byte) / 255.0;
    let linear = if value <= 0.040_45 {
        value / 12.92
    } else {
        ((value + 0.055) / 1.055).powf(2.4)
    };
    (255.0 * linear).round() as u8
}
