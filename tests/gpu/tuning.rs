//! Ways to draw, chosen by measuring: drivers that fail in every way while candidates are tried,
//! what is remembered of them, and trials by real frames.

use crate::common::{self, Sizes, gpu};
use effigy::vulkan::{
    Error, Gpu, GpuOptions, Renderer, RendererOptions, Result, cache,
    sort::choice::choose_in,
    trials::{RendererTrials, TrialScene, TuningTask},
    tuning::{
        Axis, Candidate, Choices, FramePair, Outcome, Record, Tournament, TrialImage, Trials,
        Tuning, Workload,
    },
};
use effigy_core::{
    avatar::{Avatar, Pose},
    frame::{ColorFormat, RasterMethod, SortVariant},
    scene::{FrameImage, Posed},
};
use std::{
    fs,
    panic::{AssertUnwindSafe, catch_unwind},
    path::{Path, PathBuf},
    sync::Arc,
};

const SAFEST: Candidate = Candidate {
    method: RasterMethod::Quads,
    depth: false,
    color: ColorFormat::Rgba16F,
    sort: SortVariant::ReduceThenScan,
};
const TESTED: Candidate = Candidate {
    depth: true,
    ..SAFEST
};
const TILES: Candidate = Candidate {
    method: RasterMethod::SharedTiles,
    color: ColorFormat::Rgba8,
    ..SAFEST
};

/// What a driver does with candidates that differ from the safest in one respect.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    /// It ends the program while it compiles.
    Dies,
    /// It loses the device with the first frame.
    Loses,
    /// Its first frame never ends.
    Hangs,
    /// One pixel is lost.
    Miscompiles,
    /// It leaves light where nothing is covered.
    Glows,
    /// An opacity is no number where nothing is covered.
    Garbles,
    /// It refuses the kernel.
    Refuses,
    /// Its images are 54 dB from others: right for a way to rasterize.
    Rounds,
    /// The user closes the window while it compiles, and the program ends before it has.
    Closes,
}

/// Says of some candidates that they are meant.
type Holds = fn(&Candidate) -> bool;

/// How long a driver takes with some candidates, by the time that it takes otherwise.
#[derive(Clone, Copy)]
struct Speed {
    holds: Holds,
    factor: f64,
}

const fn speed(holds: Holds, factor: f64) -> Speed {
    Speed { holds, factor }
}

/// A driver that takes 10 ms for a frame, and more or less with some candidates.
#[derive(Clone)]
struct Driver {
    /// Times of a frame by that of the safest, for candidates that hold.
    speeds: Vec<Speed>,
    /// Which candidates it fails with, and how.
    fault: Option<(Holds, Fault)>,
    /// Where the record is, to be looked at while kernels are compiled.
    folder: PathBuf,
    /// The record of the tournament under way.
    record: Option<Arc<Record>>,
    is_cpu: bool,
    opened: usize,
    ms: f64,
}

impl Driver {
    fn frame_ms(&self, candidate: &Candidate) -> f64 {
        let factors = self.speeds.iter().filter(|speed| (speed.holds)(candidate));
        10.0 * factors.map(|speed| speed.factor).product::<f64>()
    }

    fn fault(&self, candidate: &Candidate) -> Option<Fault> {
        let (holds, fault) = self.fault?;
        holds(candidate).then_some(fault)
    }
}

impl Trials for Driver {
    type Renderer = Candidate;

    fn open(&mut self, candidate: &Candidate) -> Result<Candidate> {
        self.opened += 1;
        match self.fault(candidate) {
            Some(Fault::Dies) => {
                let text = fs::read_to_string(only_file(&self.folder)).unwrap();
                let record: serde_json::Value = serde_json::from_str(&text).unwrap();
                let trying: Candidate =
                    serde_json::from_value(record["trying"]["candidate"].clone()).unwrap();
                assert_eq!(trying, *candidate, "on disk before it is compiled");
                panic!("the driver ends the program");
            }
            Some(Fault::Closes) => {
                self.record.as_ref().unwrap().withdraw();
                panic!("the program ends");
            }
            Some(Fault::Refuses) => Err(Error::Overlay("the kernel is not compiled".into())),
            _ => Ok(*candidate),
        }
    }

