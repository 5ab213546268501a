//! Quads or tiles, asked once: drivers that fail in every way while the rival is tried, what is
//! remembered of it, and trials by real frames.

use crate::{
    common::{self, Sizes, gpu},
    harness::not_run,
};
use effigy_core::{
    avatar::{Avatar, Pose},
    frame::RasterMethod,
    scene::{FrameImage, Posed},
};
use effigy_render::vulkan::{
    Error, Gpu, GpuOptions, Renderer, RendererOptions, Result,
    question::{MethodTrial, Question, QuestionScene, Race},
    raster::choice::MethodChoice,
    sort::choice::choose_in,
    trial::{TrialOutcome, Tried, withdraw},
};
use std::{
    fs,
    panic::{AssertUnwindSafe, catch_unwind},
    path::{Path, PathBuf},
    sync::Arc,
};

const CLASS: RasterMethod = RasterMethod::SharedTiles;
const RIVAL: RasterMethod = RasterMethod::Quads;

/// What a driver does with the rival.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    /// It ends the program while it compiles.
    Dies,
    /// It loses the device with the first frame.
    Loses,
    /// Its first frame never ends.
    Hangs,
    /// It has too little memory.
    Fills,
    /// One pixel is lost.
    Miscompiles,
    /// It leaves light where nothing is covered.
    Glows,
    /// An opacity is no number where nothing is covered.
    Garbles,
    /// It refuses the kernel.
    Refuses,
    /// The user closes the window while it compiles, and the program ends before it has.
    Closes,
}

/// A driver that takes 10 ms for a frame of the class's method, and more or less for the rival's.
struct Driver {
    /// Time of the rival's frames by that of the class's.
    ratio: f64,
    /// Time of the class's frames, ms.
    ms: f64,
    fault: Option<Fault>,
    /// Where the record is, to be looked at while kernels are compiled.
    folder: tempfile::TempDir,
    gpu: Arc<Gpu>,
    methods: [RasterMethod; 2],
    is_cpu: bool,
    opened: usize,
    pairs: usize,
}

impl Driver {
    fn new(ratio: f64) -> Self {
        Self {
            ratio,
            ms: 10.0,
            fault: None,
            folder: tempfile::tempdir().unwrap(),
            gpu: gpu::gpu(),
            methods: [CLASS, RIVAL],
            is_cpu: false,
            opened: 0,
            pairs: 0,
        }
    }

    fn failing(ratio: f64, fault: Fault) -> Self {
        Self {
            fault: Some(fault),
            ..Self::new(ratio)
        }
    }

    fn run(&mut self) -> Result<MethodChoice> {
        let [class, rival] = self.methods;
        let mut trial = MethodTrial::new(&self.gpu, rival, Some(self.folder.path()));
        trial.class = class;
        trial.is_cpu = self.is_cpu;
        trial.run(self)
    }

    /// Runs until the program ends.
    fn ends(&mut self) -> bool {
        catch_unwind(AssertUnwindSafe(|| self.run())).is_err()
    }

    fn record(&self) -> serde_json::Value {
        let text = fs::read_to_string(record_in(self.folder.path())).unwrap();
        serde_json::from_str(&text).unwrap()
    }
}

impl Race for Driver {
    fn images(&mut self, methods: [RasterMethod; 2]) -> Result<[FrameImage; 2]> {
        assert_eq!(methods, self.methods);
        self.opened += 1;
        let trying = serde_json::from_value(self.record()["trying"][0].clone());
        let rival: RasterMethod = trying.expect("on disk before it is compiled");
        assert_eq!(rival, self.methods[1]);
        // One lost pixel of so many is 57 dB.
        let side = 400;
        let covered = side * (side - 1);
        let body = [[0.5, 0.4, 0.3, 1.0]].repeat(covered);
        let own = FrameImage {
            size: [side as u32; 2],
            pixels: [body, vec![[0.0; 4]; side]].concat(),
        };
        let mut rivals = own.clone();
        let last = rivals.pixels.len() - 1;
        match self.fault {
            Some(Fault::Dies) => panic!("the driver ends the program"),
            Some(Fault::Closes) => {
                withdraw();
                panic!("the program ends");
            }
            Some(Fault::Refuses) => {
                return Err(Error::Overlay("the kernel is not compiled".into()));
            }
            Some(Fault::Loses) => return Err(Error::DeviceLost("a test")),
            Some(Fault::Hangs) => {
                return Err(Error::Timeout {
                    what: "a test",
                    seconds: 1,
                });
            }
            Some(Fault::Fills) => {
                return Err(Error::OutOfMemory {
                    memory: "device",
                    call: "a test",
                });
            }
            Some(Fault::Miscompiles) => rivals.pixels[7] = [0.0; 4],
            Some(Fault::Glows) => rivals.pixels[last] = [0.9, 0.0, 0.0, 0.0],
            Some(Fault::Garbles) => rivals.pixels[last][3] = f32::NAN,
            None => rivals.pixels[..covered].fill([0.502, 0.402, 0.302, 0.998]),
        }
        Ok([own, rivals])
    }

