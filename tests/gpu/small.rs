//! Avatars that are drawn larger than they are shown, against the reference's average; and which
//! avatars go before and behind which. Of either backend.

use crate::common::{self, Sizes, gpu::Raster};
use effigy_core::{
    avatar::{Avatar, Filter},
    frame::{FrameReport, RendererOptions, Skip},
    layout::RASTER_REGION,
    reference,
    scene::{AvatarBounds, Camera, FrameImage, Posed, Supersampling, supersampling::DRAWN_SIDE},
};
use effigy_measure::error;
use glam::{DAffine3, DVec3};
use half::f16;

/// A renderer of either backend.
pub trait Renders: Sized {
    /// The device's name.
    fn device() -> String;
    fn make(avatar: &Avatar, options: RendererOptions) -> Self;
    fn draw_all(&mut self, poses: &[&Posed], camera: &Camera);
    fn image(&mut self) -> FrameImage;
    /// Of the frame whose image was read.
    fn report(&self) -> FrameReport;
}

/// These tests as those of a backend, by the type of its renderer.
macro_rules! check_with {
    ($renderer:ty) => {
        check_with! {
            $renderer:
            a_small_avatar_is_its_own_average,
            small_avatars_go_before_and_behind_large_ones,
            small_avatars_that_touch_are_sorted_together,
            any_factor_is_averaged_by_area,
            no_switch_is_seen,
            frames_leave_nothing_behind,
            what_faint_saves_cuts_nothing_off,
            frames_show_the_same_whatever_came_before,
            levels_are_drawn_as_avatars,
            levels_have_samples_of_their_own,
            levels_have_their_own_harmonics,
        }
    };
    ($renderer:ty: $($name:ident),+ $(,)?) => {
        $(fn $name(raster: Raster) {
            $crate::small::$name::<$renderer>(raster);
        })+
    };
}

const SIZE: [u32; 2] = [320, 240];
/// An image in which an avatar may be large.
pub const LARGE: [u32; 2] = [720, 630];

/// A small avatar, and a camera that sees it from a distance in metres.
pub fn scene(distance: f64, size: [u32; 2]) -> (Avatar, Camera) {
    let avatar = common::avatar(
        4,
        Sizes {
            gaussians: 3001,
            ..Sizes::default()
        },
    );
    let camera = Camera::orbit(DVec3::new(0.0, 0.9, 0.0), 0.3, 0.1, distance, 0.7, size);
    (avatar, camera)
}

/// In a pose, at a place in the camera's axes: to the right, up and away from it, metres.
pub fn posed(avatar: &Avatar, camera: &Camera, seed: u64, place: DVec3) -> Posed {
    let axes = camera.view.matrix3.transpose();
    let world = place.x * axes.x_axis - place.y * axes.y_axis + place.z * axes.z_axis;
    Posed::new(avatar, &common::pose(seed, avatar)).placed(DAffine3::from_translation(world))
}

/// What a renderer draws of some avatars, the second time: the first frame makes the atlas.
pub fn drawn<R: Renders>(
    avatar: &Avatar,
    poses: &[&Posed],
    camera: &Camera,
    options: RendererOptions,
) -> (FrameImage, FrameReport) {
    let options = RendererOptions {
        instances: poses.len(),
        count: true,
        ..options
    };
    let mut renderer = R::make(avatar, options);
    let aside = Camera {
        center: camera.center + 9.0,
        ..*camera
    };
    renderer.draw_all(poses, &aside);
    renderer.draw_all(poses, camera);
    (renderer.image(), renderer.report())
}

pub fn supersampled<R: Renders>(
    raster: Raster,
    camera: &Camera,
    factor: Supersampling,
) -> RendererOptions {
    RendererOptions {
        supersampling: factor,
        ..raster.options(&R::device(), camera.size)
    }
}

pub fn assert_near(what: &str, image: &FrameImage, expected: &FrameImage, psnr: f64) {
    let error = error::between(image, expected).covered;
    assert!(
        error.pixels > 100 && error.psnr_db >= psnr,
        "{what}: {error:?}"
    );
}