    fn image(&mut self, candidate: &mut Candidate) -> Result<TrialImage> {
        // One lost pixel of so many is 57 dB.
        let side = 400;
        let covered = side * (side - 1);
        let body = [[0.5, 0.4, 0.3, 1.0]].repeat(covered);
        let mut image = FrameImage {
            size: [side as u32; 2],
            pixels: [body, vec![[0.0; 4]; side]].concat(),
        };
        let last = image.pixels.len() - 1;
        match self.fault(candidate) {
            Some(Fault::Loses) => return Err(Error::DeviceLost("a test")),
            Some(Fault::Hangs) => {
                return Err(Error::Timeout {
                    what: "a test",
                    seconds: 1,
                });
            }
            Some(Fault::Miscompiles) => image.pixels[7] = [0.0; 4],
            Some(Fault::Glows) => image.pixels[last] = [0.9, 0.0, 0.0, 0.0],
            Some(Fault::Garbles) => image.pixels[last][3] = f32::NAN,
            Some(Fault::Rounds) => image.pixels[..covered].fill([0.502, 0.402, 0.302, 0.998]),
            _ => {}
        }
        let ms = self.frame_ms(candidate);
        self.ms += ms;
        Ok(TrialImage { image, ms })
    }

    fn pair(
        &mut self,
        best: &mut Candidate,
        candidate: &mut Candidate,
        number: usize,
    ) -> Result<FramePair> {
        // Its clock rises, and every third frame is disturbed.
        let clock = 1.0 - 0.05 * number as f64;
        let disturbed = if number % 3 == 1 { 1.4 } else { 1.0 };
        let pair = FramePair {
            best: clock * self.frame_ms(best),
            candidate: clock * disturbed * self.frame_ms(candidate),
        };
        self.ms += pair.best + pair.candidate;
        Ok(pair)
    }

    fn is_cpu(&self) -> bool {
        self.is_cpu
    }
}

/// A folder for a record, and a driver.
struct Bench {
    folder: tempfile::TempDir,
    gpu: Arc<Gpu>,
    driver: Driver,
}

impl Bench {
    fn new(speeds: &[Speed]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let gpu = gpu::gpu();
        let driver = Driver {
            speeds: speeds.to_vec(),
            fault: None,
            folder: folder.path().to_owned(),
            record: None,
            is_cpu: false,
            opened: 0,
            ms: 0.0,
        };
        Self {
            folder,
            gpu,
            driver,
        }
    }

    fn failing(mut self, fault: Fault, holds: Holds) -> Self {
        self.driver.fault = Some((holds, fault));
        self
    }

    fn record(&self) -> Record {
        Record::new(&self.gpu, Some(self.folder.path()))
    }

    fn run_with(&mut self, gaussians: usize, budget_ms: f64) -> Result<Tuning> {
        let record = Arc::new(self.record());
        self.driver.record = Some(record.clone());
        let tournament = Tournament {
            workload: workload(gaussians),
            safest: SAFEST,
            choices: choices(),
            budget_ms,
            record: &record,
        };
        tournament.run(&mut self.driver, &mut |_| {})
    }

    fn run(&mut self) -> Result<Tuning> {
        self.run_with(1000, f64::INFINITY)
    }
}

fn choices() -> Choices {
    Choices {
        rasters: vec![SAFEST, TESTED, TILES],
        fixed_color: None,
        sorts: vec![SortVariant::ReduceThenScan, SortVariant::OneSweep],
    }
}

fn workload(gaussians: usize) -> Workload {
    let sizes = Sizes {
        gaussians,
        ..Sizes::default()
    };
    Workload::new(&common::avatar(1, sizes), &RendererOptions::new([64, 64]))
}

fn only_file(folder: &Path) -> PathBuf {
    let mut files: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_file())
        .collect();
    assert_eq!(files.len(), 1, "{files:?}");
    files.remove(0)
}

fn outcome(tuning: &Tuning, holds: Holds) -> &Outcome {
    let mut tried = tuning.tried.iter();
    &tried
        .find(|tried| holds(&tried.candidate))
        .unwrap_or_else(|| panic!("not tried: {tuning:#?}"))
        .outcome
}

fn is_tested(candidate: &Candidate) -> bool {
    candidate.depth
}