    fn pair(&mut self, number: usize) -> Result<[f64; 2]> {
        self.pairs += 1;
        // Its clock rises, and every third frame is disturbed.
        let clock = 1.0 - 0.05 * number as f64;
        let disturbed = if number % 3 == 1 { 1.4 } else { 1.0 };
        let ms = clock * self.ms;
        Ok([ms, disturbed * self.ratio * ms])
    }
}

/// The record in a folder.
fn record_in(folder: &Path) -> PathBuf {
    let files = fs::read_dir(folder).unwrap();
    let of_raster = |path: &PathBuf| path.to_string_lossy().contains("raster-");
    let files = files.map(|entry| entry.unwrap().path()).filter(of_raster);
    let mut files: Vec<PathBuf> = files.collect();
    assert_eq!(files.len(), 1, "{files:?}");
    files.remove(0)
}

fn outcome(choice: &MethodChoice) -> Option<&TrialOutcome> {
    Tried::outcome_of(&choice.tried, RIVAL)
}

fn the_faster_method_is_found_once() {
    for (ratio, expected) in [(0.5, RIVAL), (0.97, CLASS), (2.0, CLASS)] {
        let mut driver = Driver::new(ratio);
        let found = driver.run().unwrap();
        println!("{}: {}", found.method.name(), found.reason());
        assert_eq!(found.method, expected, "{ratio}");
        assert_eq!(driver.run().unwrap(), found);
        assert_eq!(driver.opened, 1, "the second time it is read");
    }
}

fn a_start_takes_no_longer_than_its_budget() {
    for (ms, pairs) in [(10.0, 5), (80.0, 3), (900.0, 1)] {
        let mut driver = Driver {
            ms,
            ..Driver::new(0.5)
        };
        assert_eq!(driver.run().unwrap().method, RIVAL);
        assert_eq!(driver.pairs, pairs, "frames of {ms} ms");
    }
}

fn a_wrong_image_is_never_drawn_however_fast() {
    for fault in [
        Fault::Miscompiles,
        Fault::Glows,
        Fault::Garbles,
        Fault::Refuses,
    ] {
        let mut driver = Driver::failing(0.1, fault);
        let choice = driver.run().unwrap();
        assert_eq!(choice.method, CLASS, "{fault:?}");
        let refused = matches!(outcome(&choice), Some(TrialOutcome::Refused(_)));
        assert!(refused, "{fault:?}: {choice:?}");
        assert_eq!(driver.run().unwrap(), choice);
        assert_eq!(driver.opened, 1, "{fault:?}: once");
    }
}

fn a_method_that_loses_or_hangs_the_device_is_tried_once() {
    for fault in [Fault::Loses, Fault::Hangs] {
        let mut driver = Driver::failing(0.1, fault);
        assert!(driver.run().is_err(), "{fault:?}: the device is gone");
        let choice = driver.run().unwrap();
        assert_eq!(choice.method, CLASS, "{fault:?}");
        assert_eq!(driver.opened, 1, "{fault:?}");
    }
}

