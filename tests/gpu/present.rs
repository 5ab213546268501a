//! The `present` stage against the reference, and pictures that are drawn smaller than the screen.

use crate::common::{self, Sizes, gpu};
use effigy::vulkan::{
    FrameValidator, Offscreen, Presentation, Recording, Renderer, RendererOptions,
    raster::{
        ColorFormat,
        RasterMethod::{self, Quads, Tiles},
    },
};
use effigy_core::{
    constants::ALPHA_MIN,
    reference,
    scene::{Detail, FrameImage, Posed},
};
use effigy_measure::error;
use effigy_runtime::governor::Ladder;

const BACKGROUND: [f32; 3] = [0.2, 0.7, 1.0];

/// Pictures of every size that a screen may show, stretched as the reference does.
fn a_stretched_picture_is_the_references() {
    let device = gpu::drawing();
    let avatar = common::avatar(5, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(6, &avatar));
    let size = [150, 190];
    for method in RasterMethod::ALL {
        for color in [ColorFormat::Rgba8, ColorFormat::Rgba16F] {
            let options = RendererOptions {
                method: Some(method),
                color: Some(color),
                ..RendererOptions::new(size)
            };
            let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
            let screen = Offscreen::new(&device, size).unwrap();
            // SAFETY: nothing uses the screen yet, and every frame leaves the picture so.
            unsafe { screen.set_image(renderer.raster().image()) };
            let camera = gpu::camera(&avatar, &posed, size);
            for drawn in [size, [75, 95], [149, 61], [1, 1]] {
                renderer.adjust(drawn, ALPHA_MIN, Detail::FULL).unwrap();
                let mut record = |commands: Recording| screen.record(commands, drawn, BACKGROUND);
                // SAFETY: the frame is waited for below, when its picture is read.
                let presentation = unsafe { Presentation::new(None, &mut record) };
                renderer
                    .draw(&posed, &camera.stretched(drawn), Some(presentation))
                    .unwrap();
                let picture = renderer.read_image().unwrap();
                assert_eq!(picture.size, drawn);
                let expected: Vec<f64> = reference::present::over(&picture, size, BACKGROUND)
                    .into_iter()
                    .flatten()
                    .collect();
                let shown = screen.download().unwrap();
                assert!(shown.chunks(4).all(|pixel| pixel[3] == 255));
                let got: Vec<f64> = shown
                    .chunks(4)
                    .flat_map(|pixel| [0, 1, 2].map(|k| f64::from(pixel[k]) / 255.0))
                    .collect();
                // A bit of 8, and where texels are mixed the device's 8 bits of how near each is.
                gpu::assert_close(
                    &format!("{method:?} {color:?} {drawn:?}"),
                    &got,
                    &expected,
                    if drawn == size {
                        0.51 / 255.0
                    } else {
                        2.5 / 255.0
                    },
                );
            }
        }
    }
}

/// Every rung of the governor draws what a renderer made for it does, and less of it than the rung
/// above.
fn every_rung_is_drawn_as_if_it_was_made_for_it(method: RasterMethod) {
    let device = gpu::gpu();
    gpu::require_method(&device.probe.name, method);
    let avatar = common::avatar(7, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(8, &avatar));
    let screen = [160, 200];
    let options = RendererOptions {
        method: Some(method),
        ..RendererOptions::new(screen)
    };
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    let camera = gpu::camera(&avatar, &posed, screen);
    let held = device.memory().0;
    let ladder = Ladder::new(120.0);
    // Down, and up again at once: what one rung leaves must not show in another.
    for rung in ladder.rungs().iter().chain(&ladder.rungs()[..1]) {
        let (size, cutoff, detail) = (
            rung.quality.size(screen),
            rung.quality.cutoff(&options),
            rung.quality.detail(&options),
        );
        renderer.adjust(size, cutoff, detail).unwrap();
        let camera = camera.stretched(size);
        renderer.draw(&posed, &camera, None).unwrap();
        let picture = renderer.read_image().unwrap();
        let made = RendererOptions {
            size,
            cutoff,
            detail,
            ..options
        };
        let fresh = gpu::draw(&device, avatar.clone(), posed.clone(), camera, made).picture;
        assert!(
            picture == fresh,
            "{method:?}, {}: {:?}",
            rung.name,
            error::between(&picture, &fresh).whole
        );
    }
    assert_eq!(device.memory().0, held, "{method:?}: steps take memory");
    let refused = renderer
        .adjust([161, 10], ALPHA_MIN, Detail::FULL)
        .unwrap_err()
        .to_string();
    assert!(
        refused.contains("161 × 10 px") && refused.contains("160 × 200 px"),
        "{refused}"
    );
    assert!(
        renderer.adjust(screen, 0.0, Detail::FULL).is_err()
            && renderer.adjust([0, 5], ALPHA_MIN, Detail::FULL).is_err()
    );
}

/// The picture that is looked at behind a frame is the one that the frame drew, whatever the frames
/// after it draw.
fn a_watched_picture_is_counted_as_it_was_drawn(method: RasterMethod) {
    let device = gpu::gpu();
    gpu::require_method(&device.probe.name, method);
    let avatar = common::avatar(9, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(10, &avatar));
    let size = [120, 140];
    let options = RendererOptions {
        method: Some(method),
        ..RendererOptions::new(size)
    };
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    let camera = gpu::camera(&avatar, &posed, size);
    renderer.draw(&posed, &camera, None).unwrap();
    let covered =
        |picture: &FrameImage| picture.pixels.iter().filter(|pixel| pixel[3] > 0.0).count() as u64;
    let expected = covered(&renderer.read_image().unwrap());
    let mut watch = FrameValidator::new(&device, renderer.raster()).unwrap();
    let mut seen = None;
    for frame in 0..40 {
        let (image, look) = (renderer.raster().image().raw(), frame == 0);
        let mut record = |commands: Recording| {
            if look {
                // SAFETY: it follows the frame, whose picture lives as long as the renderer.
                unsafe { watch.record(commands, image, size) };
            }
        };
        let mut moved = camera;
        moved.center.x += f64::from(frame * 20);
        // SAFETY: the renderer's last frame is waited for before the watch goes.
        let presentation = unsafe { Presentation::new(None, &mut record) };
        renderer.draw(&posed, &moved, Some(presentation)).unwrap();
        seen = seen.or(watch.step());
    }
    let seen = seen.expect("forty frames are enough to look at a picture");
    assert_eq!((seen.covered, seen.broken), (expected, 0), "{method:?}");
    assert!(watch.is_idle());
    renderer.finish().unwrap();
}

tests! {
    a_stretched_picture_is_the_references: smoke,
    every_rung_is_drawn_as_if_it_was_made_for_it[Quads],
    every_rung_is_drawn_as_if_it_was_made_for_it[Tiles],
    a_watched_picture_is_counted_as_it_was_drawn[Quads],
    a_watched_picture_is_counted_as_it_was_drawn[Tiles],
}
