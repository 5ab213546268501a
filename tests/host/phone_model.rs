//! The page about phones has the tables that its inputs give.

use effigy_measure::phone_model::{Inputs, PhoneModel, Rate, replace_tables};
use std::{
    fs,
    path::{Path, PathBuf},
};

fn docs() -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs")).to_path_buf()
}

fn inputs() -> Inputs {
    let docs = docs();
    let shaders = docs.join("experiments/data/shaders.csv");
    Inputs::read(&docs.join("phone-model"), &shaders).unwrap()
}

fn the_page_has_the_tables_of_its_inputs() {
    let tables = PhoneModel::new(inputs()).unwrap().tables();
    let page = fs::read_to_string(docs().join("phone-model.md")).unwrap();
    let expected = replace_tables(&page, &tables).unwrap();
    assert!(
        page == expected,
        "run `effigy phone-model --page docs/phone-model.md`"
    );
}

fn a_stage_takes_between_its_bounds() {
    let model = PhoneModel::new(inputs()).unwrap();
    let devices = model.inputs.devices.len();
    assert_eq!(model.frames.len(), devices * model.inputs.counted.len());
    for frame in &model.frames {
        let mut sum = 0.0;
        for stage in &frame.stages {
            let ms = stage.ms();
            assert!(
                0.0 < ms.low && ms.low <= ms.high && ms.high < 100.0,
                "{} on {}: {ms:?}",
                stage.stage,
                frame.device
            );
            for bound in &stage.bounds {
                assert!(bound.ms.low <= ms.low && bound.ms.high <= ms.high);
            }
            sum += ms.low;
        }
        assert!((frame.ms().low - sum).abs() < 1e-9);
    }
}

fn a_missing_rate_is_named() {
    let mut inputs = inputs();
    inputs
        .rates
        .retain(|rate| rate.device != "Adreno 740" || rate.rate != "blending");
    let error = PhoneModel::new(inputs).unwrap_err().to_string();
    assert!(
        error.contains("blending") && error.contains("Adreno 740"),
        "{error}"
    );
}

fn a_rate_of_nothing_is_refused() {
    let mut inputs = inputs();
    let is_it = |rate: &&mut Rate| rate.device == "Adreno 740" && rate.rate == "blending";
    inputs.rates.iter_mut().find(is_it).unwrap().low = 0.0;
    let error = PhoneModel::new(inputs).unwrap_err().to_string();
    for part in ["blending", "Adreno 740", "from 0", "more than 0"] {
        assert!(error.contains(part), "{error}");
    }
}

fn what_stands_twice_is_refused() {
    let mut twice = inputs();
    let first = twice.rates[0].clone();
    twice.rates.push(first);
    let error = PhoneModel::new(twice).unwrap_err().to_string();
    assert!(
        error.contains("2 lines") && error.contains("rate"),
        "{error}"
    );

    let docs = docs();
    let text = fs::read_to_string(docs.join("experiments/data/shaders.csv")).unwrap();
    let start = format!("{},raster/quads.frag,", inputs().devices[0].compiled_as);
    let line = text.lines().find(|line| line.starts_with(&start));
    let folder = tempfile::tempdir().unwrap();
    let shaders = folder.path().join("shaders.csv");
    fs::write(&shaders, format!("{text}{}\n", line.unwrap())).unwrap();
    let twice = Inputs::read(&docs.join("phone-model"), &shaders).unwrap();
    let error = PhoneModel::new(twice).unwrap_err().to_string();
    for part in ["2 lines", "raster/quads.frag", "one is expected"] {
        assert!(error.contains(part), "{error}");
    }
}

tests! {
    the_page_has_the_tables_of_its_inputs,
    a_stage_takes_between_its_bounds,
    a_missing_rate_is_named,
    a_rate_of_nothing_is_refused,
    what_stands_twice_is_refused,
}
