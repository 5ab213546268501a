//! `effigy-lab bench-train`: steps of a training a second, without the perceptual loss, with its
//! kernels and with the CPU's networks.

use crate::training::{SCHEMA, TrainingReport, TrainingRow};
use anyhow::ensure;
use effigy_cli::{
    options::{self, DeviceArgs},
    output::{JSON, Output},
};
use effigy_core::{
    avatar::{Avatar, Clip},
    random::hash,
    scene::{AvatarBounds, Camera, Orbit, Posed},
};
use effigy_measure::report::{DeviceReport, Program};
use effigy_perceptual::{Network, Perceptual};
use effigy_render::vulkan::Gpu;
use effigy_train::{
    gpu::{StepOptions, Trainer, TrainerState, memory_bytes},
    parameters::{ParameterLayout, Parameters},
    perceptual::PerceptualLoss,
    recipe::{PerceptualOptions, Preset, Recipe},
    topology::{CorrectiveRows, Topology},
    view::{TrainingView, ViewPicture},
};
use glam::DVec3;
use std::{
    path::PathBuf,
    sync::{Arc, atomic::AtomicBool},
    time::{Duration, Instant},
};

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Avatar that learns, an .avatar file [default: the built-in demo]
    avatar: Option<PathBuf>,
    #[command(flatten)]
    device: DeviceArgs,
    /// Width and height of each view, pixels
    #[arg(long, value_name = "WxH", value_parser = options::size, default_value = "1024x1024")]
    size: [u32; 2],
    /// Views of a step
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = options::count(1, 64))]
    views: usize,
    /// Side of the part of a view that the perceptual loss sees, pixels
    #[arg(long, value_name = "PX", default_value_t = 512, value_parser = clap::value_parser!(u32).range(32..=1024))]
    window: u32,
    /// Seconds that each way is measured, after a step to warm up
    #[arg(long, value_name = "S", default_value_t = 15, value_parser = options::count(1, 600))]
    seconds: usize,
    /// Also write the result as JSON
    #[arg(long, value_name = "FILE", value_parser = JSON.parser())]
    json: Option<Output>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let gpu = Gpu::new(&args.device.gpu())?;
    println!("device   {} ({})", gpu.probe.name, gpu.probe.driver);
    let avatar = match &args.avatar {
        Some(file) => Avatar::read(file)?,
        None => effigy_demo::avatar()?,
    };
    let recipe = Preset::Paper.recipe();
    let bench = TrainingBench::new(&gpu, &args, &avatar, &recipe);
    let mut report = TrainingReport {
        schema: SCHEMA.to_owned(),
        program: Program::current(std::env::args().collect()),
        device: DeviceReport::from_vulkan(&gpu),
        gaussians: avatar.gaussians.len(),
        size: args.size,
        views: args.views,
        window: args.window,
        memory_bytes: memory_bytes(&bench.topology, &bench.rows, args.size, args.views)
            + bench.loss.memory(args.size, args.views),
        rows: Vec::new(),
    };
    println!(
        "views    {} of {}x{}, {} Gaussians, {:.0} MB\n",
        args.views,
        args.size[0],
        args.size[1],
        report.gaussians,
        report.memory_bytes as f64 / 1e6
    );
    println!(
        "{:>16} {:>8} {:>10} {:>9}",
        "loss", "steps", "ms a step", "steps/s"
    );
    for way in [Way::Without, Way::Kernels, Way::Cpu] {
        let row = bench.measure(way)?;
        println!(
            "{:>16} {:>8} {:>10.1} {:>9.2}",
            row.loss, row.steps, row.ms, row.steps_a_second
        );
        report.rows.push(row);
        if let Some(out) = &args.json {
            out.keep_json(&report)?;
        }
    }
    let said: Vec<String> = report
        .rows
        .iter()
        .map(|row| format!("{:.1} ({})", row.steps_a_second, row.loss))
        .collect();
    println!("note: steps a second: {}", said.join(", "));
    if let Some(out) = &args.json {
        out.write_json(&report)?;
        println!("wrote {}", out.display());
    }
    Ok(())
}

/// What works out the perceptual loss.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    Without,
    Kernels,
    Cpu,
}

impl Way {
    fn name(self) -> &'static str {
        match self {
            Self::Without => "none",
            Self::Kernels => "kernels",
            Self::Cpu => "CPU",
        }
    }
}