/// Faint Gaussians that networks move to the edges of their slot: those whose visible part is all
/// inside are drawn, whether or not quads are only as large as that.
pub fn what_faint_saves_cuts_nothing_off<R: Renders>(raster: Raster) {
    let (mut avatar, camera) = scene(9.0, SIZE);
    avatar.gaussians.opacity.fill(30);
    avatar.gaussians.log_scale.fill([f16::from_f64(-3.0); 3]);
    for number in avatar.nodes.basis.halves_mut() {
        *number = f16::from_f64(200.0 * number.to_f64());
    }
    let posed = posed(&avatar, &camera, 3, DVec3::ZERO);
    let options = supersampled::<R>(raster, &camera, Supersampling::Times(2));
    let [with, without] = [Skip::all(), Skip::all() - Skip::FAINT].map(|skip| {
        let options = RendererOptions { skip, ..options };
        drawn::<R>(&avatar, &[&posed], &camera, options).0
    });
    assert_near("without faint", &without, &with, 50.0);
}

/// In the middle, and where the image cuts it off.
pub fn a_small_avatar_is_its_own_average<R: Renders>(raster: Raster) {
    let (avatar, camera) = scene(9.0, SIZE);
    for (factor, place) in [
        (4, DVec3::ZERO),
        (2, DVec3::new(0.3, 0.2, 0.0)),
        (4, DVec3::new(4.2, 0.4, 0.0)),
        (2, DVec3::new(-4.0, 3.0, 0.0)),
    ] {
        let posed = posed(&avatar, &camera, 3, place);
        let options = supersampled::<R>(raster, &camera, Supersampling::Times(factor));
        let (image, report) = drawn::<R>(&avatar, &[&posed], &camera, options);
        let expected = reference::render_supersampled(
            &avatar,
            &[&posed],
            &camera,
            factor,
            Filter::SUPERSAMPLED,
        );
        let what = format!("{factor} times at {place}");
        assert_near(&what, &image, &expected, 48.0);
        assert_eq!(report.counters.supersampled, 1);
        assert!(report.counters.drawn > 0 && report.counters.fragments != Some(0));
        // As large as it is shown it is another image.
        let once = reference::render(&avatar, &posed, &camera);
        assert!(error::between(&image, &once).covered.psnr_db < 40.0);
    }
}

/// One near avatar, one far before it, and one far behind; in any order of poses.
pub fn small_avatars_go_before_and_behind_large_ones<R: Renders>(raster: Raster) {
    let (avatar, camera) = scene(2.6, LARGE);
    let near = posed(&avatar, &camera, 1, DVec3::ZERO);
    // A doll on the left before the near one, and a giant's distance behind it on the right.
    let at = camera
        .view
        .inverse()
        .transform_point3(DVec3::new(-0.1, 0.1, 1.2));
    let to = DAffine3::from_translation(at - DVec3::new(0.0, 0.9 * 0.1, 0.0));
    let doll = posed(&avatar, &camera, 2, DVec3::ZERO)
        .placed(to * DAffine3::from_scale(DVec3::splat(0.1)));
    let far = posed(&avatar, &camera, 3, DVec3::new(1.0, 0.5, 12.0));
    let options = supersampled::<R>(raster, &camera, Supersampling::BySize);
    let large = reference::render(&avatar, &near, &camera);
    let average = |posed: &Posed| {
        let factor = 4;
        reference::render_supersampled(&avatar, &[posed], &camera, factor, Filter::SUPERSAMPLED)
    };
    let expected = average(&doll)
        .blended_over(&large)
        .blended_over(&average(&far));
    for poses in [
        [&near, &doll, &far],
        [&far, &near, &doll],
        [&doll, &far, &near],
    ] {
        let (image, report) = drawn::<R>(&avatar, &poses, &camera, options);
        assert_eq!(report.counters.supersampled, 2);
        assert_near("three avatars", &image, &expected, 46.0);
        let stages: Vec<_> = report.stages.iter().map(|stage| stage.0).collect();
        if !stages.is_empty() {
            let sorts = stages.iter().filter(|stage| **stage == "sort").count();
            assert!(sorts == 2 && stages.ends_with(&["resolve"]), "{stages:?}");
        }
    }
}

/// Two that may pass through each other are sorted together; a third stands apart.
pub fn small_avatars_that_touch_are_sorted_together<R: Renders>(raster: Raster) {
    let (avatar, camera) = scene(10.0, SIZE);
    let poses = [
        posed(&avatar, &camera, 1, DVec3::ZERO),
        posed(&avatar, &camera, 2, DVec3::new(0.3, 0.0, 0.1)),
        posed(&avatar, &camera, 3, DVec3::new(2.5, 0.0, 0.0)),
    ];
    let poses = poses.each_ref();
    let options = supersampled::<R>(raster, &camera, Supersampling::Times(4));
    let (image, report) = drawn::<R>(&avatar, &poses, &camera, options);
    let expected =
        reference::render_supersampled(&avatar, &poses, &camera, 4, Filter::SUPERSAMPLED);
    assert_eq!(report.counters.supersampled, 3);
    assert_near("three avatars", &image, &expected, 48.0);
}