fn is_tiles(candidate: &Candidate) -> bool {
    candidate.method == RasterMethod::SharedTiles
}

fn is_onesweep(candidate: &Candidate) -> bool {
    candidate.sort == SortVariant::OneSweep
}

fn is_small(candidate: &Candidate) -> bool {
    candidate.color == ColorFormat::Rgba8
}

fn the_fastest_of_every_axis_is_found() {
    let mut bench = Bench::new(&[
        speed(is_tested, 0.7),
        speed(is_tiles, 0.8),
        speed(is_onesweep, 0.9),
    ]);
    let tuning = bench.run().unwrap();
    assert_eq!(
        tuning.best,
        Candidate {
            sort: SortVariant::OneSweep,
            ..TESTED
        }
    );
    assert!(tuning.is_done());
    // Quads that are tested, tiles, another format and sort: each once.
    assert_eq!(tuning.tried.len(), 4, "{tuning:#?}");
    assert!(
        tuning.reason().contains("the fastest of 5"),
        "{}",
        tuning.reason()
    );
    let opened = bench.driver.opened;
    assert_eq!(bench.run().unwrap(), tuning, "nothing is tried again");
    assert_eq!(bench.driver.opened, opened);
}

fn what_is_faster_by_less_than_the_noise_is_not_taken() {
    let mut bench = Bench::new(&[speed(is_tested, 0.99), speed(is_tiles, 0.995)]);
    assert_eq!(bench.run().unwrap().best, SAFEST);
}

fn what_is_far_slower_gets_one_pair_of_frames() {
    let mut bench = Bench::new(&[speed(is_tested, 4.0), speed(is_tiles, 1.3)]);
    let tuning = bench.run().unwrap();
    let frames = |holds| match outcome(&tuning, holds) {
        Outcome::Timed(timing) => timing.frames,
        outcome => panic!("{outcome}"),
    };
    assert_eq!(frames(is_tested), 1);
    assert_eq!(frames(is_tiles), 3);
    assert_eq!(tuning.best, SAFEST);
}

fn a_wrong_image_is_never_drawn_however_fast() {
    for fault in [Fault::Miscompiles, Fault::Glows, Fault::Garbles] {
        let mut bench =
            Bench::new(&[speed(is_tiles, 0.1), speed(is_tested, 0.9)]).failing(fault, is_tiles);
        let tuning = bench.run().unwrap();
        assert_eq!(tuning.best, TESTED, "{fault:?}");
        assert!(
            matches!(outcome(&tuning, is_tiles), Outcome::Refused(why) if why.contains("wrong")),
            "{fault:?}: {tuning:#?}"
        );
    }
}

fn images_are_held_against_the_best_so_far() {
    let speeds = &[speed(is_tiles, 0.5), speed(is_onesweep, 0.8)];
    let mut bench = Bench::new(speeds).failing(Fault::Rounds, is_tiles);
    let tuning = bench.run().unwrap();
    assert!(
        is_tiles(&tuning.best) && is_onesweep(&tuning.best),
        "{tuning:#?}"
    );
    // What only a way to rasterize may do.
    let mut bench = Bench::new(speeds).failing(Fault::Rounds, is_onesweep);
    let tuning = bench.run().unwrap();
    assert!(
        matches!(outcome(&tuning, is_onesweep), Outcome::Refused(_)),
        "{tuning:#?}"
    );
}

fn a_kernel_that_is_not_compiled_costs_only_itself() {
    let mut bench = Bench::new(&[speed(is_tested, 0.5), speed(is_small, 0.9)])
        .failing(Fault::Refuses, is_tested);
    let tuning = bench.run().unwrap();
    assert!(matches!(outcome(&tuning, is_tested), Outcome::Refused(_)));
    assert!(is_small(&tuning.best), "the others are tried: {tuning:#?}");
}

