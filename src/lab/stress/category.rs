//! The categories of stress cases: what the cases of each have in common.

use serde::Serialize;

/// What makes a case hard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Category {
    /// Large joint angles.
    Poses,
    /// Rotated, scaled and moved far.
    Placed,
    /// Far from the camera.
    Distant,
    /// Degenerate rotations.
    Quaternions,
    /// Extreme aspect ratios.
    Needles,
    /// Gaussians on the near plane.
    NearPlane,
    /// Gaussians far smaller than a pixel.
    SubPixel,
    /// Gaussians larger than the image.
    ScreenFilling,
    /// Extreme opacities.
    Opacity,
    /// Colours out of range.
    Colors,
    /// Numbers at f16's largest.
    Overflow,
    /// The camera inside the body.
    Inside,
    /// Extreme image sizes.
    Sizes,
    /// Extreme fields of view.
    Views,
    /// Several of these at once.
    Mixed,
    /// A closed body.
    Solid,
    /// A closed body that its pose pulls apart or stretches.
    Torn,
    /// Inputs that can't be drawn.
    Refused,
}

impl Category {
    /// Every category.
    pub const ALL: [Self; 18] = [
        Self::Poses,
        Self::Placed,
        Self::Distant,
        Self::Quaternions,
        Self::Needles,
        Self::NearPlane,
        Self::SubPixel,
        Self::ScreenFilling,
        Self::Opacity,
        Self::Colors,
        Self::Overflow,
        Self::Inside,
        Self::Sizes,
        Self::Views,
        Self::Mixed,
        Self::Solid,
        Self::Refused,
        Self::Torn,
    ];
    /// Cases of a round, in which each category has its turn: [`Self::Torn`] has that of
    /// [`Self::Solid`] in every second round, so that other cases keep the numbers that they had
    /// before there was one.
    pub const ROUND: u64 = Self::ALL.len() as u64 - 1;

    /// The category of a case: categories take turns.
    pub fn of_case(number: u64) -> Self {
        let category = Self::ALL[(number % Self::ROUND) as usize];
        let is_odd_round = (number / Self::ROUND) % 2 == 1;
        if category == Self::Solid && is_odd_round {
            Self::Torn
        } else {
            category
        }
    }

    /// Name in output for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Poses => "poses",
            Self::Placed => "placed",
            Self::Distant => "distant",
            Self::Quaternions => "quaternions",
            Self::Needles => "needles",
            Self::NearPlane => "near plane",
            Self::SubPixel => "sub-pixel",
            Self::ScreenFilling => "screen-filling",
            Self::Opacity => "opacity",
            Self::Colors => "colours",
            Self::Overflow => "overflow",
            Self::Inside => "inside",
            Self::Sizes => "sizes",
            Self::Views => "views",
            Self::Mixed => "mixed",
            Self::Solid => "solid",
            Self::Torn => "torn",
            Self::Refused => "refused",
        }
    }

    /// Description of its cases, in a line.
    pub fn what(self) -> &'static str {
        match self {
            Self::Poses => "joint angles to π, beyond it, and to 10,000 turns",
            Self::Placed => "turned anywhere, scaled by 0.001 to 1000, up to 1 km from the origin",
            Self::Distant => "seen from up to 1 km away",
            Self::Quaternions => {
                "rotations of nearly no length, that cancel out, or that f16 can't hold"
            }
            Self::Needles => "needles and sheets of 1:10,000",
            Self::NearPlane => "Gaussians on the near plane, before and behind it",
            Self::SubPixel => "Gaussians far smaller than a pixel, or without extent",
            Self::ScreenFilling => {
                "Gaussians larger than the image, up to those larger than f32 can square"
            }
            Self::Opacity => "opacities 0, 1/255, 2/255 and 1",
            Self::Colors => "colours far out of range",
            Self::Overflow => "weights, biases and bases at f16's largest number",
            Self::Inside => "the camera inside the body",
            Self::Sizes => "images from 1 px to 8192 px a side",
            Self::Views => "fields of view from 1° to 170°",
            Self::Mixed => "several of these at once",
            Self::Solid => "a closed body, much of which lies behind itself",
            Self::Torn => {
                "a closed body that joints pull apart or stretch, so that its inside shows"
            }
            Self::Refused => "NaN, infinity and other numbers that can't be drawn, in every input",
        }
    }
}
