//! The `occluder` stage: its depth pyramid against the reference, texel by texel, and what it hides
//! of bodies that poses pull apart.

use crate::common::gpu::{self, Frame};
use effigy::vulkan::{Gpu, PreparedAvatar, Renderer, RendererOptions};
use effigy_core::{
    avatar::{Avatar, Pose},
    frame::{FrameState, PlanInput, Skip, room::Room},
    layout::{OCCLUDER_SIDE, PYRAMID_LEVELS, PYRAMID_SIDE, PackedOccluder, SORT_CULLED},
    occluder::Occluder,
    reference::occluder::{self, OccluderDrawing},
    scene::{AvatarBounds, Camera, OccluderView, PartDependencies, Posed, upright},
};
use effigy_measure::error;
use glam::{DVec2, DVec3};
use std::sync::Arc;

const SIZE: [u32; 2] = [300, 420];

fn demo() -> Avatar {
    effigy_demo::avatar().expect("inside the program")
}

/// The demo with its knees, hips and elbows bent, by a share of what tears it.
fn bent(avatar: &Avatar, share: f64) -> Posed {
    let mut pose = Pose::rest(avatar.skeleton.len(), avatar.inputs.expression);
    pose.rotation[1] = DVec3::new(-1.9, 0.0, 0.4) * share;
    pose.rotation[2] = DVec3::new(-1.2, 0.3, -0.6) * share;
    pose.rotation[4] = DVec3::new(2.2, 0.0, 0.0) * share;
    pose.rotation[3] = DVec3::new(0.5, 0.3, 0.2) * share;
    pose.rotation[16] = DVec3::new(0.3, 0.4, 1.1) * share;
    pose.rotation[17] = DVec3::new(0.2, -0.9, -1.3) * share;
    pose.rotation[18] = DVec3::new(0.0, -1.9, 0.3) * share;
    Posed::new(avatar, &pose)
}

fn camera(avatar: &Avatar, posed: &Posed, yaw: f64, nearness: f64, size: [u32; 2]) -> Camera {
    let bounds = upright(AvatarBounds::new(avatar).bounds(&posed.joints));
    let distance = nearness * Camera::framing_distance(bounds, 0.6, size);
    Camera::orbit((bounds[0] + bounds[1]) / 2.0, yaw, 0.1, distance, 0.6, size)
}

/// A frame of the bent demo, and how its occluder was drawn.
struct Scene {
    frame: Frame,
    mesh: Occluder,
    options: RendererOptions,
    /// Depths between which keys are linear, metres.
    depth_range: [f64; 2],
    view: OccluderView,
}

impl Scene {
    /// `share`: how far it is bent; `nearness`: see [`camera`].
    fn new(share: f64, yaw: f64, nearness: f64) -> Self {
        let device = gpu::drawing();
        let avatar = demo();
        let posed = bent(&avatar, share);
        let camera = camera(&avatar, &posed, yaw, nearness, SIZE);
        let options = RendererOptions {
            skip: Skip::HIDDEN,
            ..gpu::options(SIZE)
        };
        let mesh = Occluder::new(&avatar);
        let bounds = AvatarBounds::new(&avatar);
        let dependencies = PartDependencies::new(&avatar);
        let plan = FrameState::default().plan(PlanInput {
            poses: &[&posed],
            camera: &camera,
            bounds: &bounds,
            dependencies: &dependencies,
            options: &options,
            room: Room::new(&options, &bounds).expect("room for one"),
            has_occluder: true,
            always_submit: true,
        });
        let depth_range = plan.image.depth_range;
        let view = plan.image.occluder_view.expect("the demo has an occluder");
        Self {
            frame: gpu::draw(&device, avatar, posed, camera, options),
            mesh,
            options,
            depth_range,
            view,
        }
    }
}

/// How far the demo is bent, the camera's yaw and how near it is. Two views are cut off by the
/// image's edges.
const VIEWS: [[f64; 3]; 4] = [
    [0.0, 0.4, 1.0],
    [1.0, 3.6, 1.0],
    [0.3, 0.3, 0.6],
    [0.3, 5.0, 0.3],
];