fn a_candidate_that_loses_or_hangs_the_device_is_tried_once() {
    for fault in [Fault::Loses, Fault::Hangs] {
        let mut bench =
            Bench::new(&[speed(is_tested, 0.5), speed(is_tiles, 0.6)]).failing(fault, is_tested);
        let error = bench.run().unwrap_err();
        println!("{fault:?}: {error}");
        // The next start.
        let tuning = bench.run().unwrap();
        assert!(
            matches!(outcome(&tuning, is_tested), Outcome::Refused(_)),
            "{fault:?}: {tuning:#?}"
        );
        assert!(is_tiles(&tuning.best), "the others are tried");
        // Another avatar: it is the device that it brought down.
        let other = bench.run_with(100_000, f64::INFINITY).unwrap();
        assert!(matches!(outcome(&other, is_tested), Outcome::Refused(_)));
        assert!(
            bench
                .record()
                .refusal(Axis::Raster, &TESTED)
                .is_some_and(|why| !why.is_empty())
        );
    }
}

fn what_is_refused_is_no_workloads_best() {
    let mut bench = Bench::new(&[speed(is_tested, 0.5)]);
    let first = bench.run().unwrap();
    assert!(is_tested(&first.best));
    assert_eq!(bench.record().tuning(&first.workload), Some(first.clone()));
    let mut bench = bench.failing(Fault::Loses, is_tested);
    assert!(bench.run_with(100_000, f64::INFINITY).is_err());
    assert_eq!(bench.record().tuning(&first.workload), None);
    // One that still holds it, as trials on a thread of their own do, brings it back no more.
    let record = bench.record();
    record.strike_off(&first, "a test");
    let again = bench.run().unwrap();
    assert!(!is_tested(&again.best), "{again:#?}");
}

fn a_busy_cpu_refuses_nothing_for_good() {
    let mut bench = Bench::new(&[speed(is_tiles, 0.6)]).failing(Fault::Hangs, is_tested);
    bench.driver.is_cpu = true;
    assert!(bench.run().is_err());
    let tuning = bench.run().unwrap();
    assert!(matches!(outcome(&tuning, is_tested), Outcome::Untried(_)));
    assert_eq!(bench.record().refusal(Axis::Raster, &TESTED), None);
}

fn a_driver_that_ends_the_program_strikes_the_candidate_off() {
    let mut bench =
        Bench::new(&[speed(is_tested, 0.5), speed(is_tiles, 0.6)]).failing(Fault::Dies, is_tested);
    for start in 0..2 {
        let ended = catch_unwind(AssertUnwindSafe(|| bench.run()));
        assert!(ended.is_err(), "start {start}: the user may have ended it");
    }
    let tuning = bench.run().unwrap();
    assert!(
        matches!(outcome(&tuning, is_tested), Outcome::Refused(why) if why.contains("ended")),
        "{tuning:#?}"
    );
    assert!(is_tiles(&tuning.best));
    let other = bench.run_with(100_000, f64::INFINITY).unwrap();
    assert!(matches!(outcome(&other, is_tested), Outcome::Refused(_)));
}

fn a_window_closed_while_a_candidate_compiles_strikes_nothing_off() {
    let mut bench = Bench::new(&[speed(is_tested, 0.5), speed(is_tiles, 0.6)])
        .failing(Fault::Closes, is_tested);
    for start in 0..5 {
        let ended = catch_unwind(AssertUnwindSafe(|| bench.run()));
        assert!(ended.is_err(), "start {start}");
        assert_eq!(bench.record().refusal(Axis::Raster, &TESTED), None);
    }
    // A crash still counts, and closing the window takes none back.
    bench = bench.failing(Fault::Dies, is_tested);
    assert!(catch_unwind(AssertUnwindSafe(|| bench.run())).is_err());
    bench = bench.failing(Fault::Closes, is_tested);
    assert!(catch_unwind(AssertUnwindSafe(|| bench.run())).is_err());
    bench = bench.failing(Fault::Dies, is_tested);
    assert!(catch_unwind(AssertUnwindSafe(|| bench.run())).is_err());
    let tuning = bench.run().unwrap();
    assert!(matches!(outcome(&tuning, is_tested), Outcome::Refused(_)));
    assert!(is_tiles(&tuning.best), "{tuning:#?}");
}

fn nothing_is_begun_once_the_program_ends() {
    let mut bench = Bench::new(&[speed(is_tested, 0.5)]);
    let record = bench.record();
    record.withdraw();
    let tournament = Tournament {
        workload: workload(1000),
        safest: SAFEST,
        choices: choices(),
        budget_ms: f64::INFINITY,
        record: &record,
    };
    let tuning = tournament.run(&mut bench.driver, &mut |_| {}).unwrap();
    assert!(tuning.tried.is_empty(), "{tuning:#?}");
    assert!(
        is_tested(&bench.run().unwrap().best),
        "the next start tries it"
    );
}

