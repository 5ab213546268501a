//! Work that a frame may skip. Each kind of work has a switch, so that a measurement can turn it
//! back on.

use std::{fmt, str::FromStr};

bitflags::bitflags! {
    /// Work that is skipped where a scene does not need it: `--skip all|none|LIST`.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Skip: u32 {
        /// Everything, the submission included, when nothing visible has changed.
        const FRAME = 1;
        /// Mlp and nodes when the pose has not changed.
        const POSE = 1 << 1;
        /// Networks outside the head when only the expression has changed.
        const EXPRESSION = 1 << 2;
        /// Network inputs that are zero: the expression's, outside the head.
        const INPUTS = 1 << 3;
        /// Contributions under the opacity cutoff: quads are only as large as a Gaussian's opacity
        /// makes visible.
        const FAINT = 1 << 4;
        /// Fragments of quads behind the saturation depth, the depth behind which nothing shows.
        const DEPTH = 1 << 5;
        /// Splats behind saturated pixels; only with tiles, since fixed-function blending can't
        /// stop: quads have `DEPTH`.
        const SATURATED = 1 << 6;
        /// Correctives and skinning when only the camera has moved: their results come from the
        /// pose cache, rounded.
        const SKINNING = 1 << 7;
        /// Parts outside the view: their Gaussians, and their networks until they come into view.
        const PARTS = 1 << 8;
        /// Avatars that are all outside the view: all their stages.
        const AVATARS = 1 << 9;
        /// Pixels outside the damage rectangle, the box around what is in view and what was there
        /// before; with WebGPU only with tiles.
        const DAMAGE = 1 << 10;
        /// Gaussians that face away, where an avatar says from where each is drawn.
        const FACING = 1 << 11;
    }
}

impl Default for Skip {
    fn default() -> Self {
        Self::all()
    }
}

impl FromStr for Skip {
    type Err = String;

    /// Parses `all`, `none`, or a comma-separated list of names. `full` and `area` are old names of
    /// `saturated` and `damage`.
    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "all" => return Ok(Self::all()),
            "none" => return Ok(Self::empty()),
            _ => {}
        }
        let mut skip = Self::empty();
        for name in text.split(',').map(str::trim) {
            let flag = match name.to_ascii_uppercase().as_str() {
                "FULL" => Some(Self::SATURATED),
                "AREA" => Some(Self::DAMAGE),
                name => Self::from_name(name),
            };
            skip |= flag.ok_or_else(|| {
                format!(
                    "`{name}` is nothing that can be skipped: write all, none, or a list of {}",
                    Self::all()
                )
            })?;
        }
        Ok(skip)
    }
}

impl fmt::Display for Skip {
    /// Writes a list that [`FromStr`] parses, the names of `all` spelt out.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<_> = self
            .iter_names()
            .map(|(name, _)| name.to_ascii_lowercase())
            .collect();
        if names.is_empty() {
            f.write_str("none")
        } else {
            f.write_str(&names.join(","))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_read_back_as_they_are_written() {
        for skip in [Skip::all(), Skip::empty(), Skip::POSE | Skip::DEPTH] {
            assert_eq!(skip.to_string().parse(), Ok(skip));
        }
        assert_eq!("all".parse(), Ok(Skip::all()));
        assert_eq!("faint, depth".parse(), Ok(Skip::FAINT | Skip::DEPTH));
        assert_eq!("full,area".parse(), Ok(Skip::SATURATED | Skip::DAMAGE));
        assert!(
            "everything"
                .parse::<Skip>()
                .is_err_and(|error| error.contains("faint,depth,saturated,skinning,parts,avatars"))
        );
    }
}
