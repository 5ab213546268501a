//! What flickers, against cases worked out by hand: surfaces are carried to where they are, a
//! planted pop is found, and what only moves is not one. Pixels that sort for themselves differ
//! where Gaussians pass through each other, and nowhere else.

use crate::common::{self, Sizes};
use effigy_core::{
    avatar::{Avatar, Facing, Filter},
    reference::{
        self, Carried, Gaussian, Sorting, SurfaceView, carry, drawn_rect, gaussians_of, project,
        render_sorted,
    },
    scene::{Camera, FrameImage, PixelRect, Posed},
};
use effigy_measure::flicker::{Carrying, ImagePart, carrying::SurfaceFrame};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3, UVec2};

/// At the origin, looks along +z; pixel 32, 32 has the axis at its centre.
fn camera() -> Camera {
    Camera {
        view: DAffine3::IDENTITY,
        focal: DVec2::splat(100.0),
        center: DVec2::splat(32.5),
        size: [65, 65],
        near: Camera::NEAR,
    }
}

/// A disc, two metres away, that faces the camera before it is turned: 8 px in deviation across, 6
/// down.
fn disc(at: DVec3, turned: DQuat, color: DVec3, opacity: u8) -> Gaussian {
    Gaussian {
        mean: at + 2.0 * DVec3::Z,
        axes: DMat3::from_quat(turned) * DMat3::from_diagonal(DVec3::new(0.16, 0.12, 0.001)),
        color,
        opacity,
        facing: Facing::EVERYWHERE,
    }
}

fn view<'a>(gaussians: &'a [Gaussian], camera: &'a Camera) -> SurfaceView<'a> {
    SurfaceView {
        gaussians,
        camera,
        filter: Filter::DEFAULT,
    }
}

fn frame<'a>(gaussians: &'a [Gaussian], camera: &'a Camera) -> SurfaceFrame<'a> {
    SurfaceFrame {
        view: view(gaussians, camera),
        rect: PixelRect::whole(camera.size),
    }
}

fn image(gaussians: &[Gaussian], camera: &Camera, sorting: Sorting) -> FrameImage {
    render_sorted(gaussians, camera, Filter::DEFAULT, sorting)
}

fn part(image: &FrameImage) -> ImagePart {
    ImagePart::of(image, PixelRect::whole(image.size))
}

/// The reference's image of Gaussians.
fn drawn(gaussians: &[Gaussian], camera: &Camera) -> ImagePart {
    part(&image(gaussians, camera, Sorting::Centers))
}

fn at(pixels: &[Carried], x: usize, y: usize) -> &Carried {
    &pixels[65 * y + x]
}

/// A body from a seed as a camera in front of it sees it.
fn body(avatar: &Avatar, camera: &Camera) -> Vec<Gaussian> {
    let posed = Posed::new(avatar, &common::pose(2, avatar));
    gaussians_of(avatar, &[&posed], camera)
}

fn before_the_body(yaw: f64) -> Camera {
    Camera::orbit(DVec3::Y, yaw, 0.1, 3.5, 0.6, [240, 320])
}

fn small_body() -> Avatar {
    common::avatar(
        3,
        Sizes {
            gaussians: 6000,
            ..Sizes::default()
        },
    )
}

fn a_point_of_a_disc_goes_where_the_disc_takes_it() {
    let camera = camera();
    let before = [disc(DVec3::ZERO, DQuat::IDENTITY, DVec3::X, 255)];
    // A quarter turn to the right as the image shows it, and 10 px to the right.
    let turned = DQuat::from_rotation_z(90f64.to_radians());
    let after = [disc(DVec3::new(0.2, 0.0, 0.0), turned, DVec3::X, 255)];
    let pixels = carry(
        &view(&before, &camera),
        &view(&after, &camera),
        PixelRect::whole(camera.size),
        1,
    );
    for (x, y) in [(32, 32), (40, 32), (32, 38), (27, 30)] {
        let from = DVec2::new(x as f64 - 32.0, y as f64 - 32.0);
        let expected = DVec2::new(32.5 + 10.0 - from.y, 32.5 + from.x);
        let got = at(&pixels, x, y);
        let missed = DVec2::new(got.at[0].into(), got.at[1].into()).distance(expected);
        assert!(
            missed < 0.02,
            "({x}, {y}) came to {:?}, not {expected}",
            got.at
        );
        assert!((got.depth - 2.0).abs() < 2e-3 && (got.depth_there - 2.0).abs() < 2e-3);
        assert!(got.spread < 1e-3 && got.coverage > 0.5, "{got:?}");
    }
    assert_eq!(*at(&pixels, 0, 0), Carried::default());
}

