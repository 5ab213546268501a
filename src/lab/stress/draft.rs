//! A case before it has a camera: the part that the categories change.

use super::body::{self, BodySizes, vector};
use effigy_core::{
    avatar::{Avatar, Pose},
    random::Random,
    scene::{AvatarBounds, Camera, Posed},
};
use glam::{DAffine3, DMat3, DQuat, DVec3};

/// An avatar, a pose and how to look at it.
pub struct Draft {
    pub sizes: BodySizes,
    pub avatar: Avatar,
    pub pose: Pose,
    /// Moves the posed avatar.
    pub placed: DAffine3,
    /// What is done to each joint in its own canonical place before the pose; none: nothing.
    pub stretched: Vec<DAffine3>,
    /// Width and height of the image, px.
    pub size: [u32; 2],
    /// Vertical field of view, radians.
    pub fov: f64,
    /// Distance from the avatar's middle, as a share of the distance that shows all of it.
    pub distance: f64,
    /// Depth of the near plane, metres in the avatar's own scale.
    pub near: f64,
    /// What was done to it, in words.
    pub note: String,
}

impl Draft {
    /// An avatar of random sizes.
    pub fn new(random: &mut Random) -> Self {
        let sizes = BodySizes::random(random);
        Self::with_sizes(random, sizes)
    }

    /// An avatar of some sizes, bent a little, all of it in an image of some 100 px.
    pub fn with_sizes(random: &mut Random, sizes: BodySizes) -> Self {
        let avatar = body::avatar(random, &sizes);
        let pose = Pose {
            rotation: (0..sizes.joints).map(|_| vector(random, 0.4)).collect(),
            translation: vector(random, 0.2),
            expression: (0..sizes.expression).map(|_| random.normal()).collect(),
        };
        let size = [0; 2].map(|_| random.range(4.0, 8.0).exp2() as u32);
        Self {
            sizes,
            avatar,
            pose,
            placed: DAffine3::IDENTITY,
            stretched: vec![],
            size,
            fov: random.range(0.4, 1.2),
            distance: random.range(0.6, 1.3),
            near: Camera::NEAR,
            note: String::new(),
        }
    }

    /// Factor by which the placement enlarges lengths.
    fn scale(&self) -> f64 {
        self.placed.matrix3.determinant().abs().cbrt()
    }

    /// The posed avatar in its place.
    pub fn posed(&self) -> Posed {
        let mut posed = Posed::new(&self.avatar, &self.pose);
        for (joint, stretch) in posed.joints.iter_mut().zip(&self.stretched) {
            *joint *= *stretch;
        }
        for joint in &mut posed.joints {
            *joint = self.placed * *joint;
        }
        posed
    }

    /// A camera that looks at the middle of the avatar from a random side.
    pub fn camera(&self, random: &mut Random, posed: &Posed) -> Camera {
        let [min, max] = AvatarBounds::new(&self.avatar).bounds(&posed.joints);
        let yaw = random.range(-3.2, 3.2);
        let pitch = random.range(-1.4, 1.4);
        let distance = self.distance * Camera::framing_distance([min, max], self.fov, self.size);
        Camera {
            near: self.near * self.scale(),
            ..Camera::orbit((min + max) / 2.0, yaw, pitch, distance, self.fov, self.size)
        }
    }
}

/// A random rotation, scale and translation, sometimes with a mirror.
pub fn placement(random: &mut Random) -> DAffine3 {
    let rotation = DQuat::from_axis_angle(random.direction(), random.range(0.0, 6.3));
    let scale = 10f64.powf(random.range(-3.0, 3.0));
    let mirror = if random.uniform() < 0.1 { -1.0 } else { 1.0 };
    let matrix =
        DMat3::from_quat(rotation) * DMat3::from_diagonal(DVec3::new(mirror * scale, scale, scale));
    DAffine3::from_mat3_translation(matrix, random.direction() * random.range(0.0, 1000.0))
}
