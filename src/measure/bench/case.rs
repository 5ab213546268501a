//! The scripted cases by name.

use std::{fmt, str::FromStr};

/// What a benchmark can draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Case {
    Full,
    Camera,
    Orbit,
    Expression,
    Static,
    Close,
    Far,
    Four,
}

impl Case {
    pub const ALL: [Self; 8] = [Self::Full, Self::Camera, Self::Orbit, Self::Expression, Self::Static, Self::Close, Self::Far, Self::Four];

    /// As the command line and the reports have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Camera => "camera",
            Self::Orbit => "orbit",
            Self::Expression => "expression",
            Self::Static => "static",
            Self::Close => "close",
            Self::Far => "far",
            Self::Four => "four",
        }
    }

    /// What it draws, in a line.
    pub fn about(self) -> &'static str {
        match self {
            Self::Full => "every frame a new pose and the next view",
            Self::Camera => "a still avatar, a slowly orbiting camera",
            Self::Orbit => "motion in real time, a slowly orbiting camera",
            Self::Expression => "only the expression changes",
            Self::Static => "nothing changes",
            Self::Close => "motion in real time, the camera a forearm from the face",
            Self::Far => "motion in real time, the avatar 60 px tall",
            Self::Four => "four avatars in motion a metre apart, a slowly orbiting camera on all or one of them",
        }
    }

    /// Avatars in its scenes.
    pub fn actors(self) -> usize {
        if self == Self::Four { 4 } else { 1 }
    }

    /// Whether one frame follows the other at [`RATE`](super::scene::RATE), so that holding a pose for some of them means
    /// something.
    pub fn in_real_time(self) -> bool {
        matches!(self, Self::Orbit | Self::Close | Self::Far | Self::Four)
    }

    /// Whether the camera moves.
    pub fn camera_moves(self) -> bool {
        !matches!(self, Self::Static | Self::Expression)
    }

    /// Whether the camera is the case's own even where cameras are given.
    pub fn own_camera(self) -> bool {
        matches!(self, Self::Close | Self::Far | Self::Four)
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Case {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let names = || Self::ALL.map(Self::name).join(", ");
        Self::ALL.into_iter().find(|case| case.name() == text).ok_or_else(|| format!("`{text}` is no case: write one of {}", names()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_read_back_as_they_are_written() {
        assert!(Case::ALL.into_iter().all(|case| case.to_string().parse() == Ok(case)));
        assert!("fulll".parse::<Case>().is_err_and(|error| error.contains("orbit")));
    }
}
