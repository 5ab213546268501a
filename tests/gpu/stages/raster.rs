//! The `raster` stage: the draw order that it uses, and images of few Gaussians whose every pixel
//! the reference knows.

use crate::common::{
    self, Sizes,
    gpu::{
        self,
        Raster::{self, CooperativeTiles, Quads, SharedTiles, TestedQuads},
    },
};
use effigy_core::{
    avatar::Avatar,
    frame::Skip,
    layout::{BinLists, TILE_LEVELS, TILING},
    reference::{ReferenceFrame, binning},
    scene::{Camera, Posed},
};
use effigy_measure::error;
use effigy_render::vulkan::{Renderer, RendererOptions, raster::RasterMethod};
use glam::DVec3;
use half::f16;

fn the_order_is_the_references_but_for_depths_closer_than_a_key() {
    let device = gpu::gpu();
    // Without displacements of nodes, which the device rounds.
    let mut avatar = common::avatar(5, Sizes::default());
    avatar.nodes.basis.halves_mut().fill(f16::ZERO);
    avatar.nodes.offset.fill([f16::ZERO; 3]);
    let posed = Posed::new(&avatar, &common::pose(6, &avatar));
    let camera = gpu::camera(&avatar, &posed, [200, 200]);
    let frame = gpu::draw(&device, avatar, posed, camera, gpu::options([200, 200]));
    let depth = |at: u32| {
        frame.reference.splats[at as usize]
            .as_ref()
            .map(|splat| splat.depth)
            .unwrap_or(f64::NAN)
    };
    // A key over the avatar's depth, 3 m at most, or f32's resolution there.
    let step = 2e-6;
    for pair in frame.gpu.order.windows(2) {
        assert!(
            depth(pair[0]) >= depth(pair[1]) - step,
            "{} at {} m is drawn before {} at {} m",
            pair[0],
            depth(pair[0]),
            pair[1],
            depth(pair[1])
        );
        assert!(
            depth(pair[0]) != depth(pair[1]) || pair[0] < pair[1],
            "equal depths of {} and {} changed order",
            pair[0],
            pair[1]
        );
    }
    assert_eq!(frame.gpu.order.len(), frame.reference.order.len());
}

/// Where an avatar's first Gaussian is in a pose, metres.
fn first_gaussian(avatar: &Avatar, posed: &Posed) -> DVec3 {
    let camera = gpu::camera(avatar, posed, [64, 64]);
    ReferenceFrame::new(avatar, posed, &camera).gaussians[0].mean
}

fn few_gaussians_agree_pixel_by_pixel(raster: Raster) {
    let device = gpu::gpu();
    let options = raster.options(&device.probe.name, [240, 160]);
    for seed in 0..6 {
        let sizes = Sizes {
            gaussians: 1 + seed as usize * 3,
            parts: 1,
            nodes: 1,
            rows: 1,
            ..Sizes::default()
        };
        let avatar = common::avatar(seed, sizes);
        let posed = Posed::new(&avatar, &common::pose(seed, &avatar));
        let target = first_gaussian(&avatar, &posed);
        let camera = Camera::orbit(target, 0.2, 0.1, 0.3, 0.6, [240, 160]);
        let frame = gpu::draw(&device, avatar, posed, camera, options);
        let error = error::between(&frame.image, &frame.reference.canvas.to_image());
        assert!(
            error.covered.pixels > 100,
            "seed {seed}: nothing in the image"
        );
        assert!(
            error.covered.max_error < 4.0 / 255.0 && error.covered.psnr_db > 54.0,
            "seed {seed}, {options:?}: {:?}",
            error.covered
        );
    }
}