/// A camera that shows a posed avatar with this longest side, px.
pub fn camera_at(avatar: &Avatar, posed: &Posed, side: f64) -> Camera {
    let bounds = AvatarBounds::new(avatar);
    let camera = |distance: f64| {
        let middle = DVec3::new(0.0, 0.9, 0.0);
        Camera::orbit(middle, 0.3, 0.1, distance, 0.7, LARGE)
    };
    let [mut near, mut far] = [1.0, 100.0];
    for _ in 0..60 {
        let between = 0.5 * (near + far);
        if bounds.longest_side(&posed.joints, &camera(between)) > side {
            near = between;
        } else {
            far = between;
        }
    }
    camera(far)
}

/// Factors between whole ones, with a low-pass between the avatar's own and that of what is drawn
/// larger: each pixel is the mean over its area.
pub fn any_factor_is_averaged_by_area<R: Renders>(raster: Raster) {
    let (avatar, camera) = scene(8.0, LARGE);
    let posed = posed(&avatar, &camera, 3, DVec3::new(0.05, 0.02, 0.0));
    let options = supersampled::<R>(raster, &camera, Supersampling::BySize);
    for side in [233.0, 411.0, 615.0] {
        let camera = camera_at(&avatar, &posed, side);
        let (image, report) = drawn::<R>(&avatar, &[&posed], &camera, options);
        assert_eq!(report.counters.supersampled, 1, "{side} px");
        let expected = reference::render_shown(
            &reference::people(&avatar, &[&posed]),
            &camera,
            Supersampling::BySize,
            None,
        );
        assert_near(&format!("{side} px"), &image, &expected, 48.0);
        let largest = error::between(&image, &expected).covered.max_error;
        assert!(largest <= 0.06, "{side} px: {largest}");
    }
}

/// An avatar that grows beyond what is drawn larger than it is shown looks as it did before, and as
/// the model says from then on.
pub fn no_switch_is_seen<R: Renders>(raster: Raster) {
    let (avatar, camera) = scene(8.0, LARGE);
    let posed = posed(&avatar, &camera, 3, DVec3::new(0.05, 0.02, 0.0));
    let options = supersampled::<R>(raster, &camera, Supersampling::BySize);
    let [small, large] = [-0.01, 0.01].map(|off| {
        let side = DRAWN_SIDE + off;
        let camera = camera_at(&avatar, &posed, side);
        drawn::<R>(&avatar, &[&posed], &camera, options)
    });
    let supersampled = [&small, &large].map(|(_, report)| report.counters.supersampled);
    assert_eq!(supersampled, [1, 0]);
    assert_near("across the switch", &small.0, &large.0, 50.0);
    let camera = camera_at(&avatar, &posed, DRAWN_SIDE + 0.01);
    let own = reference::render(&avatar, &posed, &camera);
    assert_near("as large as shown", &large.0, &own, 50.0);
}

/// From near to far and back, out of the image and in again, the whole image each time as one that
/// knows no other frame: nothing of an earlier frame stays.
pub fn frames_leave_nothing_behind<R: Renders>(raster: Raster) {
    let (avatar, camera) = scene(8.0, LARGE);
    let options = RendererOptions {
        instances: 2,
        ..supersampled::<R>(raster, &camera, Supersampling::BySize)
    };
    let mut renderer = R::make(&avatar, options);
    let near = DVec3::new(-0.5, 0.0, -6.0);
    let far = DVec3::new(1.0, 0.4, 6.0);
    let gone = DVec3::new(0.0, 0.0, -400.0);
    let mut factors = vec![];
    for places in [
        [far, gone],
        [near, far],
        [near, gone],
        [gone, gone],
        [far, far + DVec3::X],
        [far, far + DVec3::X],
        [near, far],
    ] {
        let poses = places.map(|place| posed(&avatar, &camera, 5, place));
        renderer.draw_all(&poses.each_ref(), &camera);
        let image = renderer.image();
        let mut fresh = R::make(&avatar, options);
        fresh.draw_all(&poses.each_ref(), &camera);
        let difference = error::between(&image, &fresh.image());
        assert!(
            difference.whole.max_error <= 0.02,
            "{places:?}: {:?}",
            difference.whole
        );
        factors.push(renderer.report().counters.supersampled);
    }
    assert_eq!(factors, [1, 1, 0, 0, 2, 0, 1]);
}

