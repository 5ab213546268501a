//! The constants that shaders see as macros, so that no number stands both in Rust and in GLSL.

use super::{
    binning::TILING,
    compact::{NODE_BITS_MIN, QUATERNION_STEPS},
    gpu::*,
    train::*,
};
use crate::{
    avatar::limits,
    constants::{
        ALPHA_MAX, DETAIL_COARSEST, F16_MAX, FACING_FADE, FACING_STEPS, FEATURE_MAX, LOG_SCALE_MAX,
        ROTATION_MIN, VARIANCE_MAX,
    },
};

/// Value of a macro.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MacroValue {
    /// A `uint`.
    Uint(u32),
    /// A `float`: shaders see the nearest f32.
    Float(f64),
}

impl MacroValue {
    /// The value as a GLSL literal.
    pub fn glsl(self) -> String {
        match self {
            Self::Uint(value) => format!("{value}u"),
            // Rust writes the shortest text that reads back as this number, always with a point or
            // an exponent.
            Self::Float(value) => format!("{value:?}"),
        }
    }
}

use MacroValue::{Float, Uint};

/// Name and value of each constant that shaders see as a macro.
pub const MACROS: &[(&str, MacroValue)] = &[
    ("MLP_WORKGROUP", Uint(MLP_WORKGROUP)),
    ("SH_WORKGROUP", Uint(SH_WORKGROUP)),
    ("PROJECT_WORKGROUP", Uint(PROJECT_WORKGROUP)),
    ("SORT_WORKGROUP", Uint(SORT_WORKGROUP)),
    ("SORT_TILE", Uint(SORT_TILE)),
    ("SORT_RUNS", Uint(SORT_RUNS)),
    ("SORT_ONESWEEP_TILE", Uint(SORT_ONESWEEP_TILE)),
    ("SORT_GROUP", Uint(SORT_GROUP)),
    ("SORT_POLLS", Uint(SORT_POLLS)),
    ("SORT_STATE", Uint(SORT_STATE)),
    ("SORT_FALLBACKS", Uint(SORT_FALLBACKS)),
    ("SORT_DIGITS", Uint(SORT_DIGITS)),
    ("SORT_CULLED", Uint(SORT_CULLED)),
    ("QUADS_PER_INSTANCE", Uint(QUADS_PER_INSTANCE)),
    ("GAUSSIAN_PAIRS", Uint(GAUSSIAN_PAIRS)),
    ("BLOCK_PAIRS", Uint(BLOCK_PAIRS)),
    ("PART_BITS", Uint(PART_BITS as u32)),
    ("TILES_PER_SIDE", Uint(TILING.tiles_per_side)),
    ("TILE_COUNT", Uint(TILING.tiles())),
    ("TILE_LEVELS", Uint(TILE_LEVELS)),
    ("BINNING_RUNS", Uint(BINNING_RUNS)),
    ("BINNING_WORKGROUP", Uint(BINNING_WORKGROUP)),
    ("BINNING_BLOCK", Uint(BINNING_BLOCK)),
    ("BINNING_TILES_MAX", Uint(BINNING_TILES_MAX)),
    ("BIN_SIDES", Uint(BIN_SIDES)),
    ("BIN_BLOCK", Uint(BIN_BLOCK)),
    ("BIN_WORKGROUP", Uint(BIN_WORKGROUP)),
    ("SHARED_REGION", Uint(SHARED_REGION)),
    ("SHARED_WORKGROUP", Uint(SHARED_WORKGROUP)),
    ("SATURATION_REGION", Uint(SATURATION_REGION)),
    ("RASTER_SQUARE", Uint(RASTER_SQUARE)),
    ("RASTER_REGION", Uint(RASTER_REGION)),
    ("RASTER_WORKGROUP", Uint(RASTER_WORKGROUP)),
    ("RATES_WORKGROUP", Uint(RATES_WORKGROUP)),
    ("POSITION_BITS", Uint(POSITION_BITS)),
    ("CENTER_GRID_BITS", Uint(CENTER_GRID_BITS)),
    ("DETAIL_COARSEST", Uint(DETAIL_COARSEST)),
    ("INPUT_QUADS", Uint(INPUT_QUADS as u32)),
    ("MLP_WIDTH", Uint(limits::MLP_WIDTH as u32)),
    ("MLP_LAYERS", Uint(limits::MLP_LAYERS as u32)),
    ("JOINTS", Uint(limits::JOINTS as u32)),
    ("F16_MAX", Float(F16_MAX)),
    ("FEATURE_MAX", Float(FEATURE_MAX)),
    ("LOG_SCALE_MAX", Float(LOG_SCALE_MAX)),
    ("ALPHA_MAX", Float(ALPHA_MAX)),
    ("FACING_FADE", Float(FACING_FADE)),
    ("FACING_STEPS", Float(FACING_STEPS)),
    ("POSE_CACHE_WORDS", Uint(POSE_CACHE_WORDS)),
    ("ROTATION_MIN", Float(ROTATION_MIN)),
    ("VARIANCE_MAX", Float(VARIANCE_MAX)),
    ("NODE_BITS_MIN", Uint(NODE_BITS_MIN)),
    ("QUATERNION_STEPS", Float(QUATERNION_STEPS)),
    ("TRAIN_WORKGROUP", Uint(TRAIN_WORKGROUP)),
    ("TRAIN_MLP_WORKGROUP", Uint(TRAIN_MLP_WORKGROUP)),
    ("TRAIN_FEATURES_WORKGROUP", Uint(TRAIN_FEATURES_WORKGROUP)),
    ("TRAIN_BASES_WORKGROUP", Uint(TRAIN_BASES_WORKGROUP)),
    ("TRAIN_BASIS", Uint(TRAIN_BASIS)),
    ("TRAIN_WIDTH_MAX", Uint(TRAIN_WIDTH_MAX)),
    ("TRAIN_NO_ROW", Uint(TRAIN_NO_ROW)),
    ("TRAIN_RECORD", Uint(TRAIN_RECORD)),
    ("TRAIN_BLOCK", Uint(TRAIN_BLOCK)),
    ("TRAIN_LOSS_SUMS", Uint(TRAIN_LOSS_SUMS)),
    ("TRAIN_FULL", Float(TRAIN_FULL)),
];

#[cfg(test)]
mod tests {
    use super::{MACROS, MacroValue};

    #[test]
    fn float_macros_read_back_as_the_same_f32() {
        for (name, value) in MACROS {
            if let MacroValue::Float(number) = value {
                let text = value.glsl();
                assert_eq!(text.parse(), Ok(*number as f32), "{name} = {text}");
                assert!(text.contains(['.', 'e']), "{name} = {text} is a GLSL int");
            }
        }
    }
}
