//! The scripted cases by name.

use crate::setting::RenderSetting;
use effigy_core::frame::Skip;
use std::{fmt, str::FromStr};

/// A scripted scene that a benchmark draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BenchCase {
    /// A new pose and another view in every frame.
    Full,
    /// Only the camera moves.
    Camera,
    /// Motion in real time before an orbiting camera.
    Orbit,
    /// Only the expression changes.
    Expression,
    /// Nothing changes.
    Static,
    /// Motion in real time, close to the face.
    Close,
    /// Motion in real time, 30 px tall.
    Far30,
    /// Motion in real time, 60 px tall.
    Far,
    /// Motion in real time, 120 px tall.
    Far120,
    /// Motion in real time, 240 px tall.
    Far240,
    /// Motion in real time, 480 px tall.
    Far480,
    /// Four avatars in motion.
    Four,
    /// A crowd in motion, about 60 px tall where the image has room for all.
    Crowd,
    /// Motion in real time before an orbiting camera, with the flicker of what is drawn.
    Flicker,
    /// The camera moves away from a still avatar, with the flicker of what is drawn.
    Zoom,
}

impl BenchCase {
    /// Every case.
    pub const ALL: [Self; 15] = [
        Self::Full,
        Self::Camera,
        Self::Orbit,
        Self::Expression,
        Self::Static,
        Self::Close,
        Self::Far30,
        Self::Far,
        Self::Far120,
        Self::Far240,
        Self::Far480,
        Self::Four,
        Self::Crowd,
        Self::Flicker,
        Self::Zoom,
    ];

    /// Name on the command line and in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Camera => "camera",
            Self::Orbit => "orbit",
            Self::Expression => "expression",
            Self::Static => "static",
            Self::Close => "close",
            Self::Far30 => "far30",
            Self::Far => "far",
            Self::Far120 => "far120",
            Self::Far240 => "far240",
            Self::Far480 => "far480",
            Self::Four => "four",
            Self::Crowd => "crowd",
            Self::Flicker => "flicker",
            Self::Zoom => "zoom",
        }
    }

    /// One line on what it draws.
    pub fn about(self) -> &'static str {
        match self {
            Self::Full => "every frame a new pose and the next view",
            Self::Camera => "a still avatar, a slowly orbiting camera",
            Self::Orbit => "motion in real time, a slowly orbiting camera",
            Self::Expression => "only the expression changes",
            Self::Static => "nothing changes",
            Self::Close => "motion in real time, the camera a forearm from the face",
            Self::Far30 => "motion in real time, the avatar 30 px tall",
            Self::Far => "motion in real time, the avatar 60 px tall",
            Self::Far120 => "motion in real time, the avatar 120 px tall",
            Self::Far240 => "motion in real time, the avatar 240 px tall",
            Self::Far480 => "motion in real time, the avatar 480 px tall",
            Self::Four => {
                "four avatars in motion a metre apart, a slowly orbiting camera on all or one of them"
            }
            Self::Crowd => {
                "64 avatars in motion, about 60 px tall if they fit, a slowly orbiting camera"
            }
            Self::Flicker => "motion in real time, a slowly orbiting camera; what flickers",
            Self::Zoom => "a still avatar that grows smaller, from 2000 to 20 px; what flickers",
        }
    }

    /// Number of avatars in its scenes.
    pub fn instances(self) -> usize {
        match self {
            Self::Four => 4,
            Self::Crowd => 64,
            _ => 1,
        }
    }

    /// Whether frames follow each other at [`RATE`](super::scene::RATE), so that a pose can be held
    /// for several of them.
    pub fn in_real_time(self) -> bool {
        matches!(self, Self::Orbit | Self::Close | Self::Four | Self::Flicker)
            || self.tall().is_some()
    }

    /// Whether the flicker of its frames is measured.
    pub fn has_flicker(self) -> bool {
        matches!(self, Self::Flicker | Self::Zoom)
    }

    /// How tall the avatar is in the image, px, where the case says so.
    pub fn tall(self) -> Option<f64> {
        match self {
            Self::Far30 => Some(30.0),
            Self::Far | Self::Crowd => Some(60.0),
            Self::Far120 => Some(120.0),
            Self::Far240 => Some(240.0),
            Self::Far480 => Some(480.0),
            _ => None,
        }
    }

    /// How many times its size the reference draws it, before it is averaged. What is small is
    /// compared with what the area of each pixel shows.
    pub fn truth_factor(self) -> u32 {
        if self.tall().is_some() { 8 } else { 1 }
    }

    /// Whether the camera moves.
    pub fn camera_moves(self) -> bool {
        !matches!(self, Self::Static | Self::Expression)
    }

    /// Whether the case keeps its own camera even if cameras are given.
    pub fn own_camera(self) -> bool {
        matches!(self, Self::Close | Self::Four | Self::Zoom) || self.tall().is_some()
    }
}

impl RenderSetting {
    /// The setting as a case is drawn with it. In [`BenchCase::Full`] every frame is drawn, even if
    /// nothing has changed.
    pub fn for_case(&self, case: BenchCase) -> Self {
        let mut setting = *self;
        if case == BenchCase::Full {
            setting.options.skip -= Skip::FRAME;
        }
        setting
    }
}

impl fmt::Display for BenchCase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for BenchCase {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let names = || Self::ALL.map(Self::name).join(", ");
        Self::ALL
            .into_iter()
            .find(|case| case.name() == text)
            .ok_or_else(|| format!("`{text}` is not a case: write one of {}", names()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_read_back_as_they_are_written() {
        assert!(
            BenchCase::ALL
                .into_iter()
                .all(|case| case.to_string().parse() == Ok(case))
        );
        assert!(
            "fulll"
                .parse::<BenchCase>()
                .is_err_and(|error| error.contains("orbit"))
        );
    }
}