/// Networks move Gaussians by metres, out of the box around the avatar. What of them is beyond is
/// cut off, in the first frame as in others. The box begins where a region does, so that samples of
/// the saturation depth before it decide about its first pixels.
pub fn frames_show_the_same_whatever_came_before<R: Renders>(raster: Raster) {
    let (mut avatar, mut camera) = scene(6.0, LARGE);
    for number in avatar.nodes.basis.halves_mut() {
        *number = f16::from_f64(500.0 * number.to_f64());
    }
    avatar.gaussians.opacity.fill(255);
    avatar.gaussians.log_scale.fill([f16::from_f64(-3.0); 3]);
    let options = supersampled::<R>(raster, &camera, Supersampling::OFF);
    let whole = RendererOptions {
        skip: options.skip - Skip::DAMAGE,
        ..options
    };
    let still = posed(&avatar, &camera, 5, DVec3::ZERO);
    let visible = AvatarBounds::new(&avatar).visible(&still.joints, &camera);
    camera.center -= (visible.rect.min % RASTER_REGION).as_dvec2();
    let [image, all] = [options, whole].map(|options| {
        let mut renderer = R::make(&avatar, options);
        renderer.draw_all(&[&still], &camera);
        let first = renderer.image();
        // All around it is cleared, and what is to its left.
        for away in [-5.0, 12.0] {
            let other = posed(&avatar, &camera, 6, DVec3::new(-0.5, 0.0, away));
            renderer.draw_all(&[&other], &camera);
        }
        renderer.draw_all(&[&still], &camera);
        assert!(renderer.image() == first, "it depends on what was before");
        first
    });
    assert!(image != all, "nothing is beyond the box");
    // Nobody knows how far inputs beyond all that is learned move them: the box is not used.
    let mut wild = still;
    for number in &mut wild.input {
        *number *= 1000.0;
    }
    let [image, all] = [options, whole].map(|options| {
        let mut renderer = R::make(&avatar, options);
        renderer.draw_all(&[&wild], &camera);
        renderer.image()
    });
    assert!(image == all, "wild inputs are cut off");
}

/// Levels are drawn as the avatars that they are while an avatar comes nearer. Networks run only
/// for those that they move, also after frames that did without them.
pub fn levels_are_drawn_as_avatars<R: Renders>(raster: Raster) {
    let (avatar, camera) = scene(8.0, LARGE);
    // Up to 120 and 60 px.
    let avatar = common::with_near_levels(avatar);
    let own = [
        &avatar.at_level(&avatar.levels[0]),
        &avatar.at_level(&avatar.levels[1]),
    ];
    let whole = Avatar {
        levels: vec![],
        ..avatar.clone()
    };
    let options = supersampled::<R>(raster, &camera, Supersampling::BySize);
    let mut renderer = R::make(&avatar, options);
    let mut seen = vec![];
    for (seed, away, level) in [
        (1, 28.0, 2),
        (2, 26.0, 2),
        (2, 12.0, 1),
        (3, 11.0, 1),
        (3, 30.0, 2),
        (3, 2.0, 0),
        (4, 2.0, 0),
        (5, 30.0, 2),
        (5, 2.0, 0),
    ] {
        let posed = posed(&avatar, &camera, seed, DVec3::new(0.2, 0.1, away));
        renderer.draw_all(&[&posed], &camera);
        let image = renderer.image();
        let drawn = if level == 0 { &whole } else { own[level - 1] };
        let expected = reference::render_shown(
            &reference::people(drawn, &[&posed]),
            &camera,
            Supersampling::BySize,
            None,
        );
        assert_near(
            &format!("level {level}, {away} m away"),
            &image,
            &expected,
            44.0,
        );
        let counters = renderer.report().counters;
        let gaussians = counters.gaussians - counters.skipped_by_detail;
        assert_eq!(gaussians as usize, drawn.gaussians.len());
        seen.push((level, counters.networks > 0));
    }
    let ran: Vec<_> = seen.iter().map(|(_, ran)| *ran).collect();
    assert_eq!(
        ran,
        [false, false, true, true, false, false, true, false, true],
        "{seen:?}"
    );
}