fn a_window_closed_during_the_sorts_test_strikes_nothing_off() {
    let folder = tempfile::tempdir().unwrap();
    let device = gpu::gpu();
    let record = Record::new(&device, Some(folder.path()));
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
        record.withdraw();
        while !test.is_finished() {
            assert_eq!(trying(), None);
        }
    });
}

fn a_best_that_fails_gives_way_to_the_safest() {
    let mut bench = Bench::new(&[speed(is_tested, 0.5)]);
    // Before anything but the raster method was measured.
    let tuning = bench.run_with(1000, 200.0).unwrap();
    assert!(is_tested(&tuning.best) && !tuning.is_done(), "{tuning:#?}");
    let mut bench = bench.failing(Fault::Refuses, is_tested);
    let tuning = bench.run().unwrap();
    assert!(!is_tested(&tuning.best), "{tuning:#?}");
    assert!(tuning.is_done());
    assert!(matches!(outcome(&tuning, is_tested), Outcome::Refused(_)));
}

fn a_start_takes_no_longer_than_its_budget() {
    let speeds = &[
        speed(is_tested, 0.7),
        speed(is_tiles, 0.8),
        speed(is_onesweep, 0.9),
    ];
    let at_once = Bench::new(speeds).run().unwrap();
    let mut bench = Bench::new(speeds);
    let budget = 60.0;
    let mut starts = 0;
    loop {
        starts += 1;
        assert!(starts < 50, "it never ends");
        let before = bench.driver.ms;
        let tuning = bench.run_with(1000, budget).unwrap();
        let spent = bench.driver.ms - before;
        assert!(spent < budget + 40.0, "start {starts}: {spent} ms");
        if tuning.is_done() {
            assert_eq!(tuning.best, at_once.best);
            break;
        }
    }
    assert!(starts > 4, "{starts} starts");
}

fn a_damaged_or_old_record_is_measured_again() {
    let mut bench = Bench::new(&[speed(is_tested, 0.7)]);
    let tuning = bench.run().unwrap();
    let file = only_file(bench.folder.path());
    let text = fs::read_to_string(&file).unwrap();
    let version = env!("CARGO_PKG_VERSION");
    let damaged = [
        text[..text.len() / 2].to_owned(),
        String::new(),
        "{}".into(),
        text.replace("driver_version\": ", "driver_version\": 1"),
        text.replace(&format!("\"program\": \"{version}\""), "\"program\": \"0\""),
        text.replace("\"shaders\": ", "\"shaders\": 1"),
        text.replace("\"device\": \"", "\"device\": \"another "),
    ];
    for damaged in damaged {
        assert_ne!(damaged, text);
        fs::write(&file, &damaged).unwrap();
        assert_eq!(bench.record().tuning(&tuning.workload), None);
        let opened = bench.driver.opened;
        assert_eq!(bench.run().unwrap(), tuning);
        assert!(bench.driver.opened > opened);
    }
}

fn a_device_opened_in_two_ways_has_two_records() {
    let mut bench = Bench::new(&[speed(is_tested, 0.5)]);
    let whole = bench.gpu.clone();
    let found = bench.run().unwrap();
    bench.gpu = gpu::open(GpuOptions {
        baseline: true,
        ..GpuOptions::headless(None)
    });
    let baseline = bench.record();
    assert!(baseline.is_of(&bench.gpu));
    assert!(!baseline.is_of(&whole), "baseline takes nothing away here");
    assert_eq!(baseline.tunings(), []);
    let mut bench = bench.failing(Fault::Refuses, is_tested);
    assert_ne!(bench.run().unwrap().best, found.best);
    bench.gpu = whole;
    assert_eq!(bench.record().tunings(), [found]);
    assert_eq!(bench.record().refusal(Axis::Raster, &TESTED), None);
}

