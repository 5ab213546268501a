//! The perceptual loss on the device: each kernel against its twin on the CPU, and the loss of
//! whole networks inside a step.

use crate::{
    common::{self, Random, Sizes, gpu},
    train,
};
use effigy_core::scene::{Camera, Posed};
use effigy_perceptual::convolution::Convolution;
use effigy_perceptual::maps::Maps;
use effigy_perceptual::network::{ConvolutionShape, NetworkStep};
use effigy_perceptual::{Network, Perceptual, blur, head, pool, thin};
use effigy_render::vulkan::Gpu;
use effigy_render::vulkan::compute::{Buffer, BufferUsageFlags};
use effigy_train::gpu::image_loss::convolution::DeviceConvolution;
use effigy_train::gpu::image_loss::operation::{DeviceMaps, DistanceMemory, Operation};
use effigy_train::gpu::{AskedPart, ImageLossMemory, StepOptions, Trainer, TrainerState};
use effigy_train::loss::LossWeights;
use effigy_train::parameters::{ParameterLayout, Parameters};
use effigy_train::perceptual::PerceptualLoss;
use effigy_train::recipe::{PerceptualOptions, Preset};
use effigy_train::topology::{CorrectiveRows, Topology};
use effigy_train::view::{TrainingView, ViewPicture};
use glam::DVec3;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Maps of noise around 0. With `levels` there are so few numbers that windows have several of the
/// greatest; 0: no two are alike.
fn noise(seed: u64, channels: usize, size: [usize; 2], levels: usize) -> Maps {
    let random = &mut Random(seed);
    let mut maps = Maps::zeros(channels, size);
    for number in &mut maps.data {
        *number = match levels {
            0 => random.normal() as f32,
            _ => random.below(levels) as f32 - 1.0,
        };
    }
    maps
}

/// Maps in the device's memory.
struct Held {
    buffer: Buffer,
    maps: DeviceMaps,
}

impl Held {
    /// Of pictures of one shape, one after the other.
    fn new(gpu: &Arc<Gpu>, pictures: &[&Maps]) -> Self {
        let numbers: Vec<f32> = pictures.iter().flat_map(|maps| maps.data.clone()).collect();
        let buffer = upload(gpu, &numbers);
        Self {
            maps: DeviceMaps {
                slice: (&buffer).into(),
                pictures: pictures.len(),
                channels: pictures[0].channels,
                size: pictures[0].size,
            },
            buffer,
        }
    }

    /// What is to be written: NaN until then.
    fn empty(gpu: &Arc<Gpu>, pictures: usize, channels: usize, size: [usize; 2]) -> Self {
        let mut maps = Maps::zeros(channels, size);
        maps.data.fill(f32::NAN);
        Self::new(gpu, &vec![&maps; pictures])
    }

    fn numbers(&self) -> Vec<f32> {
        let DeviceMaps {
            pictures, channels, ..
        } = self.maps;
        let count = pictures * channels * self.maps.plane();
        bytemuck::pod_collect_to_vec(&self.buffer.download(4 * count).unwrap())
    }
}

fn upload(gpu: &Arc<Gpu>, numbers: &[f32]) -> Buffer {
    let usage = BufferUsageFlags::STORAGE_BUFFER | BufferUsageFlags::TRANSFER_SRC;
    Buffer::with_data(gpu, "test maps", bytemuck::cast_slice(numbers), usage).unwrap()
}

fn run(gpu: &Arc<Gpu>, operation: &Operation) {
    gpu.run("a test", |commands| operation.record(commands))
        .unwrap();
}

/// That all numbers are the twin's, but for `tolerance` of the largest.
#[track_caller]
fn assert_twin(what: &str, found: &[f32], expected: &[f32], tolerance: f64) {
    let doubles = |numbers: &[f32]| numbers.iter().map(|&n| f64::from(n)).collect::<Vec<f64>>();
    let expected = doubles(expected);
    let largest = expected.iter().fold(0.0, |max: f64, n| max.max(n.abs()));
    assert!(largest > 0.0, "{what}: nothing but zeros");
    gpu::assert_close(what, &doubles(found), &expected, tolerance * largest);
}

