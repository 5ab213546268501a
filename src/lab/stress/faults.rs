//! What the bounds must see: images of the reference with one fault each, which must not pass.

use super::{
    bound::{ImageBound, Rounding},
    case::{Rasterizer, StressCase},
    category::Category,
};
use effigy_core::{
    frame::Skip,
    reference::{self, Culled, Splat, project, raster, sort},
    scene::{AvatarBounds, Camera, FrameImage, Supersampling},
};
use glam::DVec2;

/// Seed of the cases; their numbers are chosen for what they show.
const SEED: u64 = 5;

/// Width and height of the images, px.
const SIZE: [u32; 2] = [128, 128];

/// A frame of the reference, in pieces that a fault can be put into.
struct FaultyFrame {
    case: StressCase,
    splats: Vec<Result<Splat, Culled>>,
    order: Vec<u32>,
}

/// How a case is drawn.
#[derive(Clone, Copy, Debug)]
struct DrawSettings {
    rasterizer: Rasterizer,
    exact: bool,
    skip: Skip,
}

impl DrawSettings {
    /// How many of so many faults its bound must see: all, but one where what shows by less than a
    /// twentieth is left out: by the saturation depth, and by tiles with 8 bits, which fill
    /// saturated pixels.
    fn least_seen(self, faults: usize) -> usize {
        let fills = !self.exact && self.skip.contains(Skip::SATURATED);
        if matches!(self.rasterizer, Rasterizer::TestedQuads) || fills {
            (faults - 1).max(1)
        } else {
            faults
        }
    }
}

/// Splats that most of the image depends on: it must be one of these that a fault changes.
const CANDIDATES: usize = 8;

impl FaultyFrame {
    /// The first case of a category with at most so many Gaussians, from nearby.
    fn new(category: Category, gaussians: usize) -> Self {
        let mut case = (0..100 * Category::ROUND)
            .filter(|&number| Category::of_case(number) == category)
            .map(|number| StressCase::new(SEED, number, false))
            .find(|case| case.avatar.gaussians.len() <= gaussians)
            .expect("one of a hundred is small");
        let [min, max] = AvatarBounds::new(&case.avatar).bounds(&case.posed.joints);
        let distance = 0.5 * Camera::framing_distance([min, max], 0.7, SIZE);
        case.camera = Camera::orbit(0.5 * (min + max), 0.5, 0.2, distance, 0.7, SIZE);
        Self::of_case(case)
    }

    fn of_case(mut case: StressCase) -> Self {
        case.options.supersampling = Supersampling::OFF;
        let (_, _, gaussians) = reference::stored(&case.avatar, &case.posed);
        let splats = project::splats(&gaussians, &case.camera, case.scene().filter(), 0);
        let order = sort::order(&splats);
        Self {
            case,
            splats,
            order,
        }
    }

    fn image(&self) -> FrameImage {
        raster::raster(&self.splats, &self.order, &self.case.camera).to_image()
    }

    /// The bound of the case as it is drawn.
    fn bound(&self, drawing: DrawSettings) -> ImageBound {
        let mut options = self.case.options;
        options.skip = drawing.skip;
        options.exact = drawing.exact;
        drawing.rasterizer.choose(&mut options);
        let mut scene = self.case.scene();
        scene.options = &options;
        ImageBound::new(&scene, &Rounding::of_options(&options))
    }

    /// The splats that contribute most, most first.
    fn strongest(&self) -> Vec<usize> {
        let shares = raster::contributions(&self.splats, &self.order, &self.case.camera);
        let mut all: Vec<usize> = (0..shares.len()).collect();
        all.sort_by(|&a, &b| shares[b].total_cmp(&shares[a]));
        all.truncate(CANDIDATES);
        all
    }

    /// The image with one splat changed.
    fn changed(&self, at: usize, change: impl Fn(&mut Splat)) -> FrameImage {
        let mut splats = self.splats.clone();
        if let Ok(splat) = &mut splats[at] {
            change(splat);
        }
        raster::raster(&splats, &self.order, &self.case.camera).to_image()
    }

    /// The image with a splat drawn behind one that the reference has well behind it, and that one
    /// in front: the pair of other colours that overlap most.
    fn swapped(&self, at: usize) -> Option<FrameImage> {
        let nearer = self.splats[at].as_ref().ok()?;
        let further = (0..self.splats.len()).filter_map(|other| {
            let splat = self.splats[other].as_ref().ok()?;
            let apart = splat.depth > nearer.depth * 1.01;
            let beside =
                (splat.center - nearer.center).length() < 0.5 * nearer.radius.min_element();
            let differs = (splat.color - nearer.color).abs().max_element() > 0.3;
            (apart && beside && differs).then_some((other, splat.opacity * splat.radius.length()))
        });
        let (other, _) = further.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let mut order = self.order.clone();
        let [a, b] = [at, other].map(|k| {
            let place = order.iter().position(|&own| own as usize == k);
            place.expect("it is drawn")
        });
        order.swap(a, b);
        Some(raster::raster(&self.splats, &order, &self.case.camera).to_image())
    }
}