fn a_workload_is_what_decides_speed() {
    let options = RendererOptions::new([1000, 1000]);
    let avatar = |gaussians| {
        common::avatar(
            1,
            Sizes {
                gaussians,
                ..Sizes::default()
            },
        )
    };
    let base = Workload::new(&avatar(4000), &options);
    let like =
        |size, gaussians| Workload::new(&avatar(gaussians), &RendererOptions { size, ..options });
    assert_eq!(base, like([1100, 1000], 3500), "a little more of anything");
    assert_ne!(base, like([2000, 1000], 4000));
    assert_ne!(base, like([1000, 1000], 8000));
    let fixed = RendererOptions {
        method: Some(RasterMethod::SharedTiles),
        ..options
    };
    assert_ne!(base, Workload::new(&avatar(4000), &fixed));
    assert!(Workload::is_open(&fixed));
    assert!(!Workload::is_open(&SAFEST.apply(options)));
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

fn task<'a>(avatar: &'a Avatar, scenes: &'a [TrialScene]) -> TuningTask<'a> {
    TuningTask {
        avatar,
        options: RendererOptions::new(SIZE),
        scenes,
        budget_ms: f64::INFINITY,
    }
}

const SIZE: [u32; 2] = [192, 160];

fn scenes(avatar: &Avatar) -> Vec<TrialScene> {
    let joints = avatar.skeleton.len();
    let posed = Posed::new(avatar, &Pose::rest(joints, avatar.inputs.expression));
    TrialScene::around(avatar, &[posed], SIZE)
}

fn every_candidate_of_this_device_is_right() {
    let device = gpu::gpu();
    let avatar = small();
    let scenes = scenes(&avatar);
    let folder = tempfile::tempdir().unwrap();
    let record = Record::new(&device, Some(folder.path()));
    let mut tried = Vec::new();
    let tuning = task(&avatar, &scenes)
        .run(&device, &record, &mut |candidate| tried.push(*candidate))
        .unwrap();
    for tried in &tuning.tried {
        println!("{}: {}", tried.candidate, tried.outcome);
        // RGBA8 rounds every blended layer.
        let may_be_wrong = tried.candidate.method == RasterMethod::Quads
            && tried.candidate.color == ColorFormat::Rgba8;
        assert!(
            matches!(tried.outcome, Outcome::Timed(_)) || may_be_wrong,
            "{}: {}",
            tried.candidate,
            tried.outcome
        );
    }
    assert_eq!(tried.len(), tuning.tried.len());
    assert!(tuning.is_done());
    assert_eq!(record.tuning(&tuning.workload), Some(tuning));
}

fn a_real_device_that_is_lost_in_a_trial_is_opened_again() {
    // Every device has one that is not the safest: tiles in f16, or quads in bytes.
    let is_losing = |candidate: &Candidate| candidate.color != candidate.method.color();

    /// Loses a real device once it has drawn with that candidate.
    struct Losing<'a>(RendererTrials<'a>);

    impl Trials for Losing<'_> {
        type Renderer = Renderer;

        fn open(&mut self, candidate: &Candidate) -> Result<Renderer> {
            self.0.open(candidate)
        }

        fn image(&mut self, renderer: &mut Renderer) -> Result<TrialImage> {
            self.0.image(renderer)
        }

        fn pair(
            &mut self,
            best: &mut Renderer,
            candidate: &mut Renderer,
            number: usize,
        ) -> Result<FramePair> {
            let pair = self.0.pair(best, candidate, number)?;
            let options = candidate.options();
            if options.color != options.method.map(RasterMethod::color) {
                return Err(Error::DeviceLost("a test"));
            }
            Ok(pair)
        }

        fn is_cpu(&self) -> bool {
            false
        }
    }

    let avatar = small();
    let scenes = scenes(&avatar);
    let task = task(&avatar, &scenes);
    let folder = tempfile::tempdir().unwrap();
    let mut lost = 0;
    for _ in 0..3 {
        let device = Gpu::new(&GpuOptions::headless(None)).unwrap();
        let record = Record::new(&device, Some(folder.path()));
        let mut trials = Losing(RendererTrials::new(&device, task));
        let tournament = task.tournament(&device, &record).unwrap();
        match tournament.run(&mut trials, &mut |_| {}) {
            Ok(tuning) => {
                assert!(!is_losing(&tuning.best));
                assert!(matches!(outcome(&tuning, is_losing), Outcome::Refused(_)));
                let options = tuning.best.apply(task.options);
                let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
                let scene = &scenes[0];
                renderer.draw(&scene.poses[0], &scene.camera, None).unwrap();
                assert!(
                    renderer
                        .read_image()
                        .unwrap()
                        .pixels
                        .iter()
                        .any(|p| p[3] > 0.5)
                );
            }
            Err(error) => {
                lost += 1;
                println!("{error}");
            }
        }
    }
    assert_eq!(lost, 1, "it is tried once");
}