/// A level that is fat at 2 samples and thin at 4 is drawn with those between at which its mean is
/// right, and a still frame of it is not drawn again.
pub fn levels_have_samples_of_their_own<R: Renders>(raster: Raster) {
    let (avatar, camera) = scene(8.0, LARGE);
    let mut avatar = common::with_near_levels(avatar);
    for level in &mut avatar.levels {
        for measured in &mut level.measured {
            let fat = if measured.samples == 2 { 0.02 } else { -0.02 };
            measured.color = fat;
            measured.coverage = fat;
        }
    }
    let options = supersampled::<R>(raster, &camera, Supersampling::BySize);
    let mut renderer = R::make(&avatar, options);
    for (away, level) in [(12.0, 1), (28.0, 2)] {
        let posed = posed(&avatar, &camera, 3, DVec3::new(0.2, 0.1, away));
        renderer.draw_all(&[&posed], &camera);
        let image = renderer.image();
        let counters = renderer.report().counters;
        // Half way between 1/2 and 1/4: 2.67.
        assert_eq!((counters.coarsest_level, counters.most_samples), (level, 3));
        let expected = reference::render_shown(
            &reference::people(&avatar, &[&posed]),
            &camera,
            Supersampling::BySize,
            None,
        );
        assert_near(&format!("level {level}"), &image, &expected, 44.0);
        renderer.draw_all(&[&posed], &camera);
        assert!(renderer.image() == image, "a still frame has changed");
        assert_eq!(renderer.report().counters.submitted, 0, "{away} m away");
    }
}

/// A level has colours of its own, which change with the view: of splats, and of a body that
/// networks move. Two avatars at different levels, so that both sets of colours are needed in one
/// frame.
pub fn levels_have_their_own_harmonics<R: Renders>(raster: Raster) {
    let splats = common::splats(5, 6000, 3).to_avatar("scan").unwrap();
    let (mut body, _) = scene(8.0, LARGE);
    body.sh = Some(common::harmonics(6, body.gaussians.len(), 2));
    for avatar in [splats, body] {
        let mut avatar = common::with_near_levels(avatar);
        for level in &mut avatar.levels {
            // What is drawn with the colours of another set is far from the reference.
            let sh = level.sh.as_mut().unwrap();
            for coefficient in sh.coefficients.iter_mut().flatten() {
                *coefficient = -*coefficient;
            }
        }
        let height =
            AvatarBounds::new(&avatar).bounds(&avatar.skeleton.matrices(&common::pose(1, &avatar)));
        let middle = (height[0] + height[1]) / 2.0;
        let tall = (height[1] - height[0]).y;
        let camera = Camera::orbit(middle, 0.3, 0.1, 3.0 * tall, 0.7, LARGE);
        let options = RendererOptions {
            instances: 2,
            ..supersampled::<R>(raster, &camera, Supersampling::BySize)
        };
        let mut renderer = R::make(&avatar, options);
        let mut seen = vec![];
        for (near, far) in [(6.0, 16.0), (16.0, 6.0), (6.0, 0.0), (0.0, 16.0)] {
            let place = |away: f64, aside: f64| {
                let at = tall * DVec3::new(aside * (1.0 + 0.2 * away), 0.0, away);
                posed(&avatar, &camera, 2, at)
            };
            let poses = [place(near, -0.6), place(far, 0.6)];
            let poses = [&poses[0], &poses[1]];
            renderer.draw_all(&poses, &camera);
            let image = renderer.image();
            let expected = reference::render_shown(
                &reference::people(&avatar, &poses),
                &camera,
                Supersampling::BySize,
                None,
            );
            assert_near(&format!("{near} and {far} away"), &image, &expected, 44.0);
            let own = Avatar {
                levels: vec![],
                ..avatar.clone()
            };
            let own = reference::render_shown(
                &reference::people(&own, &poses),
                &camera,
                Supersampling::BySize,
                None,
            );
            let other = error::between(&own, &expected).covered.psnr_db;
            assert!(
                other < 40.0,
                "{near} and {far} away: {other} dB without levels"
            );
            let counters = renderer.report().counters;
            seen.push(counters.gaussians - counters.skipped_by_detail);
        }
        let [own, fine, coarse] = [
            avatar.gaussians.len(),
            avatar.levels[0].gaussians.len(),
            avatar.levels[1].gaussians.len(),
        ]
        .map(|count| count as u64);
        assert_eq!(
            seen,
            [fine + coarse, fine + coarse, fine + own, own + coarse]
        );
    }
}