fn nothing_of_many_gaussians_is_lost() {
    let device = gpu::gpu();
    // Old builds of llvmpipe leave loops after 65,535 rounds: with tiles they lose most of this
    // body, so they must not have that default.
    let avatar = common::avatar(
        9,
        Sizes {
            gaussians: 250_000,
            ..Sizes::default()
        },
    );
    let posed = Posed::new(&avatar, &common::pose(9, &avatar));
    let camera = gpu::camera(&avatar, &posed, [256, 256]);
    let options = RendererOptions {
        skip: Skip::empty(),
        ..gpu::options([256, 256])
    };
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    renderer.draw(&posed, &camera, None).unwrap();
    let error = error::between(
        &renderer.read_image().unwrap(),
        &effigy_core::reference::render(&avatar, &posed, &camera),
    );
    let drawn = renderer.report().counters.drawn;
    assert!(drawn > 225_000, "{drawn} drawn");
    assert!(
        error.covered.psnr_db > 40.0,
        "{:?}: {:?}",
        renderer.raster().method(),
        error.covered
    );
}

/// A driver that ends whoever draws triangles is not made to.
fn quads_are_refused_where_the_driver_crashes_on_triangles() {
    let device = gpu::gpu();
    let avatar = common::avatar(9, Sizes::default());
    let made = Renderer::new(
        &device,
        &avatar,
        RendererOptions {
            method: Some(RasterMethod::Quads),
            ..gpu::options([64, 64])
        },
    );
    match made.map(|_| ()) {
        Ok(()) => assert!(device.probe.draws_triangles()),
        Err(error) => assert!(
            !device.probe.draws_triangles()
                && matches!(error, effigy_render::vulkan::Error::NoTriangles { .. }),
            "{error}"
        ),
    }
}

fn nothing_in_view_is_an_empty_image(raster: Raster) {
    let device = gpu::gpu();
    let avatar = common::avatar(1, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(1, &avatar));
    let away = Camera::look_at(
        DVec3::new(0.0, 1.0, 5.0),
        DVec3::new(0.0, 1.0, 9.0),
        0.7,
        [50, 40],
    );
    let options = raster.options(&device.probe.name, [50, 40]);
    let frame = gpu::draw(&device, avatar, posed, away, options);
    assert_eq!(frame.gpu.control.visible_count, 0);
    assert!(
        frame.image.pixels.iter().all(|&pixel| pixel == [0.0; 4]),
        "{options:?}"
    );
}

fn images_of_any_size_follow_a_resize(raster: Raster) {
    let device = gpu::gpu();
    let avatar = common::avatar(
        2,
        Sizes {
            gaussians: 500,
            ..Sizes::default()
        },
    );
    let posed = Posed::new(&avatar, &common::pose(2, &avatar));
    let options = raster.options(&device.probe.name, [64, 64]);
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    for size in [[1, 1], [7, 300], [640, 3], [200, 200]] {
        renderer.resize(size).unwrap();
        let camera = gpu::camera(&avatar, &posed, size);
        renderer.draw(&posed, &camera, None).unwrap();
        let reference = effigy_core::reference::render(&avatar, &posed, &camera);
        let error = error::between(&renderer.read_image().unwrap(), &reference);
        assert!(
            error.whole.psnr_db > 54.0,
            "{size:?}, {options:?}: {:?}",
            error.whole
        );
    }
    let message = renderer.resize([0, 5]).unwrap_err().to_string();
    assert!(message.contains("0 × 5"), "{message}");
    assert_eq!(
        renderer.raster().image().size(),
        [200, 200],
        "the old image stays"
    );
}