/// Of sums whose order is another: twice the square root of 1,600 additions' rounding.
const SUMS: f64 = 5e-6;

const fn shape(channels: [usize; 2], window: usize, pad: usize, stride: usize) -> ConvolutionShape {
    ConvolutionShape {
        name: "",
        from: channels[0],
        to: channels[1],
        window,
        pad,
        stride,
    }
}

/// Every kind of window of the networks, with channels that fill no tile, and pictures that do not.
fn convolutions_are_the_cpus() {
    let gpu = &gpu::gpu();
    let cases = [
        (shape([3, 64], 11, 2, 1), [41, 37]),
        (shape([6, 70], 5, 2, 1), [33, 9]),
        (shape([9, 20], 3, 1, 1), [20, 35]),
        (shape([3, 6], 11, 2, 4), [47, 40]),
    ];
    for (shape, size) in cases {
        let weight = noise(1, shape.to, [shape.fan(), 1], 0).data;
        let bias = noise(2, shape.to, [1, 1], 0).data;
        let own = Convolution::new(shape, weight, bias);
        let held = DeviceConvolution::new(gpu, &own).unwrap();
        let pictures = [3, 4].map(|seed| noise(seed, shape.from, size, 0));
        let read = Held::new(gpu, &[&pictures[0], &pictures[1]]);
        let to = size.map(|side| NetworkStep::Convolve(shape).side(side));
        for rectifies in [false, true] {
            let written = Held::empty(gpu, 2, shape.to, to);
            run(
                gpu,
                &held
                    .forward(gpu, read.maps, written.maps, rectifies)
                    .unwrap(),
            );
            let expected = pictures
                .clone()
                .map(|maps| own.forward(&maps, rectifies).data);
            let what = format!("{shape:?}, rectified: {rectifies}");
            assert_twin(&what, &written.numbers(), &expected.concat(), SUMS);
        }
        let gradient = noise(5, shape.to, to, 0);
        let expected = own.backward(&gradient, size);
        let of_written = Held::new(gpu, &[&gradient]);
        for kept in [None, Some(read.maps.slice)] {
            let of_read = Held::empty(gpu, 1, shape.from, size);
            run(
                gpu,
                &held
                    .backward(gpu, of_written.maps, of_read.maps, kept)
                    .unwrap(),
            );
            let mut expected = expected.data.clone();
            for (number, &own) in expected.iter_mut().zip(&pictures[0].data) {
                let is_kept = kept.is_none() || own > 0.0;
                *number = if is_kept { *number } else { 0.0 };
            }
            let what = format!("{shape:?} backward, masked: {}", kept.is_some());
            assert_twin(&what, &of_read.numbers(), &expected, SUMS);
        }
    }
}

/// Sides of all kinds, the smallest among them.
const SIZES: [[usize; 2]; 4] = [[3, 3], [4, 5], [35, 18], [6, 71]];

fn blurs_are_the_cpus() {
    let gpu = &gpu::gpu();
    for size in SIZES {
        let input = noise(6, 5, size, 0);
        let read = Held::new(gpu, &[&input, &input]);
        let expected = blur::forward(&input);
        for rectifies in [false, true] {
            let written = Held::empty(gpu, 2, 5, expected.size);
            run(
                gpu,
                &Operation::blur(gpu, read.maps, written.maps, rectifies).unwrap(),
            );
            let both = [&expected.data[..]; 2].concat();
            let least = if rectifies { 0.0 } else { f32::MIN };
            let both: Vec<f32> = both.iter().map(|n| n.max(least)).collect();
            assert_twin(
                &format!("blur of {size:?}"),
                &written.numbers(),
                &both,
                1e-6,
            );
        }
        let gradient = noise(7, 5, expected.size, 0);
        let of_written = Held::new(gpu, &[&gradient]);
        let of_read = Held::empty(gpu, 1, 5, size);
        run(
            gpu,
            &Operation::blur_backward(gpu, of_written.maps, of_read.maps).unwrap(),
        );
        let expected = blur::backward(&gradient, size);
        let what = format!("blur of {size:?} backward");
        assert_twin(&what, &of_read.numbers(), &expected.data, 1e-6);
    }
}

