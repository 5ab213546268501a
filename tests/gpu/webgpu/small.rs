//! Avatars that are drawn larger than they are shown, and levels of detail, with the WebGPU backend
//! natively: against the reference, and against the Vulkan backend.

use super::{neutral, open};
use crate::{
    common::{
        self,
        gpu::{
            self,
            Raster::{self, Quads, SharedTiles, TestedQuads},
        },
    },
    small::{LARGE, Renders, camera_at, posed, scene, supersampled},
};
use effigy_core::{
    avatar::Avatar,
    frame::{AvatarId, FrameReport, Person, RendererOptions, Skip},
    reference,
    scene::{Camera, FrameImage, Posed, Supersampling},
};
use effigy_measure::error;
use effigy_render::webgpu::Renderer;
use glam::DVec3;

impl Renders for Renderer {
    fn device() -> String {
        open().name().into()
    }

    fn make(avatar: &Avatar, options: RendererOptions) -> Self {
        if !effigy_render::quirks::draws_triangles(&Self::device()) {
            common::harness::not_run("the device does not survive drawing triangles");
        }
        Self::new(&open(), avatar, options).unwrap()
    }

    fn draw_all(&mut self, poses: &[&Posed], camera: &Camera) {
        self.draw_scene(&Person::copies(poses), camera).unwrap();
    }

    fn image(&mut self) -> FrameImage {
        let image = self.read_image().unwrap();
        self.gpu().check().unwrap();
        image
    }

    fn report(&self) -> FrameReport {
        Self::report(self).clone()
    }
}

check_with!(Renderer);

/// One alone; then with one that is large, before and behind it, and one that shares its slot.
fn small_avatars_are_those_of_the_vulkan_backend(raster: Raster) {
    let (avatar, camera) = scene(2.6, LARGE);
    let avatar = common::with_near_levels(avatar);
    let options = RendererOptions {
        instances: 3,
        count: true,
        ..supersampled::<Renderer>(raster, &camera, Supersampling::BySize)
    };
    let mut both = Both {
        ours: Renderer::make(&avatar, options),
        theirs: effigy_render::vulkan::Renderer::make(&avatar, options),
    };
    let alone = posed(&avatar, &camera, 3, DVec3::new(0.05, 0.02, 0.0));
    for side in [30.0, 60.0, 120.0, 240.0] {
        both.agree(&[&alone], &camera_at(&avatar, &alone, side));
    }
    let place = |seed, x, y, z| posed(&avatar, &camera, seed, DVec3::new(x, y, z));
    let near = place(1, 0.0, 0.0, 0.0);
    let far = [place(2, 1.0, 0.5, 12.0), place(3, 1.3, 0.5, 12.1)];
    both.agree(&[&far[0], &near, &far[1]], &camera);
}

/// A renderer of each backend, of the same avatar and with the same options.
struct Both {
    ours: Renderer,
    theirs: effigy_render::vulkan::Renderer,
}

impl Both {
    /// Draws the same with both backends, where some of it is small.
    fn agree(&mut self, poses: &[&Posed], camera: &Camera) {
        let Self { ours, theirs } = self;
        ours.draw_all(poses, camera);
        theirs.draw_all(poses, camera);
        let [image, expected] = [ours.image(), theirs.image()];
        let [report, theirs] = [Renders::report(ours), Renders::report(theirs)];
        let [own, other] = [&report, &theirs].map(|report| {
            let counters = &report.counters;
            [
                counters.supersampled,
                counters.most_samples,
                counters.coarsest_level,
                counters.skipped_by_detail,
                counters.networks,
            ]
        });
        assert_eq!(own, other);
        assert!(own[0] > 0);
        let [own, other] = [report, theirs].map(|report| report.counters.drawn);
        assert!(own.abs_diff(other) <= 2, "{own} drawn, expected {other}");
        let off = |(a, b): (&[f32; 4], &[f32; 4])| {
            a.iter().zip(b).any(|(a, b)| (a - b).abs() > 2.0 / 255.0)
        };
        let covered = expected
            .pixels
            .iter()
            .filter(|pixel| pixel[3] > 0.0)
            .count();
        let pairs = image.pixels.iter().zip(&expected.pixels);
        let off = pairs.filter(|&pair| off(pair)).count();
        assert!(
            covered > 80 && off as f64 <= 1e-3 * covered as f64,
            "{off} of {covered} pixels differ"
        );
    }
}

