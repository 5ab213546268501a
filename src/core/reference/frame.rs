//! Whole frames of the reference renderer.

use super::{
    mlp, nodes, project,
    project::{Culled, Gaussian, Splat},
    raster,
    raster::Canvas,
    ray, sh, sort,
    sort::Sorting,
};
use crate::avatar::{Avatar, Filter, LowPass};
use crate::layout::compact::NeutralGaussian;
use crate::scene::{Camera, FrameImage, PixelRect, Posed, detail::COARSEST};
use glam::{DVec2, DVec3, UVec2};
use half::f16;

/// The results of every stage of one frame.
#[derive(Clone, Debug)]
pub struct ReferenceFrame {
    /// e; shape N_G, E.
    pub features: Vec<f64>,
    /// δx_s, metres; length N_s.
    pub nodes: Vec<DVec3>,
    /// The avatar in the posed world; length N_g, fewer at a level of detail.
    pub gaussians: Vec<Gaussian>,
    /// Each of `gaussians` in the image, or why it is culled.
    pub splats: Vec<Result<Splat, Culled>>,
    /// Indices into `splats`, far to near.
    pub order: Vec<u32>,
    /// The image.
    pub canvas: Canvas,
}

impl ReferenceFrame {
    /// Runs all stages on every Gaussian.
    ///
    /// # Panics
    /// Where [`Avatar::check`] finds a fault, or the pose is another avatar's.
    pub fn new(avatar: &Avatar, posed: &Posed, camera: &Camera) -> Self {
        Self::at_level(avatar, posed, camera, 0)
    }

    /// Runs all stages at a level of detail ([`crate::scene::detail`]): on every 2^`level`-th
    /// Gaussian, which represents those skipped. Levels beyond [`COARSEST`] are drawn as that one.
    ///
    /// # Panics
    /// Where [`ReferenceFrame::new`] does.
    pub fn at_level(avatar: &Avatar, posed: &Posed, camera: &Camera, level: u32) -> Self {
        let level = level.min(COARSEST);
        let features = mlp::features(avatar, &posed.input);
        let nodes = nodes::nodes(avatar, &features);
        let gaussians = posed_gaussians(avatar, posed, camera, &features, &nodes);
        let gaussians: Vec<Gaussian> = gaussians.into_iter().step_by(1 << level).collect();
        let splats = project::splats(&gaussians, camera, avatar.filter, level);
        let order = sort::order(&splats);
        let canvas = raster::raster(&splats, &order, camera);
        Self {
            features,
            nodes,
            gaussians,
            splats,
            order,
            canvas,
        }
    }
}

/// The image of a posed avatar.
///
/// # Panics
/// Where [`ReferenceFrame::new`] does.
pub fn render(avatar: &Avatar, posed: &Posed, camera: &Camera) -> FrameImage {
    ReferenceFrame::new(avatar, posed, camera).canvas.to_image()
}

/// The exact image of the rounded model that a device stores: basis rows, scales, rotations and
/// node weights rounded by [`crate::layout::compact`], node displacements to f16. A device's image
/// differs from this one by its arithmetic alone.
pub fn render_stored(avatar: &Avatar, posed: &Posed, camera: &Camera) -> FrameImage {
    let (stored, features, mut gaussians) = stored(avatar, posed);
    sh::apply_colors(&stored, posed, camera, &features, &mut gaussians);
    render_gaussians(&gaussians, camera, avatar.filter)
}

/// The model as device memory stores it, its features in a pose, and its posed Gaussians, still
/// with neutral colours where these depend on the view.
pub fn stored(avatar: &Avatar, posed: &Posed) -> (Avatar, Vec<f64>, Vec<Gaussian>) {
    let stored = avatar.compact();
    let features = mlp::features(&stored, &posed.input);
    let half = |v: f64| f16::from_f64(v).to_f64();
    let nodes: Vec<DVec3> = nodes::nodes(&stored, &features)
        .into_iter()
        .map(|node| DVec3::from(node.to_array().map(half)))
        .collect();
    let gaussians = project::gaussians_from(&stored, posed, &features, &nodes, |k| {
        NeutralGaussian::stored(avatar, k)
    });
    (stored, features, gaussians)
}

/// A person of a frame: an avatar in a pose.
#[derive(Clone, Copy)]
pub struct Person<'a> {
    /// Whose looks.
    pub avatar: &'a Avatar,
    /// The evaluated pose, of that avatar.
    pub posed: &'a Posed,
}

