//! ST-LPIPS with its published weights, read from the file and held against what another program
//! found; D-SSIM against the measured SSIM.

use crate::common::harness::not_run;
use effigy_core::scene::FrameImage;
use effigy_measure::similarity::similarity;
use effigy_perceptual::{Network, Perceptual, Planes, dssim};
use serde::Deserialize;
use std::{fs, path::PathBuf};

/// What tests/data/perceptual/make.py found.
#[derive(Deserialize)]
struct Found {
    rows: Vec<Row>,
}

#[derive(Deserialize)]
struct Row {
    network: String,
    weights: String,
    size: [usize; 2],
    direction: String,
    value: f64,
    slope: f64,
}

/// The folder with the weights of a network. Ends the test where they are not there.
fn weights(network: Network) -> PathBuf {
    let folder = std::env::var("EFFIGY_ASSETS")
        .unwrap_or_else(|_| effigy_learn::bake::Assets::DEFAULT.into());
    let path = std::path::absolute(&folder).expect("the folder has a name");
    if let Some(file) = network.missing(&path) {
        not_run(format!(
            "no {} in {folder}: run tools/fetch_perceptual.sh or set EFFIGY_ASSETS",
            file.name
        ));
    }
    path
}

fn dot(a: &Planes, b: &Planes) -> f64 {
    let pairs = a.data.iter().zip(&b.data);
    pairs.map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
}

fn published_weights_give_known_numbers(network: Network) {
    let perceptual = Perceptual::read(network, &weights(network)).expect("the published file");
    perceptual.check().expect("what make.py found");
    let text = include_str!("../data/perceptual/values.json");
    let found: Found = serde_json::from_str(text).expect("values.json is what make.py writes");
    let mut compared = 0;
    for row in &found.rows {
        if row.network != network.name() || row.weights != "file" {
            continue;
        }
        let [image, target] = [0, 1].map(|kind| effigy_perceptual::picture(kind, row.size));
        let mut along = effigy_perceptual::direction(row.size);
        if row.direction == "towards" {
            let pairs = target.data.iter().zip(&image.data);
            along.data = pairs.map(|(a, b)| a - b).collect();
        }
        let graded = perceptual.value_and_gradient(&image, &perceptual.features(&target));
        let name = format!("{} {:?} {}", row.network, row.size, row.direction);
        let off = graded.value / row.value - 1.0;
        assert!(off.abs() < 1e-5, "{name}: {} is off by {off}", graded.value);
        let slope = dot(&graded.gradient, &along);
        let lengths = (dot(&graded.gradient, &graded.gradient) * dot(&along, &along)).sqrt();
        let usual = lengths / (image.data.len() as f64).sqrt();
        let off = (slope - row.slope) / usual;
        println!(
            "{name}: value {}, slope {slope}, off by {off}",
            graded.value
        );
        assert!(off.abs() < 1e-3, "{name}: {slope}, expected {}", row.slope);
        compared += 1;
    }
    assert_eq!(compared, 6);
}

fn alex_gives_known_numbers() {
    published_weights_give_known_numbers(Network::Alex);
}

fn vgg_gives_known_numbers() {
    published_weights_give_known_numbers(Network::Vgg);
}

/// Blur is worse than a shift by a pixel, and a little noise is hardly seen: section 7.2 of the
/// research found this with the published pictures.
fn it_forgives_a_shift_and_punishes_blur() {
    let perceptual = Perceptual::read(Network::Alex, &weights(Network::Alex)).expect("the file");
    let side = 64;
    let at = |x: usize, y: usize| {
        let leaf = (x as f32 / 5.0).sin() * (y as f32 / 7.0).cos() + (x * y % 17) as f32 / 17.0;
        (0.4 + 0.2 * leaf).clamp(0.0, 1.0)
    };
    let picture = |value: &dyn Fn(usize, usize) -> f32| {
        let mut planes = Planes::black([side; 2]);
        for (i, number) in planes.data.iter_mut().enumerate() {
            *number = value(i % side + 2, i / side % side + 2);
        }
        planes
    };
    let target = perceptual.features(&picture(&at));
    let distance = |value: &dyn Fn(usize, usize) -> f32| perceptual.value(&picture(value), &target);
    let shifted = distance(&|x, y| at(x + 1, y));
    let blurred = distance(&|x, y| {
        let near = (0..9).map(|k| at(x + k % 3 - 1, y + k / 3 - 1));
        near.sum::<f32>() / 9.0
    });
    assert!(blurred > 3.0 * shifted, "blur {blurred}, shift {shifted}");
}