/// A file whose levels come last: the neutral avatar, then all of it without its levels, then
/// those. Each image is that of a renderer that was made for as much.
fn levels_may_come_after_the_first_frame(raster: Raster) {
    let (own, camera) = scene(30.0, LARGE);
    let lit = Avatar {
        sh: Some(common::harmonics(32, own.gaussians.len(), 2)),
        ..own.clone()
    };
    // Fewer rows than its levels have: kernels are compiled again for these.
    let bare = own.retain_rows(0.05);
    let options = supersampled::<Renderer>(raster, &camera, Supersampling::BySize);
    for (avatar, away, level) in [(&own, 0.0, 2), (&lit, 0.0, 2), (&bare, -12.0, 1)] {
        let posed = posed(&own, &camera, 2, DVec3::new(0.1, 0.0, away));
        let avatar = Avatar {
            levels: common::with_near_levels(if avatar.sh.is_some() { &lit } else { &own }.clone())
                .levels,
            ..avatar.clone()
        };
        let without = Avatar {
            levels: vec![],
            ..avatar.clone()
        };
        let file = avatar.to_bytes().unwrap();
        let mut renderer = Renderer::make(&neutral(&file), options);
        renderer.draw_all(&[&posed], &camera);
        assert_eq!(renderer.replace_avatar(AvatarId::FIRST, &without), Ok(true));
        let shown = |renderer: &mut Renderer| {
            renderer.draw_all(&[&posed], &camera);
            (renderer.image(), renderer.report().counters.coarsest_level)
        };
        let [own, of_level] =
            [&without, &avatar].map(|avatar| shown(&mut Renderer::make(avatar, options)));
        assert!(own.1 == 0 && of_level.1 == level);
        assert!(shown(&mut renderer) == own);
        let mut broken = avatar.clone();
        broken.levels[1].gaussians.joint[7] = [255; 4];
        assert!(renderer.add_levels(AvatarId::FIRST, &broken).is_err());
        assert!(shown(&mut renderer) == own);
        assert_eq!(renderer.add_levels(AvatarId::FIRST, &avatar), Ok(true));
        assert!(shown(&mut renderer) == of_level);
        assert_eq!(renderer.add_levels(AvatarId::FIRST, &avatar), Ok(false));
        // Without them again, and all at once.
        assert_eq!(renderer.replace_avatar(AvatarId::FIRST, &without), Ok(true));
        assert!(shown(&mut renderer) == own);
        assert_eq!(renderer.replace_avatar(AvatarId::FIRST, &avatar), Ok(true));
        assert!(shown(&mut renderer) == of_level);
    }
}

/// Where nothing small is and nothing was, the image stays as it is: while a small avatar crosses
/// it, comes near, leaves it and comes again, beside one that is large or alone.
fn only_boxes_around_small_avatars_are_drawn(raster: Raster) {
    let (avatar, camera) = scene(2.6, LARGE);
    let avatar = common::with_near_levels(avatar);
    let near = DVec3::new(-0.6, 0.0, 0.0);
    let gone = DVec3::new(0.0, 0.0, -400.0);
    let frames = [
        [gone, DVec3::new(2.0, 0.5, 12.0)],
        [gone, DVec3::new(-2.0, -0.5, 12.0)],
        [near, DVec3::new(0.0, -0.5, 12.0)],
        [near, DVec3::new(1.0, 1.0, 25.0)],
        [gone, gone],
        [gone, DVec3::new(0.5, 0.0, 20.0)],
    ];
    let draw = |skip| {
        let options = RendererOptions {
            skip,
            instances: 2,
            ..supersampled::<Renderer>(raster, &camera, Supersampling::BySize)
        };
        let mut renderer = Renderer::make(&avatar, options);
        frames.map(|places| {
            let poses = places.map(|place| posed(&avatar, &camera, 5, place));
            renderer.draw_all(&poses.each_ref(), &camera);
            (renderer.image(), renderer.report().counters.damaged)
        })
    };
    let [all, some] = [Skip::AVATARS, Skip::AVATARS | Skip::DAMAGE].map(draw);
    for (k, ((exact, _), (image, _))) in all.iter().zip(&some).enumerate() {
        assert!(image == exact, "image {k}");
    }
    let whole = u64::from(LARGE[0]) * u64::from(LARGE[1]);
    assert!(
        some.iter().any(|(_, area)| *area < whole) && all.iter().all(|(_, area)| *area == whole)
    );
}