fn several_rays_a_pixel_find_the_same_way_and_finer_edges() {
    let camera = camera();
    let before = [disc(DVec3::ZERO, DQuat::IDENTITY, DVec3::X, 255)];
    let after = [disc(
        DVec3::new(0.05, 0.03, 0.1),
        DQuat::from_rotation_y(0.2),
        DVec3::X,
        255,
    )];
    let rect = PixelRect {
        min: UVec2::new(10, 12),
        max: UVec2::new(61, 59),
    };
    let [one, four] = [1, 4].map(|samples| {
        carry(
            &view(&before, &camera),
            &view(&after, &camera),
            rect,
            samples,
        )
    });
    assert_eq!([one.len(), four.len()], [51 * 47; 2]);
    let mut compared = 0;
    for (one, four) in one.iter().zip(&four).filter(|(one, _)| one.coverage > 0.3) {
        let apart = (one.at[0] - four.at[0]).hypot(one.at[1] - four.at[1]);
        assert!(
            apart < 0.05 && (one.depth - four.depth).abs() < 0.01,
            "{one:?}, {four:?}"
        );
        assert!((one.coverage - four.coverage).abs() < 0.05);
        compared += 1;
    }
    assert!(compared > 300, "{compared}");
}

fn what_moves_by_whole_pixels_leaves_no_residual() {
    let avatar = small_body();
    let camera = before_the_body(0.3);
    let moved = Camera {
        center: camera.center + DVec2::new(5.0, -3.0),
        ..camera
    };
    let gaussians = body(&avatar, &camera);
    let carrying = Carrying::new(&frame(&gaussians, &camera), &frame(&gaussians, &moved), 1);
    let residual = carrying.residual(
        &drawn(&gaussians, &camera),
        &drawn(&gaussians, &moved),
        true,
    );
    let summary = residual.summary();
    // Places are f32: up to 2⁻¹⁶ px off.
    assert!(
        summary.max < 2e-4 && summary.flip < Some(1e-3),
        "{summary:?}"
    );
    let share = carrying.compared() as f64 / carrying.covered() as f64;
    assert!(share > 0.97 && carrying.covered() > 5000, "{share}");
}

fn a_body_that_turns_as_a_whole_has_nearly_no_residual() {
    let avatar = small_body();
    let [before, after] = [0.3, 0.3 + 0.5f64.to_radians()].map(before_the_body);
    let gaussians = body(&avatar, &before);
    let carrying = Carrying::new(&frame(&gaussians, &before), &frame(&gaussians, &after), 1);
    let images = [&before, &after].map(|camera| drawn(&gaussians, camera));
    let carried = carrying.residual(&images[0], &images[1], false).summary();
    let share = carrying.compared() as f64 / carrying.covered() as f64;
    assert!(share > 0.9, "{share} is compared");
    // What is left if nothing is carried.
    let error = effigy_measure::error::between(&images[0].image, &images[1].image);
    let still = 10f64.powf(-error.covered.psnr_db / 20.0);
    assert!(
        carried.mean < 0.004 && carried.mean < 0.3 * still,
        "{carried:?}, {still} without carrying"
    );
}

fn a_planted_pop_is_found_and_an_error_that_stays_is_none() {
    let avatar = small_body();
    let camera = before_the_body(0.3);
    let shift = [4, 7];
    let moved = Camera {
        center: camera.center + DVec2::new(4.0, 7.0),
        ..camera
    };
    let gaussians = body(&avatar, &camera);
    let carrying = Carrying::new(&frame(&gaussians, &camera), &frame(&gaussians, &moved), 1);
    let before = image(&gaussians, &camera, Sorting::Centers);
    let after = image(&gaussians, &moved, Sorting::Centers);
    let reference = carrying.residual(&part(&before), &part(&after), true);
    // Nine pixels of the chest that get brighter or darker.
    let wrong = |image: &FrameImage, shift: [usize; 2]| {
        let mut image = image.clone();
        for k in 0..9 {
            let column = 120 + k % 3 + shift[0];
            let row = 130 + k / 3 + shift[1];
            let red = &mut image.pixels[240 * row + column][0];
            *red += if *red < 0.5 { 0.25 } else { -0.25 };
        }
        part(&image)
    };
    let popped = carrying.residual(&part(&before), &wrong(&after, shift), true);
    let added = popped.added_to(&reference);
    assert!((added.max - 0.25).abs() < 1.01 / 255.0, "{added:?}");
    let expected = 9.0 * 0.25 / carrying.compared() as f64;
    assert!(
        (added.mean - expected).abs() < 1e-4,
        "{added:?}, expected {expected}"
    );
    let [own, with] = [&reference, &popped].map(|residual| residual.summary());
    assert!(
        with.mean > own.mean && with.flip > own.flip,
        "{own:?}, {with:?}"
    );
    let stays = carrying.residual(&wrong(&before, [0, 0]), &wrong(&after, shift), true);
    let added = stays.added_to(&reference);
    assert!(
        added.max < 2.01 / 255.0 && added.mean < 0.1 * expected,
        "{added:?}"
    );
}