/// The pyramid lies between the furthest and the nearest that the reference finds where it samples
/// the depth image a sixteenth of a texel off the middle: there edges of triangles are ties.
fn the_pyramid_is_that_of_the_reference() {
    for [share, yaw, nearness] in VIEWS {
        let scene = Scene::new(share, yaw, nearness);
        let Frame {
            avatar,
            posed,
            camera,
            reference,
            gpu,
            ..
        } = &scene.frame;
        let vertices = occluder::vertices(avatar, &scene.mesh, posed, camera, &reference.nodes);
        let torn = vertices.iter().filter(|vertex| !vertex.is_opaque).count();
        if share == 1.0 {
            assert!(torn > 50, "{torn} of {} vertices are torn", vertices.len());
        }
        let off = |x: f64, y: f64| {
            let drawing = OccluderDrawing {
                camera,
                view: &scene.view,
                depth_range: scene.depth_range,
                margin: scene.options.margin,
                offset: DVec2::new(x, y) / 16.0,
            };
            occluder::pyramid(&vertices, &scene.mesh.triangles, &drawing)
        };
        let sampled = [
            off(0.0, 0.0),
            off(-1.0, -1.0),
            off(1.0, -1.0),
            off(-1.0, 1.0),
            off(1.0, 1.0),
        ];
        let (finest, _) = gpu.pyramid.split_at(sampled[0].len());
        // Positions have 16 bits in the file's box, depths 16 bits in the image.
        let tolerance = 12.0 / 65535.0;
        let mut hiding = 0;
        let mut wrong = Vec::new();
        for (at, &texel) in finest.iter().enumerate() {
            let depth = f64::from(texel) / 65535.0;
            let near = sampled.iter().map(|all| all[at]).fold(1.0, f64::min);
            let far = sampled.iter().map(|all| all[at]).fold(0.0, f64::max);
            if depth < near - tolerance || depth > far + tolerance {
                wrong.push((at, depth, near, far));
            }
            hiding += usize::from(texel < u16::MAX);
        }
        assert_coarse_levels(&gpu.pyramid);
        assert!(hiding > 1000, "only {hiding} texels hide anything");
        // A vertex at the very limit of its stretch may be opaque here and torn there.
        assert!(
            wrong.len() <= hiding / 200,
            "{} of {hiding} texels are wrong, such as {:?}",
            wrong.len(),
            wrong.first()
        );
    }
}

/// Each texel of a coarser level is the furthest of four of the level before.
fn assert_coarse_levels(pyramid: &[u16]) {
    let mut finer = 0;
    let mut start = (PYRAMID_SIDE * PYRAMID_SIDE) as usize;
    for level in 1..PYRAMID_LEVELS {
        let side = (PYRAMID_SIDE >> level) as usize;
        for y in 0..side {
            for x in 0..side {
                let furthest = [(0, 0), (1, 0), (0, 1), (1, 1)]
                    .map(|(dx, dy)| pyramid[finer + (2 * y + dy) * 2 * side + 2 * x + dx])
                    .into_iter()
                    .max();
                let found = pyramid[start + y * side + x];
                assert_eq!(Some(found), furthest, "level {level}, texel ({x}, {y})");
            }
        }
        finer = start;
        start += side * side;
    }
    assert_eq!(pyramid.len(), start);
}

/// Every Gaussian that the device leaves out and the reference does not lies behind all texels that
/// its ellipse meets. The finest level says more than the coarse one that the device looks at.
fn what_is_hidden_lies_behind_the_pyramid() {
    let side = PYRAMID_SIDE as usize;
    for [share, yaw, nearness] in VIEWS {
        let scene = Scene::new(share, yaw, nearness);
        let splats = &scene.frame.reference.splats;
        let pyramid = &scene.frame.gpu.pyramid;
        let texel = |pixel: DVec2| {
            let at = scene.view.texel(pixel) * f64::from(PYRAMID_SIDE) / f64::from(OCCLUDER_SIDE);
            at.clamp(DVec2::ZERO, DVec2::splat(f64::from(PYRAMID_SIDE - 1)))
        };
        let mut hidden = 0;
        for (at, splat) in splats.iter().enumerate() {
            let (Ok(splat), true) = (splat, scene.frame.gpu.keys[at] == SORT_CULLED) else {
                continue;
            };
            hidden += 1;
            let low = texel(splat.center - splat.radius);
            let high = texel(splat.center + splat.radius);
            let furthest = (low.y as usize..=high.y as usize)
                .flat_map(|y| (low.x as usize..=high.x as usize).map(move |x| y * side + x))
                .map(|at| f64::from(pyramid[at]) / 65535.0)
                .fold(0.0, f64::max);
            let depth = occluder::depth_of(splat.depth, scene.depth_range);
            assert!(
                depth > furthest - 4.0 / 65535.0,
                "Gaussian {at} at {depth} is hidden by what is at {furthest}, {splat:?}"
            );
        }
        assert!(hidden > 1000, "only {hidden} Gaussians are hidden");
    }
}