/// The drawings whose bounds must see every fault: each rasterizer, and tiles in either format.
fn drawings() -> Vec<DrawSettings> {
    let mut all: Vec<DrawSettings> = Rasterizer::ALL
        .into_iter()
        .map(|rasterizer| DrawSettings {
            rasterizer,
            exact: true,
            skip: Skip::all(),
        })
        .collect();
    let tiles = all[2];
    all.push(DrawSettings {
        exact: false,
        ..tiles
    });
    all.push(DrawSettings {
        skip: Skip::empty(),
        ..tiles
    });
    all
}

/// Images with a fault each, and what it is.
fn faults(frame: &FaultyFrame) -> Vec<(&'static str, Vec<FrameImage>)> {
    let strongest = frame.strongest();
    let each = |change: fn(&mut Splat)| -> Vec<FrameImage> {
        strongest
            .iter()
            .map(|&at| frame.changed(at, change))
            .collect()
    };
    vec![
        ("an opacity 5 % off", each(|s| s.opacity *= 0.95)),
        (
            "a centre 0.3 px off",
            each(|s| s.center += DVec2::new(0.3, 0.0)),
        ),
        (
            "a colour 4/255 off",
            each(|s| {
                s.color += if s.color.x > 0.5 {
                    -4.0 / 255.0
                } else {
                    4.0 / 255.0
                }
            }),
        ),
        ("a splat left out", each(|s| s.opacity = 0.0)),
        (
            "a covariance 1.1 times as large",
            each(|s| {
                s.covariance = s.covariance.map(|v| 1.1 * v);
                s.determinant *= 1.1 * 1.1;
                s.radius *= 1.1f64.sqrt();
            }),
        ),
        (
            "two splats swapped",
            strongest
                .iter()
                .filter_map(|&at| frame.swapped(at))
                .collect(),
        ),
        ("a tile missing", vec![without_a_tile(frame)]),
    ]
}

/// The image without 16 × 16 px around the strongest splat.
fn without_a_tile(frame: &FaultyFrame) -> FrameImage {
    let mut image = frame.image();
    let at = frame.strongest()[0];
    let center = frame.splats[at].as_ref().expect("it is drawn").center;
    let size = image.size;
    let from = [center.x, center.y].map(|v| (v / 16.0).max(0.0) as u32 * 16);
    for y in from[1]..(from[1] + 16).min(size[1]) {
        for x in from[0]..(from[0] + 16).min(size[0]) {
            image.pixels[(y * size[0] + x) as usize] = [0.0; 4];
        }
    }
    image
}

fn assert_sees_every_fault(frame: &FaultyFrame) {
    let image = frame.image();
    let faults = faults(frame);
    for drawing in drawings() {
        let bound = frame.bound(drawing);
        let used = bound.used_by(&image);
        assert!(used.largest == 0.0, "the reference itself: {used:?}");
        for (what, images) in &faults {
            assert!(!images.is_empty(), "{what}: no such fault in this case");
            let seen = images.iter().filter(|image| !bound.used_by(image).holds());
            let seen = seen.count();
            assert!(
                seen >= drawing.least_seen(images.len()),
                "{what}: seen {seen} of {} times with {drawing:?}",
                images.len()
            );
        }
    }
}

#[test]
fn faults_in_a_cloud_are_seen() {
    assert_sees_every_fault(&FaultyFrame::new(Category::Refused, 400));
}

#[test]
fn faults_in_a_closed_body_are_seen() {
    assert_sees_every_fault(&FaultyFrame::new(Category::Solid, usize::MAX));
}

/// The bound's own blending is the reference's.
#[test]
fn the_reference_is_at_the_middle_of_its_bound() {
    for number in 0..2 * Category::ROUND {
        let frame = FaultyFrame::of_case(StressCase::new(SEED, number, false));
        let options = frame.case.options;
        let bound = ImageBound::new(&frame.case.scene(), &Rounding::of_options(&options));
        let own = bound.reference();
        for (at, (own, drawn)) in own.pixels.iter().zip(frame.image().pixels).enumerate() {
            let error = (0..4).map(|k| (own[k] - drawn[k]).abs());
            assert!(
                // Written so that NaN fails.
                error.clone().all(|error| error < 1e-6),
                "case {number} ({}), pixel {at}: {:?}",
                frame.case.category.name(),
                error.collect::<Vec<_>>()
            );
        }
    }
}