fn renderers_draw_as_was_measured_and_drop_what_fails() {
    let folder = tempfile::tempdir().unwrap();
    cache::set_folder(folder.path().to_owned());
    // Without subgroups, whatever the device has.
    let device = gpu::open(GpuOptions {
        baseline: true,
        ..GpuOptions::headless(None)
    });
    let avatar = small();
    let scenes = scenes(&avatar);
    let task = task(&avatar, &scenes);
    let fresh = Renderer::new(&device, &avatar, task.options).unwrap();
    assert_eq!(fresh.tuning(), None);
    let tuning = task
        .run(&device, &Record::of_device(&device), &mut |_| {})
        .unwrap();
    let tuned = Renderer::new(&device, &avatar, task.options).unwrap();
    assert_eq!(tuned.tuning(), Some(&tuning));
    assert_eq!(tuned.options().method, Some(tuning.best.method));
    assert_eq!(tuned.options().sort, Some(tuning.best.sort));
    // What the options are at fault for is not the best's.
    let too_few = RendererOptions {
        gaussians: Some(10),
        ..task.options
    };
    let failed = Renderer::new(&device, &avatar, too_few).map(|_| ());
    assert!(matches!(failed, Err(Error::Unusable(_))), "{failed:?}");
    let record = Record::of_device(&device);
    assert_eq!(record.tuning(&tuning.workload).as_ref(), Some(&tuning));
    // A best that this device can't draw with, as after a change that no version tells.
    let files = fs::read_dir(folder.path()).unwrap();
    let mut records = files
        .map(|file| file.unwrap().path())
        .filter(|path| path.to_string_lossy().contains("tuning"));
    let file = records.next().unwrap();
    let mut content: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
    content["tunings"][0]["best"]["method"] = "CooperativeTiles".into();
    fs::write(&file, content.to_string()).unwrap();
    let mut renderer = Renderer::new(&device, &avatar, task.options).unwrap();
    assert_eq!(renderer.options().method, fresh.options().method);
    let scene = &scenes[0];
    renderer.draw(&scene.poses[0], &scene.camera, None).unwrap();
    assert!(renderer.read_image().is_ok());
    let record = Record::of_device(&device);
    let after = record.tuning(&tuning.workload).unwrap();
    assert_eq!(after.best, after.safest);
    let cooperative = Candidate {
        method: RasterMethod::CooperativeTiles,
        ..tuning.safest
    };
    assert!(record.refusal(Axis::Raster, &cooperative).is_some());
}

tests! {
    the_fastest_of_every_axis_is_found,
    what_is_faster_by_less_than_the_noise_is_not_taken,
    what_is_far_slower_gets_one_pair_of_frames,
    a_wrong_image_is_never_drawn_however_fast,
    images_are_held_against_the_best_so_far,
    a_kernel_that_is_not_compiled_costs_only_itself,
    a_candidate_that_loses_or_hangs_the_device_is_tried_once,
    what_is_refused_is_no_workloads_best,
    a_busy_cpu_refuses_nothing_for_good,
    a_driver_that_ends_the_program_strikes_the_candidate_off,
    a_window_closed_while_a_candidate_compiles_strikes_nothing_off: own_process,
    a_window_closed_during_the_sorts_test_strikes_nothing_off: own_process,
    nothing_is_begun_once_the_program_ends: own_process,
    a_best_that_fails_gives_way_to_the_safest,
    a_start_takes_no_longer_than_its_budget,
    a_damaged_or_old_record_is_measured_again,
    a_device_opened_in_two_ways_has_two_records,
    a_workload_is_what_decides_speed: no_device,
    every_candidate_of_this_device_is_right,
    a_real_device_that_is_lost_in_a_trial_is_opened_again,
    renderers_draw_as_was_measured_and_drop_what_fails: own_process,
}