/// The image with what is hidden left out, against the one with all, for bodies pulled apart.
fn the_occluder_hides_nothing_where_the_shell_is_torn() {
    let device = gpu::drawing();
    let avatar = demo();
    let mut hidden = 0;
    for share in [0.5, 1.0] {
        let posed = bent(&avatar, share);
        for (yaw, nearness) in [(0.3, 1.0), (1.9, 0.6), (3.4, 0.3), (5.0, 0.6)] {
            let camera = camera(&avatar, &posed, yaw, nearness, SIZE);
            let all = drawn(&device, &avatar, &posed, &camera, Skip::empty());
            let some = drawn(&device, &avatar, &posed, &camera, Skip::HIDDEN);
            hidden += all.count - some.count;
            let error = error::between(&some.image, &all.image).covered;
            let place = format!("bent by {share}, yaw {yaw}, at {nearness}");
            assert!(error.psnr_db > 50.0, "{place}: {error:?}");
            assert!(error.visible <= 20, "{place}: {error:?}");
        }
    }
    assert!(hidden > 20_000, "only {hidden} Gaussians were hidden");
}

fn an_occluder_that_comes_later_hides_as_much() {
    let device = gpu::drawing();
    let avatar = demo();
    let posed = bent(&avatar, 0.0);
    let camera = camera(&avatar, &posed, 0.3, 1.0, SIZE);
    let expected = drawn(&device, &avatar, &posed, &camera, Skip::HIDDEN);
    let options = RendererOptions {
        skip: Skip::HIDDEN,
        ..gpu::options(camera.size)
    };
    let prepared = PreparedAvatar::without_occluder(&avatar).expect("the demo");
    let mut renderer = Renderer::from_prepared(&device, &prepared, options).expect("a renderer");
    let draw = |renderer: &mut Renderer| {
        renderer.draw(&posed, &camera, None).expect("a frame");
        let image = renderer.read_image().expect("an image");
        (image, renderer.report().counters.drawn)
    };
    let (_, all) = draw(&mut renderer);
    assert!(
        all > expected.count,
        "{all} of {} Gaussians",
        expected.count
    );
    for _ in 0..2 {
        let mesh = PackedOccluder::new(&avatar);
        renderer.add_occluder(&mesh).expect("an occluder");
        let (image, count) = draw(&mut renderer);
        assert_eq!(count, expected.count);
        assert!(image == expected.image, "another image");
    }
    // The mesh is this avatar's: another one needs a renderer of its own.
    assert!(!renderer.replace_avatar(&prepared).expect("the device"));
}

struct Drawn {
    image: effigy_core::scene::FrameImage,
    /// Gaussians that were sorted.
    count: u64,
}

fn drawn(device: &Arc<Gpu>, avatar: &Avatar, posed: &Posed, camera: &Camera, skip: Skip) -> Drawn {
    let options = RendererOptions {
        skip,
        ..gpu::options(camera.size)
    };
    let mut renderer = Renderer::new(device, avatar, options).expect("a renderer");
    renderer.draw(posed, camera, None).expect("a frame");
    Drawn {
        image: renderer.read_image().expect("an image"),
        count: renderer.report().counters.drawn,
    }
}

tests! {
    the_pyramid_is_that_of_the_reference,
    what_is_hidden_lies_behind_the_pyramid,
    the_occluder_hides_nothing_where_the_shell_is_torn,
    an_occluder_that_comes_later_hides_as_much,
}
