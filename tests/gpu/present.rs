//! The `present` stage against the reference, and images that are drawn smaller than the screen.

use crate::common::{
    self, Sizes,
    gpu::{
        self,
        Raster::{self, Quads as PlainQuads, SharedTiles, TestedQuads},
    },
};
use effigy_core::{
    reference,
    scene::{Camera, Detail, FrameImage, Posed},
};
use effigy_measure::error;
use effigy_render::vulkan::{
    Error, FrameValidator, Offscreen, Presentation, Recording, Renderer, RendererOptions,
    raster::RasterMethod::{self, CooperativeTiles, Quads},
};
use effigy_runtime::governor::Ladder;

const BACKGROUND: [f32; 3] = [0.2, 0.7, 1.0];

/// Images of every size that a screen may show, stretched as the reference does.
fn a_stretched_image_agrees_with_the_reference() {
    let device = gpu::drawing();
    let avatar = common::avatar(5, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(6, &avatar));
    let size = [150, 190];
    let can = |method: &RasterMethod| device.probe.lacks_for(*method).is_none();
    for method in RasterMethod::ALL.into_iter().filter(can) {
        for exact in [false, true] {
            let options = RendererOptions {
                method: Some(method),
                exact,
                ..gpu::options(size)
            };
            let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
            let screen = Offscreen::new(&device, size).unwrap();
            // SAFETY: nothing uses the screen yet, and every frame leaves the image in that layout.
            unsafe { screen.set_image(renderer.raster().image()) };
            let camera = gpu::camera(&avatar, &posed, size);
            for drawn in [size, [75, 95], [149, 61], [1, 1]] {
                renderer.adjust(drawn, Detail::FULL).unwrap();
                let mut record =
                    |commands: Recording, _| screen.record(commands, drawn, BACKGROUND);
                // SAFETY: the frame is waited for below, when its image is read.
                let presentation = unsafe { Presentation::new(None, &mut record) };
                renderer
                    .draw(&posed, &camera.stretched(drawn), Some(presentation))
                    .unwrap();
                let image = renderer.read_image().unwrap();
                assert_eq!(image.size, drawn);
                let expected: Vec<f64> = reference::present::over(&image, size, BACKGROUND)
                    .into_iter()
                    .flatten()
                    .collect();
                let shown = screen.download().unwrap();
                assert!(shown.chunks(4).all(|pixel| pixel[3] == 255));
                let got: Vec<f64> = shown
                    .chunks(4)
                    .flat_map(|pixel| [0, 1, 2].map(|k| f64::from(pixel[k]) / 255.0))
                    .collect();
                // Vulkan lets a device take either of the two nearest steps of 8 bits; where
                // texels are mixed it has 8 bits of how near each is.
                gpu::assert_close(
                    &format!("{method:?} {exact} {drawn:?}"),
                    &got,
                    &expected,
                    if drawn == size {
                        1.01 / 255.0
                    } else {
                        2.5 / 255.0
                    },
                );
            }
        }
    }
}

/// A renderer and what shows its frames.
struct Shown {
    renderer: Renderer,
    screen: Offscreen,
}

impl Shown {
    /// Draws a frame of `drawn` px. Returns whether it was shown in the render pass that drew it,
    /// and the screen.
    fn frame(
        &mut self,
        posed: &Posed,
        camera: &Camera,
        drawn: [u32; 2],
        background: [f32; 3],
    ) -> (bool, Vec<u8>) {
        self.renderer.adjust(drawn, Detail::FULL).unwrap();
        let screen = &self.screen;
        let mut at_once = false;
        let mut record = |commands: Recording, is_shown: bool| {
            at_once = is_shown;
            if !is_shown {
                screen.record(commands, drawn, background);
            }
        };
        // SAFETY: the frame is waited for below.
        let presentation = unsafe { Presentation::new(None, &mut record) };
        let presentation = presentation.in_one_pass(screen.one_pass(background));
        self.renderer
            .draw(posed, &camera.stretched(drawn), Some(presentation))
            .unwrap();
        self.renderer.finish().unwrap();
        (at_once, self.screen.download().unwrap())
    }
}