/// The image changes its size while its avatar is small.
fn small_avatars_follow_a_resize(raster: Raster) {
    let (avatar, _) = scene(6.0, LARGE);
    let options = supersampled::<Renderer>(raster, &scene(6.0, LARGE).1, Supersampling::BySize);
    let mut renderer = Renderer::make(&avatar, options);
    for size in [LARGE, [64, 48], [900, 300], [7, 300], LARGE] {
        let (_, camera) = scene(6.0, size);
        let posed = posed(&avatar, &camera, 2, DVec3::new(0.1, 0.0, 0.0));
        renderer.resize(size).unwrap();
        renderer.draw_all(&[&posed], &camera);
        let expected = reference::render_shown(
            &reference::people(&avatar, &[&posed]),
            &camera,
            Supersampling::BySize,
            None,
        );
        let error = error::between(&renderer.image(), &expected);
        assert!(
            error.whole.psnr_db > 52.0,
            "{size:?}, {options:?}: {:?}",
            error.whole
        );
    }
}

/// A device that draws no triangles draws everything as large as it is shown.
fn factors_are_as_asked_for() {
    let device = open();
    let (avatar, _) = scene(6.0, LARGE);
    let asked = RendererOptions {
        supersampling: Supersampling::Times(2),
        ..gpu::options([64, 64])
    };
    let renderer = Renderer::new(&device, &avatar, asked).unwrap();
    let draws = effigy_render::quirks::draws_triangles(device.name());
    let expected = if draws {
        Supersampling::Times(2)
    } else {
        Supersampling::OFF
    };
    assert_eq!(renderer.options().supersampling, expected);
}

tests! {
    small_avatars_are_those_of_the_vulkan_backend[Quads],
    small_avatars_are_those_of_the_vulkan_backend[TestedQuads],
    small_avatars_are_those_of_the_vulkan_backend[SharedTiles],
    levels_may_come_after_the_first_frame[SharedTiles],
    only_boxes_around_small_avatars_are_drawn[SharedTiles],
    small_avatars_follow_a_resize[Quads],
    small_avatars_follow_a_resize[SharedTiles],
    factors_are_as_asked_for,
    any_factor_is_averaged_by_area[Quads],
    any_factor_is_averaged_by_area[SharedTiles],
    no_switch_is_seen[Quads],
    no_switch_is_seen[SharedTiles],
    levels_have_their_own_harmonics[SharedTiles],
    levels_have_samples_of_their_own[Quads],
    levels_have_samples_of_their_own[SharedTiles],
    levels_are_drawn_as_avatars[Quads],
    levels_are_drawn_as_avatars[SharedTiles],
    a_small_avatar_is_its_own_average[Quads],
    a_small_avatar_is_its_own_average[SharedTiles],
    small_avatars_go_before_and_behind_large_ones[Quads],
    small_avatars_go_before_and_behind_large_ones[TestedQuads],
    small_avatars_go_before_and_behind_large_ones[SharedTiles],
    small_avatars_that_touch_are_sorted_together[Quads],
    small_avatars_that_touch_are_sorted_together[SharedTiles],
    frames_show_the_same_whatever_came_before[SharedTiles],
    what_faint_saves_cuts_nothing_off[Quads],
    what_faint_saves_cuts_nothing_off[SharedTiles],
    frames_leave_nothing_behind[TestedQuads],
    frames_leave_nothing_behind[SharedTiles],
}