/// To the bit, but for the order in which derivatives are added.
fn greatest_numbers_are_the_cpus() {
    let gpu = &gpu::gpu();
    for (size, window) in SIZES.into_iter().flat_map(|size| [(size, 2), (size, 3)]) {
        let input = noise(8, 4, size, 4);
        let output = pool::forward(&input, window);
        let read = Held::new(gpu, &[&input, &input]);
        let written = Held::empty(gpu, 2, 4, output.size);
        run(
            gpu,
            &Operation::pool(gpu, read.maps, written.maps, window).unwrap(),
        );
        assert!(
            written.numbers() == [&output.data[..]; 2].concat(),
            "{size:?}, {window}"
        );
        let gradient = noise(9, 4, output.size, 0);
        let of_written = Held::new(gpu, &[&gradient]);
        let of_read = Held::empty(gpu, 1, 4, size);
        let forward = [read.maps.slice, written.maps.slice];
        let back = Operation::pool_backward(gpu, of_written.maps, of_read.maps, forward, window);
        run(gpu, &back.unwrap());
        let expected = pool::backward(&gradient, &input, &output, window);
        let what = format!("greatest of {window} in {size:?} backward");
        assert_twin(&what, &of_read.numbers(), &expected.data, 1e-6);
    }
}

fn thinned_maps_are_the_cpus() {
    let gpu = &gpu::gpu();
    for size in SIZES {
        let input = noise(10, 3, size, 0);
        let output = thin::forward(&input, 2);
        let read = Held::new(gpu, &[&input, &input]);
        let written = Held::empty(gpu, 2, 3, output.size);
        run(
            gpu,
            &Operation::thin(gpu, read.maps, written.maps, 2).unwrap(),
        );
        assert!(
            written.numbers() == [&output.data[..]; 2].concat(),
            "{size:?}"
        );
        let gradient = noise(11, 3, output.size, 0);
        let of_written = Held::new(gpu, &[&gradient]);
        let of_read = Held::empty(gpu, 1, 3, size);
        run(
            gpu,
            &Operation::thin_backward(gpu, of_written.maps, of_read.maps, 2).unwrap(),
        );
        let expected = thin::backward(&gradient, size, 2);
        assert!(of_read.numbers() == expected.data, "{size:?} backward");
    }
}

fn distances_are_the_cpus() {
    let gpu = &gpu::gpu();
    for (channels, size) in [(5, [7, 5]), (64, [19, 8]), (9, [1, 1])] {
        let rectified = |seed| {
            let mut maps = noise(seed, channels, size, 0);
            maps.data
                .iter_mut()
                .for_each(|number| *number = number.max(0.0));
            // A pixel of which nothing is seen.
            if maps.plane() > 1 {
                let plane = maps.plane();
                maps.data.iter_mut().step_by(plane).for_each(|n| *n = 0.0);
            }
            maps
        };
        let (ours, theirs) = (rectified(12), rectified(13));
        let weights: Vec<f32> = noise(14, channels, [1, 1], 0)
            .data
            .iter()
            .map(|n| n.abs())
            .collect();
        let deeper = noise(15, channels, size, 0);
        let both = Held::new(gpu, &[&ours, &theirs]);
        let held = upload(gpu, &weights);
        let expected = head::distance(&ours, &head::unit(&theirs), &weights, true);
        let slopes = expected.gradient.unwrap();
        for adds in [false, true] {
            let gradient = Held::new(gpu, &[&deeper]);
            let first = 3;
            let count = Operation::distance_sums(size[0] * size[1]);
            let sums = Held::empty(gpu, 1, first + count, [1, 1]);
            let memory = DistanceMemory {
                maps: both.maps,
                weights: (&held).into(),
                gradient: gradient.maps.slice,
                sums: sums.maps.slice,
                first,
            };
            run(gpu, &Operation::distance(gpu, memory, adds).unwrap());
            let found: f64 = sums.numbers()[first..].iter().map(|&n| f64::from(n)).sum();
            assert!(
                (found - expected.value).abs() <= 1e-5 * expected.value,
                "{found}, expected {}",
                expected.value
            );
            let added = deeper.data.iter().map(|n| if adds { *n } else { 0.0 });
            let rows = slopes.data.iter().zip(added).zip(&ours.data);
            let all: Vec<f32> = rows
                .map(|((slope, added), own)| if *own > 0.0 { slope + added } else { 0.0 })
                .collect();
            let what = format!("distance of {channels} channels, {size:?}");
            assert_twin(&what, &gradient.numbers(), &all, 1e-5);
        }
    }
}

