//! One stress case on a device: a case goes in; the errors of its image and everything that is
//! wrong with it come out.

use super::{
    bound::{BoundScene, BoundUse, ImageBound, Rounding},
    case::StressCase,
    category::Category,
    refusal,
};
use effigy_core::{
    frame::Skip,
    random::hash,
    reference,
    scene::{Camera, FrameImage, Posed},
};
use effigy_measure::error::{self, ErrorMetrics};
use effigy_render::vulkan::{self, Gpu, Renderer, instance::validation_messages};
use glam::DVec3;
use std::{
    sync::Arc,
    time::{Duration, Instant},
};

/// The longest time for a case's five frames, set-up included; longer counts as a hang. Compiling
/// a kernel at 512 bits has taken lavapipe half a minute beside other work.
const LIMIT: Duration = Duration::from_secs(90);
/// Largest value of a channel: one step of f16 above 1 is rounding.
const MAX_CHANNEL: f32 = 1.001;

/// The result of drawing a case.
pub struct CaseOutcome {
    /// Time on the device with set-up, without the reference's.
    pub time: Duration,
    /// Against the reference. None if the case could not be drawn.
    pub error: Option<ErrorMetrics>,
    /// Of the device's arithmetic alone: against the reference's image of the model as device
    /// memory holds it.
    pub arithmetic: Option<ErrorMetrics>,
    /// How much of their bound the pixels use: computed from the model.
    pub used: Option<BoundUse>,
    /// How much of its bound the image from the pose cache uses, where the case skips skinning.
    pub used_cached: Option<BoundUse>,
    /// A sentence for everything that is wrong.
    pub faults: Vec<String>,
    /// Hash of the image's bits.
    pub digest: u64,
    /// Whether the device can't be used any longer.
    pub lost: bool,
    /// The device's image and the reference's.
    pub images: Option<[FrameImage; 2]>,
}

/// Draws a case and checks it.
pub fn check_case(gpu: &Arc<Gpu>, case: &StressCase) -> CaseOutcome {
    DrawnCase::draw(gpu, case).check(gpu, case)
}

/// A case that was drawn, before its images are looked at: that needs no device.
pub struct DrawnCase {
    time: Duration,
    drawn: vulkan::Result<CaseImages>,
    faults: Vec<String>,
}

impl DrawnCase {
    /// Draws a case.
    pub fn draw(gpu: &Arc<Gpu>, case: &StressCase) -> Self {
        let messages_before = validation_messages();
        let mut faults = vec![];
        let start = Instant::now();
        let drawn = if case.category == Category::Refused {
            refusal::run(gpu, case, &mut faults).map(|[first, second]| CaseImages {
                first,
                second,
                cached: None,
            })
        } else {
            draw(gpu, case)
        };
        let time = start.elapsed();
        if time > LIMIT {
            faults.push(format!(
                "it took {:.1} s, {} s are allowed",
                time.as_secs_f64(),
                LIMIT.as_secs()
            ));
        }
        if validation_messages() != messages_before {
            faults.push("the validation layer complained, see above".into());
        }
        Self {
            time,
            drawn,
            faults,
        }
    }

    /// Whether the device can't be used any longer.
    pub fn is_lost(&self) -> bool {
        matches!(
            self.drawn,
            Err(vulkan::Error::DeviceLost(_) | vulkan::Error::Timeout { .. })
        )
    }

    /// Checks the images against the reference.
    pub fn check(self, gpu: &Gpu, case: &StressCase) -> CaseOutcome {
        let mut outcome = CaseOutcome {
            time: self.time,
            error: None,
            arithmetic: None,
            used: None,
            used_cached: None,
            lost: self.is_lost(),
            faults: self.faults,
            digest: 0,
            images: None,
        };
        match self.drawn {
            Ok(drawn) => outcome.check_images(gpu, case, drawn),
            Err(error) => outcome.faults.push(format!("drawing failed: {error}")),
        }
        outcome
    }
}

/// The images of a case's frame, which is drawn several times.
struct CaseImages {
    first: FrameImage,
    /// Drawn again after another frame.
    second: FrameImage,
    /// From the pose cache that another camera filled, where the case skips skinning.
    cached: Option<FrameImage>,
}

/// The case's frame drawn twice, with another one between, so that the second can't reuse anything
/// of the first; then once more after one that only the camera differs in.
fn draw(gpu: &Arc<Gpu>, case: &StressCase) -> vulkan::Result<CaseImages> {
    let mut renderer = Renderer::new(gpu, &case.avatar, case.options)?;
    renderer.draw(&case.posed, &case.camera, None)?;
    let first = renderer.read_image()?;
    renderer.draw(&other_pose(case), &other_camera(case), None)?;
    renderer.draw(&case.posed, &case.camera, None)?;
    let second = renderer.read_image()?;
    let cached = if case.options.skip.contains(Skip::SKINNING) {
        renderer.draw(&case.posed, &other_camera(case), None)?;
        renderer.draw(&case.posed, &case.camera, None)?;
        Some(renderer.read_image()?)
    } else {
        None
    };
    Ok(CaseImages {
        first,
        second,
        cached,
    })
}