fn what_may_pass_refuses_nothing_for_good() {
    let mut driver = Driver::failing(0.1, Fault::Fills);
    assert_eq!(driver.run().unwrap().method, CLASS);
    driver.fault = None;
    assert_eq!(driver.run().unwrap().method, RIVAL, "too little memory");
    let mut driver = Driver::failing(0.1, Fault::Hangs);
    driver.is_cpu = true;
    assert!(driver.run().is_err());
    driver.fault = None;
    assert_eq!(driver.run().unwrap().method, RIVAL, "a busy CPU");
}

fn a_driver_that_ends_the_program_twice_is_believed() {
    let mut driver = Driver::failing(0.1, Fault::Dies);
    assert!(driver.ends());
    assert!(driver.ends(), "the user may have ended it");
    let choice = driver.run().unwrap();
    assert_eq!(outcome(&choice), Some(&TrialOutcome::Unfinished));
    assert_eq!(choice.method, CLASS);
}

fn a_window_closed_while_the_rival_compiles_strikes_nothing_off() {
    let mut driver = Driver::failing(0.1, Fault::Dies);
    assert!(driver.ends());
    // A crash still counts, and closing the window takes none back.
    driver.fault = Some(Fault::Closes);
    assert!(driver.ends());
    assert_eq!(driver.record()["trying"], serde_json::json!(["Quads", 1]));
    // Once the program ends nothing is begun.
    let opened = driver.opened;
    assert_eq!(driver.run().unwrap().method, CLASS);
    assert_eq!(driver.opened, opened);
}

fn a_window_closed_during_the_sorts_test_strikes_nothing_off() {
    let folder = tempfile::tempdir().unwrap();
    let device = gpu::gpu();
    let trying = || {
        let file = fs::read_dir(folder.path()).unwrap().next()?.unwrap().path();
        // The file that takes its place may just have been moved there.
        let text = fs::read_to_string(file).ok()?;
        let content: serde_json::Value = serde_json::from_str(&text).ok()?;
        content["trying"].is_array().then_some(content)
    };
    std::thread::scope(|scope| {
        let test = scope.spawn(|| choose_in(&device, Some(folder.path())));
        while trying().is_none() {
            assert!(!test.is_finished(), "no test was seen");
            std::thread::yield_now();
        }
        withdraw();
        while !test.is_finished() {
            assert_eq!(trying(), None);
        }
    });
}

fn a_damaged_or_old_record_is_measured_again() {
    let mut driver = Driver::new(0.5);
    let found = driver.run().unwrap();
    let file = record_in(driver.folder.path());
    let text = fs::read_to_string(&file).unwrap();
    for damaged in [
        text[..text.len() / 2].to_string(),
        String::new(),
        text.replace("driver_version\": ", "driver_version\": 1"),
        text.replace("Right", "Wrong"),
    ] {
        fs::write(&file, &damaged).unwrap();
        let opened = driver.opened;
        assert_eq!(driver.run().unwrap(), found);
        assert_eq!(driver.opened, opened + 1, "{damaged}");
    }
}

fn a_device_opened_in_two_ways_has_two_records() {
    let mut driver = Driver::new(0.5);
    let found = driver.run().unwrap();
    let whole = driver.gpu.clone();
    driver.gpu = gpu::open(GpuOptions {
        baseline: true,
        ..gpu::headless()
    });
    let folder = driver.folder.path().to_owned();
    let known = MethodChoice::in_folder(&driver.gpu, Some(&folder));
    assert_eq!(known.tried, [], "baseline takes nothing away here");
    let known = MethodChoice::in_folder(&whole, Some(&folder));
    assert_eq!(known.tried, found.tried);
}

fn small() -> Avatar {
    common::avatar(
        3,
        Sizes {
            gaussians: 3000,
            ..Sizes::default()
        },
    )
}

const SIZE: [u32; 2] = [192, 160];

fn scenes(avatar: &Avatar) -> Vec<QuestionScene> {
    let joints = avatar.skeleton.len();
    let posed = Posed::new(avatar, &Pose::rest(joints, avatar.inputs.expression));
    QuestionScene::around(avatar, &[posed], SIZE)
}

/// The methods of a device besides that of its class.
fn rivals(device: &Gpu) -> Vec<RasterMethod> {
    let class = MethodChoice::in_folder(device, None).class;
    let others = RasterMethod::ALL.into_iter();
    others
        .filter(|method| *method != class && device.probe.lacks_for(*method).is_none())
        .collect()
}