fn each_tile_has_the_splats_that_meet_it_nearest_first() {
    let device = gpu::gpu();
    // From far, and so near that some Gaussians, then most, meet too many of the finest tiles, and
    // of coarser ones.
    for (distance, coarsest) in [(4.0, 0), (1.5, 1), (0.6, 2), (0.1, 2)] {
        let avatar = common::avatar(
            4,
            Sizes {
                gaussians: 700,
                ..Sizes::default()
            },
        );
        let posed = Posed::new(&avatar, &common::pose(4, &avatar));
        let target = first_gaussian(&avatar, &posed);
        let size = [600, 400];
        let camera = Camera::orbit(target, 0.3, 0.1, distance, 0.7, size);
        let options = CooperativeTiles.options(&device.probe.name, size);
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        renderer.draw(&posed, &camera, None).unwrap();
        let bins = renderer.raster().tile_lists().unwrap().unwrap();
        let order = renderer.stages().unwrap().order;
        let reference = ReferenceFrame::new(&avatar, &posed, &camera);
        let place = |splat: &u32| order.iter().position(|other| other == splat).unwrap();
        let side = TILING.tile(size);
        let mut met = [0; TILE_LEVELS as usize];
        for tile in (0..size[1].div_ceil(side))
            .flat_map(|row| (0..size[0].div_ceil(side)).map(move |column| [column, row]))
        {
            let levels = bins.at(tile);
            for (level, chain) in levels.iter().enumerate() {
                assert!(
                    chain
                        .windows(2)
                        .all(|pair| place(&pair[0]) > place(&pair[1])),
                    "tile {tile:?}, level {level}: not near to far"
                );
                let (coarse, side) = (tile.map(|v| v >> (2 * level)), side << (2 * level));
                let most = binning::bin(&reference.splats, &order, coarse, side, 0.05);
                // The outermost tiles of the bins have what lies outside too; the image's own
                // edges do not matter here.
                let inner = coarse[0] > 0 && coarse[1] > 0;
                let surplus: Vec<_> = chain
                    .iter()
                    .filter(|splat| inner && !most.contains(splat))
                    .collect();
                assert!(
                    surplus.is_empty(),
                    "tile {tile:?}, level {level}, from {distance} m: need not have {surplus:?}"
                );
                met[level] += chain.len();
            }
            let mut all = levels.concat();
            all.sort_unstable();
            assert!(
                all.windows(2).all(|pair| pair[0] != pair[1]),
                "tile {tile:?} from {distance} m has a splat twice"
            );
            let must_meet = binning::bin(&reference.splats, &order, tile, side, -0.05);
            let missing: Vec<_> = must_meet
                .into_iter()
                .filter(|splat| all.binary_search(splat).is_err())
                .collect();
            assert!(
                missing.is_empty(),
                "tile {tile:?} from {distance} m lacks {missing:?}"
            );
        }
        assert!(
            met[coarsest] > 100 && met[coarsest + 1..].iter().all(|&met| met == 0),
            "from {distance} m: {met:?} at the levels"
        );
    }
}

/// Distances, poses and cameras in which [`avatar_in_bins`] is seen, some so near that the pairs of
/// splats and bins are too many for the finest bins.
pub fn views_of_bins(avatar: &Avatar) -> impl Iterator<Item = (f64, Posed, Camera)> {
    [4.0, 0.6, 0.1].into_iter().map(|distance| {
        let posed = Posed::new(avatar, &common::pose(4, avatar));
        let target = first_gaussian(avatar, &posed);
        let camera = Camera::orbit(target, 0.3, 0.1, distance, 0.7, [600, 400]);
        (distance, posed, camera)
    })
}

/// One of few Gaussians, for [`views_of_bins`].
pub fn avatar_in_bins() -> Avatar {
    common::avatar(
        4,
        Sizes {
            gaussians: 4000,
            ..Sizes::default()
        },
    )
}

/// Every bin must have the splats whose boxes meet it, in the drawing order.
/// `distance`: of the camera, metres.
pub fn check_bins(bins: &BinLists, order: &[u32], reference: &ReferenceFrame, distance: f64) {
    let mut met = 0;
    for (number, list) in (0..).zip(&bins.lists) {
        let bin = [number % bins.columns, number / bins.columns];
        // Near splats are large, and so is what rounding their axes moves their edges by.
        let rounding = 0.3 / distance;
        let [must, may] = [-rounding, rounding]
            .map(|slack| binning::bin(&reference.splats, order, bin, bins.side, slack));
        // Both are in the drawing order: what must be there is a subsequence of the list, and the
        // list one of what may be there.
        let mut rest = list.iter();
        let missing = must.iter().find(|splat| !rest.any(|other| other == *splat));
        assert_eq!(missing, None, "bin {bin:?} from {distance} m");
        let mut rest = may.iter();
        let surplus = list.iter().find(|splat| !rest.any(|other| other == *splat));
        assert_eq!(surplus, None, "bin {bin:?} from {distance} m");
        met += list.len();
    }
    assert!(met > 100, "{met} pairs from {distance} m");
}