fn other_pose(case: &StressCase) -> Posed {
    let mut posed = case.posed.clone();
    for input in &mut posed.input {
        *input = 0.5 - *input;
    }
    posed
}

fn other_camera(case: &StressCase) -> Camera {
    let mut camera = case.camera;
    camera.view.translation += DVec3::new(0.1, -0.2, 0.3) * camera.near;
    camera
}

impl CaseOutcome {
    /// The largest share of its bound that a pixel used, from the model or the pose cache.
    pub fn largest_use(&self) -> Option<f64> {
        [self.used, self.used_cached]
            .into_iter()
            .flatten()
            .map(|used| used.largest)
            .reduce(f64::max)
    }

    fn check_images(&mut self, gpu: &Gpu, case: &StressCase, drawn: CaseImages) {
        let CaseImages {
            first,
            second,
            cached,
        } = drawn;
        self.digest = digest(&first);
        self.faults.extend(range_faults(&first));
        self.faults.extend(difference(&first, &second));

        let exact_positions = case.category == Category::NearPlane;
        let rounding = Rounding {
            exact_positions,
            ..Rounding::new(&case.options, &gpu.probe)
        };
        let bound = ImageBound::new(&case.scene(), &rounding);
        let used = bound.used_by(&first);
        self.faults.extend(beyond("", &used));
        if let Some(cached) = &cached {
            self.faults.extend(range_faults(cached));
            let camera = other_camera(case);
            let scene = BoundScene {
                cached_by: Some(&camera),
                ..case.scene()
            };
            let rounding = Rounding {
                exact_positions: false,
                ..rounding
            };
            let used = ImageBound::new(&scene, &rounding).used_by(cached);
            self.faults.extend(beyond("from the pose cache, ", &used));
            self.used_cached = Some(used);
        }
        let reference = reference::render_shown(
            &reference::people(&case.avatar, &[&case.posed]),
            &case.camera,
            case.options.supersampling,
            case.options.filter,
        );
        self.error = Some(error::between(&first, &reference));
        self.arithmetic = Some(error::between(&first, &bound.reference()));
        self.used = Some(used);
        self.images = Some([first, reference]);
    }
}

/// A sentence if a pixel is beyond its bound. `how`: how the image came about.
fn beyond(how: &str, used: &BoundUse) -> Option<String> {
    (!used.holds()).then(|| {
        let channel = ["red", "green", "blue", "coverage"][used.channel];
        format!(
            "{how}{channel} of pixel {:?} is off by {:.5}, {:.5} is its bound",
            used.pixel, used.error, used.bound
        )
    })
}

fn place(image: &FrameImage, index: usize) -> [usize; 2] {
    let width = image.size[0] as usize;
    [index % width, index / width]
}

/// Values that are no numbers or out of range.
fn range_faults(image: &FrameImage) -> Vec<String> {
    let find = |is_bad: fn(&f32) -> bool| {
        let has_bad = |pixel: &[f32; 4]| pixel.iter().any(is_bad);
        image.pixels.iter().position(has_bad)
    };
    let mut faults = Vec::new();
    if let Some(index) = find(|v| !v.is_finite()) {
        let pixel = image.pixels[index];
        faults.push(format!("pixel {:?} is {pixel:?}", place(image, index)));
    }
    if let Some(index) = find(|v| !(0.0..=MAX_CHANNEL).contains(v)) {
        let pixel = image.pixels[index];
        faults.push(format!(
            "pixel {:?} is out of range: {pixel:?}",
            place(image, index)
        ));
    }
    faults
}

/// A sentence if the second image differs from the first in any bit.
fn difference(first: &FrameImage, second: &FrameImage) -> Option<String> {
    let bits = |pixel: [f32; 4]| pixel.map(f32::to_bits);
    let mut pairs = first.pixels.iter().zip(&second.pixels);
    let index = pairs.position(|(a, b)| bits(*a) != bits(*b))?;
    Some(format!(
        "drawn again, pixel {:?} is {:?} instead of {:?}",
        place(first, index),
        second.pixels[index],
        first.pixels[index]
    ))
}

/// A hash of an image's bits.
fn digest(image: &FrameImage) -> u64 {
    let width = hash(u64::from(image.size[0]));
    let values = image.pixels.iter().flatten();
    values.fold(width, |sum, value| hash(sum ^ u64::from(value.to_bits())))
}