fn every_method_of_this_device_is_right() {
    let device = gpu::gpu();
    let avatar = small();
    let question = Question {
        avatar: &avatar,
        options: RendererOptions::new(SIZE),
        scenes: &scenes(&avatar),
    };
    for rival in rivals(&device) {
        let choice = question.ask_about(&device, rival, None).unwrap();
        let name = choice.method.name();
        println!("{} beside it: {name}, {}", rival.name(), choice.reason());
        let outcome = Tried::outcome_of(&choice.tried, rival);
        let is_right = matches!(outcome, Some(TrialOutcome::Right(ms)) if *ms > 0.0);
        assert!(is_right, "{}: {outcome:?}", rival.name());
    }
}

fn renderers_draw_as_was_measured_and_drop_what_fails() {
    let device = gpu::gpu();
    let class = MethodChoice::in_folder(&device, None).class;
    let Some(&rival) = rivals(&device).first() else {
        not_run("the device draws by one method alone");
    };
    let mut measured = Driver {
        methods: [class, rival],
        ..Driver::new(0.5)
    };
    let device = gpu::open(GpuOptions {
        cache: Some(measured.folder.path().to_owned()),
        ..gpu::headless()
    });
    measured.gpu = device.clone();
    let avatar = small();
    let options = RendererOptions::new(SIZE);
    let fresh = Renderer::new(&device, &avatar, options).unwrap();
    assert_eq!(fresh.options().method, Some(class));
    assert!(!fresh.strike_off("a test"), "the class's method stays");
    measured.run().unwrap();
    let drawn = Renderer::new(&device, &avatar, options).unwrap();
    assert_eq!(drawn.options().method, Some(rival));
    // What the options are at fault for is not the method's.
    let too_few = RendererOptions {
        gaussians: Some(10),
        ..options
    };
    let failed = Renderer::new(&device, &avatar, too_few).map(|_| ());
    assert!(matches!(failed, Err(Error::Unusable(_))), "{failed:?}");
    assert_eq!(MethodChoice::of(&device).method, rival);
    // The device is lost later.
    assert!(drawn.strike_off("a test"));
    let after = Renderer::new(&device, &avatar, options).unwrap();
    assert_eq!(after.options().method, Some(class));
}

fn a_measured_method_that_a_device_lacks_gives_way() {
    // It has no subgroups, which cooperative tiles need: as after a change that no version tells.
    let measured = Driver::new(0.5);
    let device = gpu::open(GpuOptions {
        baseline: true,
        cache: Some(measured.folder.path().to_owned()),
        ..gpu::headless()
    });
    let class = MethodChoice::in_folder(&device, None).class;
    let mut measured = Driver {
        methods: [class, RasterMethod::CooperativeTiles],
        gpu: device.clone(),
        ..measured
    };
    assert!(measured.run().unwrap().is_rival());
    let avatar = small();
    let mut renderer = Renderer::new(&device, &avatar, RendererOptions::new(SIZE)).unwrap();
    assert_eq!(renderer.options().method, Some(class));
    let QuestionScene { posed, camera } = &scenes(&avatar)[0];
    renderer.draw(posed, camera, None).unwrap();
    assert!(renderer.read_image().is_ok());
    assert_eq!(MethodChoice::of(&device).method, class, "not tried again");
}

tests! {
    the_faster_method_is_found_once,
    a_start_takes_no_longer_than_its_budget,
    a_wrong_image_is_never_drawn_however_fast,
    a_method_that_loses_or_hangs_the_device_is_tried_once,
    what_may_pass_refuses_nothing_for_good,
    a_driver_that_ends_the_program_twice_is_believed,
    a_window_closed_while_the_rival_compiles_strikes_nothing_off: own_process,
    a_window_closed_during_the_sorts_test_strikes_nothing_off: own_process,
    a_damaged_or_old_record_is_measured_again,
    a_device_opened_in_two_ways_has_two_records,
    every_method_of_this_device_is_right,
    renderers_draw_as_was_measured_and_drop_what_fails: own_process,
    a_measured_method_that_a_device_lacks_gives_way: own_process,
}