fn each_bin_has_the_splats_that_meet_it_nearest_first(raster: Raster) {
    let device = gpu::gpu();
    let mut sides = Vec::new();
    let avatar = avatar_in_bins();
    for (distance, posed, camera) in views_of_bins(&avatar) {
        let options = raster.options(&device.probe.name, camera.size);
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        renderer.draw(&posed, &camera, None).unwrap();
        renderer.finish().unwrap();
        let bins = renderer.raster().bin_lists().unwrap().unwrap();
        let order = renderer.stages().unwrap().order;
        let reference = ReferenceFrame::new(&avatar, &posed, &camera);
        check_bins(&bins, &order, &reference, distance);
        sides.push(bins.side);
    }
    assert!(sides.contains(&32) && sides.contains(&64), "{sides:?}");
}

fn frames_in_flight_do_not_show_in_each_other(raster: Raster) {
    let device = gpu::gpu();
    let avatar = common::avatar(
        6,
        Sizes {
            gaussians: 3000,
            ..Sizes::default()
        },
    );
    let posed: Vec<_> = (0..5)
        .map(|seed| Posed::new(&avatar, &common::pose(seed, &avatar)))
        .collect();
    let size = [220, 220];
    let options = raster.options(&device.probe.name, size);
    let alone = |posed| {
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        renderer
            .draw(posed, &gpu::camera(&avatar, posed, size), None)
            .unwrap();
        renderer.read_image().unwrap()
    };
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    for last in 0..posed.len() {
        for posed in posed.iter().cycle().skip(last).take(posed.len() + 1) {
            renderer
                .draw(posed, &gpu::camera(&avatar, posed, size), None)
                .unwrap();
        }
        assert!(
            renderer.read_image().unwrap() == alone(&posed[last]),
            "image {last} depends on those before it, {options:?}"
        );
    }
}

fn two_runs_give_the_same_bits(raster: Raster) {
    let device = gpu::gpu();
    let options = raster.options(&device.probe.name, [160, 160]);
    let [first, second] = [0, 1].map(|_| gpu::frame(&device, 9, Sizes::default(), options));
    assert!(first.image == second.image, "two runs differ, {options:?}");
}

tests! {
    each_bin_has_the_splats_that_meet_it_nearest_first[TestedQuads],
    each_bin_has_the_splats_that_meet_it_nearest_first[SharedTiles],
    the_order_is_the_references_but_for_depths_closer_than_a_key,
    few_gaussians_agree_pixel_by_pixel[Quads]: smoke,
    few_gaussians_agree_pixel_by_pixel[CooperativeTiles]: smoke,
    few_gaussians_agree_pixel_by_pixel[TestedQuads]: smoke,
    few_gaussians_agree_pixel_by_pixel[SharedTiles]: smoke,
    nothing_of_many_gaussians_is_lost,
    quads_are_refused_where_the_driver_crashes_on_triangles,
    nothing_in_view_is_an_empty_image[Quads],
    nothing_in_view_is_an_empty_image[CooperativeTiles],
    nothing_in_view_is_an_empty_image[TestedQuads],
    nothing_in_view_is_an_empty_image[SharedTiles],
    images_of_any_size_follow_a_resize[Quads],
    images_of_any_size_follow_a_resize[CooperativeTiles],
    images_of_any_size_follow_a_resize[TestedQuads],
    images_of_any_size_follow_a_resize[SharedTiles],
    each_tile_has_the_splats_that_meet_it_nearest_first,
    frames_in_flight_do_not_show_in_each_other[Quads],
    frames_in_flight_do_not_show_in_each_other[CooperativeTiles],
    frames_in_flight_do_not_show_in_each_other[TestedQuads],
    frames_in_flight_do_not_show_in_each_other[SharedTiles],
    two_runs_give_the_same_bits[Quads],
    two_runs_give_the_same_bits[CooperativeTiles],
    two_runs_give_the_same_bits[TestedQuads],
    two_runs_give_the_same_bits[SharedTiles],
}
