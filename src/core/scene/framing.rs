//! What cameras frame: a person at one scale whatever the pose, a scene by what its splats show.

use crate::constants::NEAR;
use glam::DVec3;

/// Half the sides of a standing person's box, metres.
const PERSON: DVec3 = DVec3::new(0.4, 0.92, 0.4);
/// The nearest near plane, metres.
const NEAREST: f64 = 1e-6;
/// What a camera of the program's is made from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Framing {
    /// Lower and upper corner of the box to have in the image, metres.
    pub bounds: [DVec3; 2],
    /// Where the near plane is, metres.
    pub near: f64,
}

impl Framing {
    /// Of a person in some pose, `bounds` around it: widened to at least the size of a standing
    /// one, so that images of one clip have one scale.
    pub fn person(bounds: [DVec3; 2]) -> Self {
        let [min, max] = bounds;
        let middle = (min + max) / 2.0;
        let half = ((max - min) / 2.0).max(PERSON);
        Self::from([middle - half, middle + half])
    }

    /// Of a scene in any unit: the near plane is as near to what is smaller than a person.
    pub fn scene(bounds: [DVec3; 2]) -> Self {
        let size = 0.5 * bounds[0].distance(bounds[1]) / PERSON.length();
        Self {
            bounds,
            near: (NEAR * size).clamp(NEAREST, NEAR),
        }
    }

    /// Of both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        let [[low, high], [min, max]] = [self.bounds, other.bounds];
        Self {
            bounds: [low.min(min), high.max(max)],
            near: self.near.min(other.near),
        }
    }

    /// The middle of the box.
    pub fn middle(&self) -> DVec3 {
        (self.bounds[0] + self.bounds[1]) / 2.0
    }
}

impl From<[DVec3; 2]> for Framing {
    /// A box as it is, with a person's near plane.
    fn from(bounds: [DVec3; 2]) -> Self {
        Self { bounds, near: NEAR }
    }
}