/// An avatar and two views whose pictures are noise.
struct Scene {
    topology: Topology,
    rows: CorrectiveRows,
    start: TrainerState,
    views: Vec<TrainingView>,
}

const SIZE: [u32; 2] = [50, 61];
const PART: [usize; 2] = [40, 45];
/// One of each view.
const PARTS: [AskedPart; 2] = [
    AskedPart {
        first: [3, 16],
        weight: 0.2,
    },
    AskedPart {
        first: [10, 0],
        weight: 0.3,
    },
];

/// Nothing is learned, the first moment is the derivative, and the part's loss alone counts.
const STILL: StepOptions = StepOptions {
    weights: LossWeights {
        l1: 0.0,
        scale: 0.0,
        scale_above: 0.01,
        correctives: [0.0; 3],
    },
    joints: false,
    ..train::STILL
};

impl Scene {
    fn new() -> Self {
        let avatar = common::avatar(
            21,
            Sizes {
                gaussians: 500,
                parts: 5,
                nodes: 40,
                rows: 300,
                split_features: true,
                ..Sizes::default()
            },
        );
        let topology = Topology::new(&avatar);
        let rows = CorrectiveRows::of(&avatar);
        let layout = ParameterLayout::new(&topology, &rows);
        let parameters = Parameters::of(&avatar, &layout);
        let random = &mut Random(22);
        let mut picture = || {
            let pixels = SIZE[0] * SIZE[1];
            let byte = |random: &mut Random| random.below(256) as u8;
            let colors = |random: &mut Random| [byte(random), byte(random), byte(random), 255];
            let mut shown: Vec<[u8; 4]> = (0..pixels).map(|_| colors(random)).collect();
            shown.iter_mut().step_by(7).for_each(|pixel| pixel[3] = 0);
            let behind = (0..pixels).map(|_| colors(random)).collect();
            Arc::new(ViewPicture {
                size: SIZE,
                pixels: shown,
                behind,
            })
        };
        let view = |number: u64, picture| {
            let posed = Posed::new(&avatar, &common::pose(number, &avatar));
            let middle = posed.joints[0].transform_point3(DVec3::new(0.0, 0.9, 0.0));
            TrainingView {
                joints: posed.joints,
                input: posed.input,
                camera: Camera::orbit(middle, number as f64, 0.1, 3.5, 0.61, SIZE),
                gain: DVec3::new(0.9, 0.85, 0.95),
                whole: u64::from(SIZE[0] * SIZE[1]),
                picture,
            }
        };
        let views = vec![view(0, picture()), view(1, picture())];
        Self {
            start: TrainerState::new(&layout, parameters),
            topology,
            rows,
            views,
        }
    }

    fn trainer(&self) -> Trainer {
        let views = self.views.len();
        let Self {
            topology,
            rows,
            start,
            ..
        } = self;
        Trainer::new(&gpu::gpu(), topology, rows, start, SIZE, views).unwrap()
    }
}