/// Quads that go to the screen in the render pass that draws them show what the two passes show, in
/// every order of moving, standing and smaller frames; the latter keep their images.
fn one_pass_shows_what_two_do(raster: Raster) {
    let device = gpu::drawing();
    let avatar = common::avatar(11, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(12, &avatar));
    for size in [[120, 98], [67, 33]] {
        let options = raster.options(&device.probe.name, size);
        let [mut one, mut two] = [true, false].map(|connects| {
            let renderer = Renderer::new(&device, &avatar, options).unwrap();
            let mut screen = Offscreen::new(&device, size).unwrap();
            // SAFETY: nothing uses the screen yet, and every frame is waited for.
            unsafe {
                if connects {
                    screen.connect(renderer.raster()).unwrap();
                } else {
                    screen.set_image(renderer.raster().image());
                }
            }
            Shown { renderer, screen }
        });
        let camera = gpu::camera(&avatar, &posed, size);
        let smaller = size.map(|side: u32| side.div_ceil(2));
        let is_smaller = smaller != size;
        let can = raster != SharedTiles;
        // Where the camera stands, what is drawn, and whether that goes to the screen at once.
        let frames = [
            (0.0, size, false),
            (0.3, size, can),
            (-0.3, size, can),
            (-0.3, size, false),
            (-0.3, size, false),
            (0.2, size, false),
            (0.0, size, can),
            (0.1, smaller, can && !is_smaller),
            (0.2, smaller, can && !is_smaller),
            (0.3, size, can),
            (1e6, size, can),
            (0.0, size, can),
        ];
        for (number, (aside, drawn, at_once)) in frames.into_iter().enumerate() {
            let mut moved = camera;
            moved.view.translation.x += aside;
            let background = BACKGROUND.map(|channel| channel / (1 + number % 3) as f32);
            let what = format!("{raster:?} {size:?}, frame {number}");
            let [got, expected] =
                [&mut one, &mut two].map(|shown| shown.frame(&posed, &moved, drawn, background));
            assert_eq!((got.0, expected.0), (at_once, false), "{what}");
            assert!(got.1 == expected.1, "{what} is not what two passes show");
            let copied = one.renderer.read_image();
            if at_once {
                assert!(matches!(copied, Err(Error::NothingDrawn)), "{what}");
            } else {
                assert!(
                    copied.unwrap() == two.renderer.read_image().unwrap(),
                    "{what}"
                );
            }
        }
        // Without a screen the image is there again.
        for shown in [&mut one, &mut two] {
            shown.renderer.draw(&posed, &camera, None).unwrap();
        }
        let [again, kept] = [&mut one, &mut two].map(|own| own.renderer.read_image().unwrap());
        assert!(again == kept, "{raster:?} {size:?}");
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
        ..gpu::options(screen)
    };
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    let camera = gpu::camera(&avatar, &posed, screen);
    let held = device.memory().0;
    let ladder = Ladder::new(120.0);
    // Down, and up again at once: what one rung leaves must not show in another.
    for rung in ladder.rungs().iter().chain(&ladder.rungs()[..1]) {
        let size = rung.quality.size(screen);
        let detail = rung.quality.detail(options.detail);
        renderer.adjust(size, detail).unwrap();
        let camera = camera.stretched(size);
        renderer.draw(&posed, &camera, None).unwrap();
        let image = renderer.read_image().unwrap();
        let made = RendererOptions {
            size,
            detail,
            ..options
        };
        let fresh = gpu::draw(&device, avatar.clone(), posed.clone(), camera, made).image;
        assert!(
            image == fresh,
            "{method:?}, {}: {:?}",
            rung.name,
            error::between(&image, &fresh).whole
        );
    }
    assert_eq!(device.memory().0, held, "{method:?}: steps take memory");
    let refused = renderer
        .adjust([161, 10], Detail::FULL)
        .unwrap_err()
        .to_string();
    assert!(
        refused.contains("161 × 10 px") && refused.contains("160 × 200 px"),
        "{refused}"
    );
    assert!(renderer.adjust([0, 5], Detail::FULL).is_err());
}

/// The validator counts the pixels that its frame drew, whatever the frames after it draw.
fn validated_pixels_are_those_that_the_frame_drew(method: RasterMethod) {
    let device = gpu::gpu();
    gpu::require_method(&device.probe.name, method);
    let avatar = common::avatar(9, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(10, &avatar));
    let size = [120, 140];
    let options = RendererOptions {
        method: Some(method),
        ..gpu::options(size)
    };
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    let camera = gpu::camera(&avatar, &posed, size);
    renderer.draw(&posed, &camera, None).unwrap();
    let covered =
        |image: &FrameImage| image.pixels.iter().filter(|pixel| pixel[3] > 0.0).count() as u64;
    let expected = covered(&renderer.read_image().unwrap());
    let mut validator = FrameValidator::new(&device, renderer.raster()).unwrap();
    let mut counts = None;
    for frame in 0..40 {
        let image = renderer.raster().image().raw();
        let validates = frame == 0;
        let mut record = |commands: Recording, _| {
            if validates {
                // SAFETY: it follows the frame, whose image lives as long as the renderer.
                unsafe { validator.record(commands, image, size) };
            }
        };
        let mut moved = camera;
        moved.center.x += f64::from(frame * 20);
        // SAFETY: the renderer's last frame is waited for before the validator is dropped.
        let presentation = unsafe { Presentation::new(None, &mut record) };
        renderer.draw(&posed, &moved, Some(presentation)).unwrap();
        counts = counts.or(validator.step());
    }
    let counts = counts.expect("forty frames are enough to read an image");
    assert_eq!((counts.covered, counts.broken), (expected, 0), "{method:?}");
    assert!(validator.is_idle());
    renderer.finish().unwrap();
}

tests! {
    a_stretched_image_agrees_with_the_reference: smoke,
    one_pass_shows_what_two_do[PlainQuads],
    one_pass_shows_what_two_do[TestedQuads],
    one_pass_shows_what_two_do[SharedTiles],
    every_rung_is_drawn_as_if_it_was_made_for_it[Quads],
    every_rung_is_drawn_as_if_it_was_made_for_it[CooperativeTiles],
    validated_pixels_are_those_that_the_frame_drew[Quads],
    validated_pixels_are_those_that_the_frame_drew[CooperativeTiles],
}
