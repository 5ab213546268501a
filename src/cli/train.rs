//! `effigy train`: an avatar from pictures, masks, cameras and poses.

#[cfg(feature = "window")]
use crate::live;
use crate::{
    assets,
    files::print_assumptions,
    interrupt::Interrupts,
    options::{self, DeviceArgs},
    output::{AVATAR, Output, OutputFolder},
    progress,
};
use anyhow::Context;
use effigy_capture::{Capture, CaptureOpenOptions, tally};
use effigy_perceptual::Network;
use effigy_render::vulkan::Gpu;
use effigy_train::{
    log::TrainingProgress,
    preflight,
    recipe::{PerceptualKind, Preset, Recipe},
    session::{
        POSES, RECIPE, SessionOptions, TrainingOutcome, TrainingPlan, TrainingSession,
        TrainingStatus,
    },
};
use std::{
    fmt,
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    time::Duration,
};

/// From one state of the avatar in the window to the next: each stops the training for as long as
/// its numbers take to copy.
#[cfg(feature = "window")]
const VIEW_EVERY: Duration = Duration::from_secs(4);

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Capture: a folder in the layout of THuman4 or AvatarReX (docs/captures.md)
    #[arg(required_unless_present = "show_recipe")]
    capture: Option<PathBuf>,
    /// Avatar file to write
    #[arg(
        short,
        long,
        value_name = "FILE",
        required_unless_present = "show_recipe",
        value_parser = AVATAR.parser()
    )]
    out: Option<Output>,
    /// Recipe: a TOML file with every weight, rate and count
    #[arg(long, value_name = "FILE", conflicts_with = "recipe")]
    config: Option<PathBuf>,
    /// Recipe that comes with the program: paper or quick
    #[arg(long, value_name = "NAME", default_value = "quick", value_parser = preset)]
    recipe: Preset,
    /// Print such a recipe, to start one from, and end
    #[arg(long, value_name = "NAME", value_parser = preset)]
    show_recipe: Option<Preset>,
    /// Change a key of the recipe, such as sizes.gaussians=50000; repeat for several
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// End after so many minutes in all, with the best avatar that this time allows
    #[arg(long, value_name = "N", value_parser = minutes)]
    minutes: Option<f64>,
    /// Go on with the training in the folder; begin where there is none
    #[arg(long)]
    resume: bool,
    /// Folder of the training: checkpoints, log, recipe [default: OUT with the ending .training]
    #[arg(long, value_name = "DIR")]
    folder: Option<OutputFolder>,
    /// Body model: an .npz with the arrays of SMPL-X [default: template.npz in the capture]
    #[arg(long, value_name = "FILE")]
    template: Option<PathBuf>,
    /// Decode every picture first, and leave out those that can't be used
    #[arg(long)]
    check_pictures: bool,
    /// Show the avatar in a window while it is learned, in the capture's poses; Space plays them.
    /// Closing it does not end the training
    #[arg(long)]
    view: bool,
    /// With --view, clip that moves the avatar besides: a .motion file, or motion of any body; N
    /// goes to the next. Repeat for several
    #[arg(long, value_name = "FILE", requires = "view")]
    motion: Vec<PathBuf>,
    /// Time between checkpoints, seconds, 0 to 1000000; an interrupted run continues from the last
    #[arg(long, value_name = "SECONDS", default_value = "300", value_parser = checkpoint)]
    checkpoint: f64,
    /// Folder that tools/fetch_perceptual.sh filled
    #[arg(long, value_name = "DIR", env = "EFFIGY_ASSETS", default_value_os_t = assets::folder())]
    weights: PathBuf,
    #[command(flatten)]
    device: DeviceArgs,
}

fn preset(text: &str) -> Result<Preset, String> {
    let found = Preset::ALL.into_iter().find(|preset| preset.name() == text);
    found.ok_or_else(|| "expected paper or quick".into())
}

fn minutes(text: &str) -> Result<f64, String> {
    options::number(text, 0.01, 100_000.0, "number of minutes")
}