fn wrong_files_say_what_was_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(Network::Alex.files()[0].name);
    let read = |bytes: &[u8]| {
        fs::write(&path, bytes).expect("a file can be written");
        let read = Perceptual::read(Network::Alex, folder.path());
        read.expect_err("no weights").to_string()
    };
    let missing = Perceptual::read(Network::Alex, folder.path());
    let missing = missing.expect_err("no file").to_string();
    assert!(missing.contains("tools/fetch_perceptual.sh"), "{missing}");
    for bytes in [&b""[..], b"weights", b"\x80\x02.", b"PK\x03\x04"] {
        let error = read(bytes);
        assert!(error.contains("found"), "{error}");
    }
    // A dictionary of another network.
    let error = read(b"\x80\x02}X\x04\x00\x00\x00nameK\x01s.");
    assert!(
        error.contains("scaling_layer.shift") && error.contains("a dictionary of name"),
        "{error}"
    );
}

fn spoiled_files_are_refused() {
    let name = |network: Network| network.files()[0].name;
    let bytes = fs::read(weights(Network::Alex).join(name(Network::Alex)));
    let bytes = bytes.expect("the file can be read");
    let folder = tempfile::tempdir().expect("a folder");
    let read = |network, bytes: &[u8]| {
        fs::write(folder.path().join(name(network)), bytes).expect("a file can be written");
        let read = Perceptual::read(network, folder.path());
        read.expect_err("spoiled weights").to_string()
    };
    for length in [bytes.len() - 1, bytes.len() / 2, 3000, 200, 15] {
        let error = read(Network::Alex, &bytes[..length]);
        assert!(error.contains("found"), "{length}: {error}");
    }
    // A number that is another one, and one that is none.
    let mut changed = bytes.clone();
    let place = bytes.len() - 4_000_001;
    changed[place - place % 4 + 2] ^= 0xff;
    changed[place - place % 4 + 3] ^= 0x45;
    let error = read(Network::Alex, &changed);
    assert!(error.contains("found"), "{error}");
    let error = read(Network::Vgg, &bytes);
    assert!(
        error.contains("net.slice1.0.weight") && error.contains("[64, 3, 3, 3]"),
        "{error}"
    );
}

/// The measured SSIM is over the mask's box, in f64: the same where all is covered.
fn dssim_is_one_less_the_measured_ssim() {
    let size = [37, 29];
    let [image, target] = [0, 1].map(|kind| effigy_perceptual::picture(kind, size));
    let covered = |planes: &Planes| {
        let mut image = FrameImage::empty(size.map(|side| side as u32));
        let plane = size[0] * size[1];
        for (i, pixel) in image.pixels.iter_mut().enumerate() {
            let color: [f32; 3] = std::array::from_fn(|c| planes.data[c * plane + i]);
            *pixel = [color[0], color[1], color[2], 1.0];
        }
        image
    };
    let measured = similarity(&covered(&image), &covered(&target)).expect("all is covered");
    let found = dssim(&image, &target);
    assert!(
        (found - (1.0 - measured.ssim)).abs() < 1e-6,
        "{found}, {measured:?}"
    );
}

tests! {
    alex_gives_known_numbers,
    vgg_gives_known_numbers,
    it_forgives_a_shift_and_punishes_blur,
    wrong_files_say_what_was_found,
    spoiled_files_are_refused,
    dssim_is_one_less_the_measured_ssim,
}