fn what_comes_from_behind_something_is_not_compared() {
    let camera = camera();
    let wall = Gaussian {
        axes: DMat3::from_diagonal(DVec3::new(2.0, 2.0, 0.001)),
        ..disc(DVec3::Z, DQuat::IDENTITY, DVec3::Y, 255)
    };
    let hand = |x: f64| disc(DVec3::new(x, 0.0, 0.0), DQuat::IDENTITY, DVec3::X, 255);
    let before = [wall, hand(-0.2)];
    let after = [wall, hand(0.2)];
    let carrying = Carrying::new(&frame(&before, &camera), &frame(&after, &camera), 1);
    let images = [&before, &after].map(|gaussians| drawn(gaussians, &camera));
    let residual = carrying.residual(&images[0], &images[1], false).summary();
    assert!(residual.max < 0.1, "{residual:?}");
    // Where the hand was, and its soft edges through which the wall shows, drop out.
    let compared = carrying.compared() as f64 / carrying.covered() as f64;
    assert!((0.3..0.6).contains(&compared), "{compared}");
}

fn pixels_that_sort_for_themselves_differ_where_discs_cross() {
    let camera = camera();
    let turned = 40f64.to_radians();
    // Left of the middle the second is nearer, right of it the first. Its centre is a bit nearer.
    let first = disc(DVec3::ZERO, DQuat::from_rotation_y(turned), DVec3::X, 200);
    let second = disc(
        0.002 * DVec3::Z,
        DQuat::from_rotation_y(-turned),
        DVec3::Y,
        200,
    );
    for gaussians in [[first, second], [second, first]] {
        let [centers, exact] =
            [Sorting::Centers, Sorting::PerPixel].map(|by| image(&gaussians, &camera, by));
        let mut seen = [0; 2];
        for (k, (center, exact)) in centers.pixels.iter().zip(&exact.pixels).enumerate() {
            let x = k % 65;
            if exact[3] < 0.5 || x.abs_diff(32) < 3 {
                continue;
            }
            // The side on which the second is nearer is that on which the two differ.
            assert_eq!(center == exact, x > 32, "column {x}: {center:?}, {exact:?}");
            assert_eq!(exact[0] > exact[1], x > 32, "column {x}: {exact:?}");
            seen[usize::from(x > 32)] += 1;
        }
        assert!(seen.iter().all(|&pixels| pixels > 30), "{seen:?}");
    }
}

fn pixels_that_sort_for_themselves_see_parallel_discs_alike() {
    let camera = camera();
    let turned = DQuat::from_rotation_y(0.5);
    let stack: Vec<Gaussian> = (0..5)
        .map(|k| {
            let color = DVec3::new(f64::from(k % 2), 0.2 * f64::from(k), 0.5);
            let behind = turned * DVec3::Z * 0.02 * f64::from((k * 3) % 5);
            disc(behind, turned, color, 150)
        })
        .collect();
    let [centers, exact] =
        [Sorting::Centers, Sorting::PerPixel].map(|by| image(&stack, &camera, by));
    assert_eq!(centers, exact);
    // Of one depth everywhere, too: the first is drawn first.
    let twins = [DVec3::X, DVec3::Y].map(|color| disc(DVec3::ZERO, turned, color, 150));
    let [centers, exact] =
        [Sorting::Centers, Sorting::PerPixel].map(|by| image(&twins, &camera, by));
    assert_eq!(centers, exact);
}

fn a_body_covers_as_much_in_any_order() {
    let avatar = small_body();
    let camera = before_the_body(1.1);
    let gaussians = body(&avatar, &camera);
    let [centers, exact] =
        [Sorting::Centers, Sorting::PerPixel].map(|by| image(&gaussians, &camera, by));
    let mut differ = 0;
    for (center, exact) in centers.pixels.iter().zip(&exact.pixels) {
        assert!((center[3] - exact[3]).abs() < 1e-6, "{center:?}, {exact:?}");
        differ += usize::from(center != exact);
    }
    assert!(differ > 100, "{differ} pixels differ");
    let splats = project::splats(&gaussians, &camera, Filter::DEFAULT, 0);
    let rect = drawn_rect(&splats, 1.0, camera.size);
    let inside = |k: usize| {
        let at = UVec2::new(k as u32 % 240, k as u32 / 240);
        at.cmpge(rect.min).all() && at.cmplt(rect.max).all()
    };
    let outside = (0..centers.pixels.len()).filter(|&k| !inside(k));
    assert!(outside.clone().count() > 1000);
    assert!(outside.into_iter().all(|k| centers.pixels[k] == [0.0; 4]));
    let cropped = camera.cropped(rect);
    let crop = reference::render_gaussians(&gaussians, &cropped, Filter::DEFAULT);
    let expected = ImagePart::of(&centers, rect).image;
    let apart = |(a, b): (&[f32; 4], &[f32; 4])| (0..4).all(|k| (a[k] - b[k]).abs() < 1e-6);
    assert!(crop.pixels.iter().zip(&expected.pixels).all(apart));
}

tests! {
    a_point_of_a_disc_goes_where_the_disc_takes_it,
    several_rays_a_pixel_find_the_same_way_and_finer_edges,
    what_moves_by_whole_pixels_leaves_no_residual,
    a_body_that_turns_as_a_whole_has_nearly_no_residual,
    a_planted_pop_is_found_and_an_error_that_stays_is_none,
    what_comes_from_behind_something_is_not_compared,
    pixels_that_sort_for_themselves_differ_where_discs_cross,
    pixels_that_sort_for_themselves_see_parallel_discs_alike,
    a_body_covers_as_much_in_any_order,
}