/// A training that ended without an avatar, for a reason that scripts tell by the exit code.
#[derive(Debug)]
pub enum Ended {
    /// Asked to; goes on with --resume.
    Stopped {
        /// Steps so far; 0 where they are not known yet.
        steps: u64,
    },
    /// The recipe is none: trying again does not help.
    Recipe(String),
}

impl Ended {
    /// 75 asks to be tried again (EX_TEMPFAIL), 2 not to.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Stopped { .. } => 75,
            Self::Recipe(_) => 2,
        }
    }
}

impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stopped { steps: 0 } => {
                f.write_str("stopped before it took a step; the same command with --resume goes on")
            }
            Self::Stopped { steps } => write!(
                f,
                "stopped after {steps} steps; the same command with --resume goes on"
            ),
            Self::Recipe(fault) => write!(f, "error: {fault}"),
        }
    }
}

impl std::error::Error for Ended {}

/// A time between checkpoints, seconds.
fn checkpoint(text: &str) -> Result<f64, String> {
    options::number(text, 0.0, 1e6, "number of seconds")
}

pub fn run(args: Args) -> anyhow::Result<()> {
    if let Some(preset) = args.show_recipe {
        print!("{}", preset.text());
        return Ok(());
    }
    let (Some(folder), Some(out)) = (&args.capture, &args.out) else {
        anyhow::bail!("a capture and --out are needed");
    };
    let work = match &args.folder {
        Some(folder) => folder.to_path_buf(),
        None => out.with_extension("training"),
    };
    let recipe = with_known_weights(recipe(&args)?, &args, &work);
    let stop = Interrupts::listen()?;
    let standing = Arc::new(TrainingStatus::default());
    let left = standing.clone();
    // Whoever starts trainings is told to try again, as when one has begun.
    let code = Ended::Stopped { steps: 0 }.exit_code();
    stop.leave_unless(&standing.is_unsaved, code, move || {
        left.leave();
        let steps = left.steps.load(Ordering::SeqCst);
        Ended::Stopped { steps }.to_string()
    });
    let capture = read_capture(folder, &args)?;
    let gpu = Gpu::new(&args.device.gpu())?;
    let name = out.file_stem().unwrap_or_default().to_string_lossy();
    let options = SessionOptions {
        folder: work.clone(),
        resume: args.resume,
        minutes: args.minutes,
        check: preflight::is_due(&recipe, args.minutes),
        checkpoint_every: Duration::from_secs_f64(args.checkpoint),
        log_every: 50,
        perceptual_weights: args.weights.clone(),
        standing,
        name: name.into_owned(),
        credit: String::new(),
    };
    let announce = |plan: &TrainingPlan| {
        println!(
            "{}: {} pictures, views of {} × {} px; {} Gaussians in {} parts; {:.0} MB on {}",
            folder.display(),
            plan.pictures,
            plan.view_size[0],
            plan.view_size[1],
            recipe.sizes.gaussians,
            recipe.sizes.parts,
            plan.memory_bytes as f64 / 1e6,
            gpu.probe.name
        );
        if plan.steps > 0 {
            println!("going on after {} steps", plan.steps);
        }
        if plan.check {
            println!("checking first that every input moves a pixel");
        }
    };
    let mut session = TrainingSession::new(&gpu, &capture, &recipe, options, announce)?;
    let outcome = learn(&mut session, stop.flag(), &capture, &args)?;
    match outcome {
        TrainingOutcome::Stopped => Err(Ended::Stopped {
            steps: session.steps(),
        }
        .into()),
        TrainingOutcome::Done(avatar) => {
            avatar.write(out)?;
            let megabytes = out.metadata().map_or(0.0, |file| file.len() as f64 / 1e6);
            println!(
                "{}: {} Gaussians, {} rows; {megabytes:.1} MB after {} steps; log and checkpoints in {}",
                out.display(),
                avatar.gaussians.len(),
                avatar.rotation_rows.gaussian.len()
                    + avatar.scale_rows.gaussian.len()
                    + avatar.color_rows.gaussian.len(),
                session.steps(),
                work.display()
            );
            if let Some([mean, most]) = session.turned_joints() {
                println!(
                    "poses refined: joints are turned by {:.2}° on average, {:.1}° at most; {}",
                    mean.to_degrees(),
                    most.to_degrees(),
                    work.join(POSES).display()
                );
            }
            if let Some([mean, most]) = session.moved_bones() {
                println!(
                    "bones refined: joints moved in their parents by {:.1} mm on average, {:.1} mm at \
                     most",
                    1e3 * mean,
                    1e3 * most
                );
            }
            Ok(())
        }
    }
}