/// People of one avatar.
pub fn people<'a>(avatar: &'a Avatar, poses: &[&'a Posed]) -> Vec<Person<'a>> {
    let person = |&posed| Person { avatar, posed };
    poses.iter().map(person).collect()
}

/// The image of people, sorted together, each with `filter` or the low-pass of its avatar.
pub fn render_scene(people: &[Person], camera: &Camera, filter: Option<Filter>) -> FrameImage {
    let splats = people.iter().flat_map(|person| {
        let gaussians = gaussians_of(person.avatar, &[person.posed], camera);
        project::splats(
            &gaussians,
            camera,
            filter.unwrap_or(person.avatar.filter),
            0,
        )
    });
    let splats: Vec<_> = splats.collect();
    raster::raster(&splats, &sort::order(&splats), camera).to_image()
}

/// The Gaussians of one avatar in several poses, with the colours that the camera sees.
pub fn gaussians_of(avatar: &Avatar, instances: &[&Posed], camera: &Camera) -> Vec<Gaussian> {
    instances
        .iter()
        .flat_map(|posed| {
            let features = mlp::features(avatar, &posed.input);
            let nodes = nodes::nodes(avatar, &features);
            posed_gaussians(avatar, posed, camera, &features, &nodes)
        })
        .collect()
}

/// What the area of each pixel shows: the image of one avatar in
/// several poses, drawn `factor` times as large,
/// at least 1, with a low-pass, and averaged.
pub fn render_supersampled(
    avatar: &Avatar,
    instances: &[&Posed],
    camera: &Camera,
    factor: u32,
    filter: Filter,
) -> FrameImage {
    average_of(
        &gaussians_of(avatar, instances, camera),
        camera,
        factor,
        filter,
    )
}

/// The image of Gaussians in the posed world, drawn `factor` times as large, at least 1, with a
/// low-pass, and averaged.
pub fn average_of(
    gaussians: &[Gaussian],
    camera: &Camera,
    factor: u32,
    filter: Filter,
) -> FrameImage {
    let larger = camera.stretched(camera.size.map(|side| factor * side));
    let mut splats = project::splats(gaussians, &larger, filter, 0);
    // Only the pixels that something is drawn into take memory.
    let scale = f64::from(factor);
    let rect = drawn_rect(&splats, scale, camera.size);
    let mut image = FrameImage::empty(camera.size);
    if rect.is_empty() {
        return image;
    }
    for splat in splats.iter_mut().flatten() {
        splat.center -= scale * rect.min.as_dvec2();
    }
    let order = sort::order(&splats);
    let drawn = Camera {
        size: ((rect.max - rect.min) * factor).into(),
        ..larger
    };
    let average = raster::raster(&splats, &order, &drawn)
        .to_image()
        .averaged(factor);
    let [width, height] = average.size.map(|side| side as usize);
    for row in 0..height {
        let to = (rect.min.y as usize + row) * camera.size[0] as usize + rect.min.x as usize;
        image.pixels[to..to + width].copy_from_slice(&average.pixels[row * width..][..width]);
    }
    image
}

/// A rectangle around all pixels that splats are drawn into, in an image of a size, px, that shows
/// what they lie in `scale` times smaller.
pub fn drawn_rect(splats: &[Result<Splat, Culled>], scale: f64, size: [u32; 2]) -> PixelRect {
    let size = UVec2::from(size).as_dvec2();
    splats
        .iter()
        .flatten()
        .map(|splat| PixelRect {
            min: ((splat.center - splat.radius) / scale)
                .floor()
                .clamp(DVec2::ZERO, size)
                .as_uvec2(),
            max: ((splat.center + splat.radius) / scale)
                .ceil()
                .clamp(DVec2::ZERO, size)
                .as_uvec2(),
        })
        .fold(PixelRect::EMPTY, PixelRect::union)
}

/// The image of Gaussians in the posed world.
pub fn render_gaussians(
    gaussians: &[Gaussian],
    camera: &Camera,
    low_pass: impl Into<LowPass>,
) -> FrameImage {
    render_sorted(gaussians, camera, low_pass, Sorting::Centers)
}

/// The image of Gaussians in the posed world, blended in the order that `sorting` names.
pub fn render_sorted(
    gaussians: &[Gaussian],
    camera: &Camera,
    low_pass: impl Into<LowPass>,
    sorting: Sorting,
) -> FrameImage {
    let low_pass = low_pass.into();
    let splats = project::splats(gaussians, camera, low_pass, 0);
    let canvas = match sorting {
        Sorting::Centers => raster::raster(&splats, &sort::order(&splats), camera),
        Sorting::PerPixel => {
            raster::raster_per_pixel(&splats, &ray::rays(gaussians, camera, low_pass), camera)
        }
    };
    canvas.to_image()
}

/// The avatar in the posed world, with the colours that the camera sees.
fn posed_gaussians(
    avatar: &Avatar,
    posed: &Posed,
    camera: &Camera,
    features: &[f64],
    nodes: &[DVec3],
) -> Vec<Gaussian> {
    let mut gaussians = project::gaussians(avatar, posed, features, nodes);
    sh::apply_colors(avatar, posed, camera, features, &mut gaussians);
    gaussians
}
