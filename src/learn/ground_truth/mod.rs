//! The mesh of a dressed body in a pose. Nothing here is a formula of the pose: the mesh is skinned,
//! flesh and cloth settle on it ([`cloth`]), and light is ray traced against it ([`light`]),
//! together in [`settled`].

pub mod cloth;
pub mod light;
pub mod mesh;
pub mod settled;