/// Trains, with a window beside where one is asked for and can be opened.
fn learn(
    session: &mut TrainingSession,
    stop: &AtomicBool,
    capture: &Capture,
    args: &Args,
) -> anyhow::Result<TrainingOutcome> {
    let window = window(session, capture, args)?;
    let bar = progress::share();
    let report = |now: &TrainingProgress| {
        bar.set_position((1000.0 * now.share) as u64);
        bar.set_message(message(now));
    };
    let outcome = match window {
        #[cfg(feature = "window")]
        Some(window) => window.beside(&bar, |live| {
            let mut shown = std::time::Instant::now();
            session.run(stop, |session, now| {
                report(now);
                if live.is_ready() && shown.elapsed() >= VIEW_EVERY {
                    match session.avatar() {
                        Ok(avatar) => live.show(avatar),
                        // The next step says the same, and ends the training.
                        Err(error) => tracing::debug!("not shown: {error}"),
                    }
                    shown = std::time::Instant::now();
                }
            })
        }),
        _ => session.run(stop, |_, now| report(now)),
    };
    bar.finish_and_clear();
    Ok(outcome?)
}

/// The window that is asked for. Without a display the training has none, and says so: it may have
/// been started to run for a night.
#[cfg(feature = "window")]
fn window(
    session: &TrainingSession,
    capture: &Capture,
    args: &Args,
) -> anyhow::Result<Option<live::Window>> {
    if !args.view {
        return Ok(None);
    }
    let avatar = session.avatar()?;
    let clips = live::clips(&args.motion, capture, &avatar)?;
    Ok(match effigy_app::Display::open() {
        Ok(display) => Some(live::Window {
            display,
            avatar,
            clips,
            gpu: args.device.gpu(),
        }),
        Err(error) => {
            eprintln!("{error}: training without it");
            None
        }
    })
}

#[cfg(not(feature = "window"))]
fn window(_: &TrainingSession, _: &Capture, args: &Args) -> anyhow::Result<Option<()>> {
    if args.view {
        eprintln!("this program was built without its window: training without it");
    }
    Ok(None)
}

/// A line of progress: what is left, and the last losses.
fn message(now: &TrainingProgress) -> String {
    let left = if now.share > 0.0 {
        now.seconds * (1.0 / now.share - 1.0)
    } else {
        0.0
    };
    let perceptual = now
        .perceptual
        .map_or(String::new(), |v| format!(", perceptual {v:.4}"));
    format!(
        "step {}, {:.1} dB{perceptual}, {:.0} min left",
        now.steps,
        now.psnr_db,
        left / 60.0
    )
}

/// The recipe that the arguments name.
fn recipe(args: &Args) -> anyhow::Result<Recipe> {
    let text = match &args.config {
        Some(file) => std::fs::read_to_string(file)
            .with_context(|| format!("{} can't be read", file.display()))?,
        None => args.recipe.text().into(),
    };
    let source = match &args.config {
        Some(file) => file.display().to_string(),
        None => format!("recipe {}", args.recipe.name()),
    };
    changed(&text, &args.set).map_err(|fault| Ended::Recipe(format!("{source}: {fault}")).into())
}