/// What every way is measured with.
struct TrainingBench<'a> {
    gpu: &'a Arc<Gpu>,
    args: &'a Args,
    topology: Topology,
    rows: CorrectiveRows,
    start: TrainerState,
    views: Vec<TrainingView>,
    options: StepOptions,
    loss: PerceptualLoss,
}

impl<'a> TrainingBench<'a> {
    fn new(gpu: &'a Arc<Gpu>, args: &'a Args, avatar: &Avatar, recipe: &Recipe) -> Self {
        let topology = Topology::new(avatar);
        let rows = CorrectiveRows::all(avatar.gaussians.len());
        let layout = ParameterLayout::new(&topology, &rows);
        let mut parameters = Parameters::of(avatar, &layout);
        // The avatar's own rows are of other Gaussians where all have one.
        parameters.bases.fill(0.0);
        let options = PerceptualOptions {
            window: args.window,
            ..recipe.perceptual.clone()
        };
        // Any weights take as long.
        let network = Perceptual::random(Network::Alex, 1);
        Self {
            start: TrainerState::new(&layout, parameters),
            topology,
            rows,
            views: views(avatar, args),
            options: StepOptions {
                weights: recipe.loss,
                correctives: true,
                joints: false,
                rates: recipe.rates.at(0.5),
                adam: recipe.rates.adam(),
            },
            loss: PerceptualLoss::with_network(Some(network), &options, recipe.seed),
            gpu,
            args,
        }
    }

    /// Takes steps one way for as long as was asked for, two at least.
    fn measure(&self, way: Way) -> anyhow::Result<TrainingRow> {
        let Args { size, views, .. } = *self.args;
        let mut trainer = Trainer::new(
            self.gpu,
            &self.topology,
            &self.rows,
            &self.start,
            size,
            views,
        )?;
        if way == Way::Kernels {
            self.loss.hand_over(&mut trainer, size)?;
        }
        let goes_on = AtomicBool::new(false);
        let mut step = |place: u64| {
            if way == Way::Without {
                return trainer.step(&self.views, &self.options).map(Some);
            }
            let views = &self.views;
            let found = self
                .loss
                .step(&mut trainer, views, &self.options, place, &goes_on);
            found.map(|found| found.map(|found| found.losses))
        };
        // Drivers compile kernels in the first step.
        step(0)?;
        let limit = Duration::from_secs(self.args.seconds as u64);
        let begun = Instant::now();
        let mut times = Vec::new();
        let mut pairs = 0;
        while times.len() < 2 || begun.elapsed() < limit {
            let start = Instant::now();
            let found = step(times.len() as u64 * views as u64)?;
            times.push(start.elapsed().as_secs_f64());
            let Some(found) = found else { break };
            ensure!(found.l1.is_finite(), "the loss is {}", found.l1);
            pairs = found.pairs;
        }
        let steps_a_second = times.len() as f64 / begun.elapsed().as_secs_f64();
        times.sort_by(f64::total_cmp);
        let on_device = self.loss.suits(self.gpu, size, views);
        Ok(TrainingRow {
            loss: way.name().to_owned(),
            is_chosen: way == Way::Without || on_device == (way == Way::Kernels),
            steps: times.len(),
            ms: 1e3 * times[times.len() / 2],
            steps_a_second,
            pairs,
        })
    }
}

/// Views from around the avatar as it stands, whose pictures are noise: each pixel has a derivative.
fn views(avatar: &Avatar, args: &Args) -> Vec<TrainingView> {
    let pose = Clip::still(&avatar.skeleton).frame(0);
    let posed = Posed::new(avatar, &pose);
    let bounds = AvatarBounds::new(avatar).bounds(&posed.joints);
    let pixels = u64::from(args.size[0]) * u64::from(args.size[1]);
    let noise = |at: u64, shows: u8| {
        let [r, g, b, ..] = hash(at).to_le_bytes();
        [r, g, b, shows]
    };
    let view = |number: usize| {
        let orbit = Orbit {
            yaw: number as f64 * std::f64::consts::TAU / args.views as f64,
            pitch: 0.1,
            fov: 0.6,
        };
        let first = number as u64 * pixels;
        TrainingView {
            joints: posed.joints.clone(),
            input: posed.input.clone(),
            camera: Camera::around(bounds, orbit, args.size),
            gain: DVec3::ONE,
            whole: pixels,
            picture: Arc::new(ViewPicture {
                size: args.size,
                pixels: (0..pixels).map(|at| noise(first + at, 255)).collect(),
                behind: (0..pixels).map(|at| noise(!(first + at), 255)).collect(),
            }),
        }
    };
    (0..args.views).map(view).collect()
}
