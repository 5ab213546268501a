//! The page about phones has the tables that its inputs give.

use effigy_measure::phone_model::{Inputs, PhoneModel, replace_tables};
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

tests! {
    the_page_has_the_tables_of_its_inputs,
    a_stage_takes_between_its_bounds,
    a_missing_rate_is_named,
}