/// The recipe with D-SSIM in place of ST-LPIPS where nobody asked for that and its weights are not
/// there; says which loss it is, and why. A training that goes on keeps what it began with, whatever
/// is there by now.
fn with_known_weights(mut recipe: Recipe, args: &Args, work: &Path) -> Recipe {
    let is_asked_for = args.config.is_some()
        || args
            .set
            .iter()
            .any(|change| change.trim_start().starts_with("perceptual.kind"));
    let begun = std::fs::read_to_string(work.join(RECIPE)).ok();
    let begun = begun.and_then(|text| Recipe::parse(&text).ok());
    let begun = begun.filter(|_| args.resume && !is_asked_for);
    if let Some(begun) = &begun {
        recipe.perceptual.kind = begun.perceptual.kind;
    }
    let kind = &mut recipe.perceptual.kind;
    let network = match kind {
        PerceptualKind::StLpipsAlex => Network::Alex,
        PerceptualKind::StLpipsVgg => Network::Vgg,
        // LPIPS is in no preset: who asks for it brings its weights.
        PerceptualKind::LpipsAlex | PerceptualKind::LpipsVgg => return recipe,
        PerceptualKind::Dssim | PerceptualKind::None => return recipe,
    };
    let folder = args.weights.display();
    match network.missing(&args.weights) {
        Some(file) if !is_asked_for && begun.is_none() => {
            eprintln!(
                "without ST-LPIPS, as {folder} has no {}, which tools/fetch_perceptual.sh gets: \
                 D-SSIM stands in for it",
                file.name
            );
            *kind = PerceptualKind::Dssim;
        }
        Some(_) => {}
        None => println!("perceptual loss: ST-LPIPS, whose weights are in {folder}"),
    }
    recipe
}

/// A recipe's text with some keys changed, read.
fn changed(text: &str, changes: &[String]) -> Result<Recipe, String> {
    if changes.is_empty() {
        return Recipe::parse(text);
    }
    let mut all: toml::Table = text.parse().map_err(|error| format!("{error}"))?;
    for change in changes {
        let expected = || format!("--set {change}: expected KEY=VALUE with a key of the recipe");
        let (key, value) = change.split_once('=').ok_or_else(expected)?;
        let value: toml::Table = format!("value = {value}")
            .parse()
            .or_else(|_| format!("value = {value:?}").parse())
            .map_err(|_: toml::de::Error| expected())?;
        let mut path: Vec<&str> = key.trim().split('.').collect();
        let last = path.pop().ok_or_else(expected)?;
        let mut table = &mut all;
        for name in path {
            table = table
                .get_mut(name)
                .and_then(toml::Value::as_table_mut)
                .ok_or_else(expected)?;
        }
        let place = table.get_mut(last).ok_or_else(expected)?;
        *place = value["value"].clone();
    }
    let text = toml::to_string(&all).map_err(|error| error.to_string())?;
    Recipe::parse(&text)
}

/// Opens the capture, and says what is left out.
fn read_capture(folder: &Path, args: &Args) -> anyhow::Result<Arc<Capture>> {
    let options = CaptureOpenOptions {
        template: args.template.clone(),
    };
    let mut capture = Capture::read_with(folder, &options)?;
    print_assumptions(folder, &capture.assumptions);
    if args.check_pictures {
        let bar = progress::items(capture.pictures() as u64, "pictures");
        let found = capture.check(&|done, _| bar.set_position(done as u64));
        bar.finish_and_clear();
        capture = capture.without(found)?;
    } else if !capture.masks.faults.is_empty() {
        let masks = &capture.masks;
        anyhow::ensure!(
            !masks.is_useless(),
            "{}: masks: {masks}; --check-pictures looks at all, and leaves such pictures out",
            folder.display()
        );
        eprintln!("masks: {masks}; --check-pictures looks at all, and leaves such pictures out");
    }
    for (reason, count) in tally(&capture.left_out) {
        eprintln!("left out: {count} × {reason}");
    }
    for entry in &capture.left_out {
        tracing::info!("left out: {entry}");
    }
    Ok(Arc::new(capture))
}