/// A step on the device against one in which the CPU works out the loss: all that is learned.
/// `window`: side of the part, px.
fn compare_steps(network: Option<Perceptual>, window: u32, views: &[TrainingView], scene: &Scene) {
    let name = network
        .as_ref()
        .map_or("D-SSIM", |own| own.network().title());
    let options = PerceptualOptions {
        window,
        ..Preset::Paper.recipe().perceptual
    };
    let loss = PerceptualLoss::with_network(network, &options, 5);
    let goes_on = AtomicBool::new(false);
    let step = |on_device: bool| {
        let mut trainer = scene.trainer();
        if on_device {
            loss.hand_over(&mut trainer, SIZE).unwrap();
        }
        let found = loss.step(&mut trainer, views, &STILL, 9, &goes_on);
        let value = found.unwrap().unwrap().value;
        (value, trainer.state().unwrap().first_moments)
    };
    let ((value, found), (expected_value, expected)) = (step(true), step(false));
    println!("{name}: {value}, expected {expected_value}");
    assert!((value - expected_value).abs() < 1e-5 * expected_value);
    for (found, expected) in found.arrays().into_iter().zip(expected.arrays()) {
        let length =
            |numbers: &mut dyn Iterator<Item = f64>| numbers.map(|n| n * n).sum::<f64>().sqrt();
        let pairs = found.iter().zip(expected);
        let off = length(&mut pairs.map(|(a, b)| f64::from(a - b)));
        let of = length(&mut expected.iter().map(|&n| f64::from(n)));
        println!("{name}: {:.1e} of {of:.1e}", off / of);
        // Rounding may make a few numbers pass 0, or another pixel the greatest.
        assert!(of > 0.0 && off < 1e-3 * of, "{name}: {off} of {of}");
    }
}

/// Several views follow each other in the same memory.
fn losses_of_parts_are_the_cpus() {
    let scene = Scene::new();
    compare_steps(None, 32, &scene.views, &scene);
    let network = Perceptual::random(Network::LpipsAlex, 23);
    compare_steps(Some(network), 32, &scene.views, &scene);
}

fn st_lpips_is_the_cpus() {
    let scene = Scene::new();
    let network = Perceptual::random(Network::Alex, 23);
    compare_steps(Some(network), 24, &scene.views[..1], &scene);
}

/// Views without a part are asked for nothing, and equal steps give equal bits.
fn steps_with_parts_give_equal_bits() {
    let scene = Scene::new();
    let network = Perceptual::random(Network::LpipsAlex, 24);
    let learning = StepOptions {
        joints: false,
        ..train::LEARNING
    };
    let run = |parts: &[Option<AskedPart>]| {
        let mut trainer = scene.trainer();
        trainer.add_image_loss(Some(&network), PART).unwrap();
        for _ in 0..3 {
            trainer
                .step_with_parts(&scene.views, &learning, parts)
                .unwrap();
        }
        trainer.state().unwrap()
    };
    let both = PARTS.map(Some);
    let first = run(&both);
    assert!(first.parameters.gaussians.iter().all(|v| v.is_finite()));
    assert!(first == run(&both), "equal steps give other bits");
    let one = run(&[None, both[1]]);
    assert!(one != first, "the first view's part counts for nothing");
    assert!(
        run(&[None, None]) == run(&[]),
        "a part that is not there counts"
    );
}

/// Memory that was told is what the loss takes: never more, and all but what vectors are padded by.
fn memory_of_the_loss_is_told() {
    let scene = Scene::new();
    let device = gpu::gpu();
    for kind in [Some(Network::Alex), Some(Network::LpipsVgg), None] {
        let network = kind.map(|kind| Perceptual::random(kind, 25));
        let mut trainer = scene.trainer();
        let (before, _) = device.memory();
        trainer.add_image_loss(network.as_ref(), PART).unwrap();
        let (after, _) = device.memory();
        let told = ImageLossMemory::new(kind, PART, scene.views.len()).bytes;
        let taken = after - before;
        println!("{kind:?}: {taken} bytes, told {told}");
        assert!(
            taken.abs_diff(told) < told / 50 + 65_536,
            "{taken} bytes, told {told}"
        );
    }
}

tests! {
    convolutions_are_the_cpus,
    blurs_are_the_cpus,
    greatest_numbers_are_the_cpus,
    thinned_maps_are_the_cpus,
    distances_are_the_cpus,
    losses_of_parts_are_the_cpus,
    st_lpips_is_the_cpus,
    steps_with_parts_give_equal_bits,
    memory_of_the_loss_is_told,
}
