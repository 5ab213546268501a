//! What a frame may leave out. Each kind of work has a switch, so that a measurement can turn it back on.

use std::{fmt, str::FromStr};

bitflags::bitflags! {
    /// Work that is left out where a scene doesn't need it: `--skip all|none|LIST`.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Skip: u32 {
        /// Everything, the submission too, when nothing that shows has changed.
        const FRAME = 1;
        /// `features` and `nodes` when the pose has not changed.
        const POSE = 1 << 1;
        /// Networks outside the head when only the expression has changed.
        const EXPRESSION = 1 << 2;
        /// Network inputs that are zero: the expression's, outside the head.
        const INPUTS = 1 << 3;
        /// Contributions under the opacity cutoff: hulls no larger than a Gaussian's own opacity makes it reach.
        const FAINT = 1 << 4;
        /// Gaussians behind the depth surface, before they are sorted.
        const HIDDEN = 1 << 5;
        /// Fragments behind the depth surface; only where quads are drawn.
        const DEPTH = 1 << 6;
        /// Splats behind pixels that are full; only where tiles are drawn, since a blender takes all that comes.
        const FULL = 1 << 7;
        /// Correctives and skinning when only the camera has moved: what they gave before is kept, rounded.
        const SKINNING = 1 << 8;
        /// Parts outside the view: their Gaussians, and their networks until they are seen.
        const PARTS = 1 << 9;
        /// Avatars that are all outside the view: every stage of theirs.
        const AVATARS = 1 << 10;
        /// Pixels outside a box around what is in view, and around what was there before; with WebGPU only where tiles are drawn.
        const AREA = 1 << 11;
    }
}

impl Default for Skip {
    fn default() -> Self {
        Self::all()
    }
}

impl FromStr for Skip {
    type Err = String;

    /// Reads `all`, `none`, or some names with commas between.
    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "all" => return Ok(Self::all()),
            "none" => return Ok(Self::empty()),
            _ => {}
        }
        text.split(',').map(str::trim).try_fold(Self::empty(), |skip, name| {
            let one = Self::from_name(&name.to_ascii_uppercase());
            one.map(|one| skip | one)
                .ok_or_else(|| format!("`{name}` is nothing that can be skipped: write all, none, or a list of {}", Self::all()))
        })
    }
}

impl fmt::Display for Skip {
    /// As [`FromStr`] reads it, the names of `all` spelt out.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<_> = self.iter_names().map(|(name, _)| name.to_ascii_lowercase()).collect();
        f.write_str(if names.is_empty() { "none".to_owned() } else { names.join(",") }.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_read_back_as_they_are_written() {
        for skip in [Skip::all(), Skip::empty(), Skip::POSE | Skip::HIDDEN] {
            assert_eq!(skip.to_string().parse(), Ok(skip));
        }
        assert_eq!("all".parse(), Ok(Skip::all()));
        assert_eq!("hidden, depth".parse(), Ok(Skip::HIDDEN | Skip::DEPTH));
        assert!("everything".parse::<Skip>().is_err_and(|error| error.contains("hidden,depth,full,skinning,parts,avatars")));
    }
}
