//! The one question that is put to a GPU: whether it draws faster with the method of its class or
//! with its rival, quads or tiles. Frames of an avatar are drawn with both in turn; the answer is
//! remembered, and [`MethodChoice`] draws by it.

use super::{
    device::{
        error::{Error, Result},
        gpu::Gpu,
        options::GpuOptions,
        trial::{Record, TrialOutcome, Tried},
    },
    raster::choice::{self, MethodChoice, rival},
    renderer::Renderer,
    sort,
};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    frame::{RasterMethod, RendererOptions},
    scene::{AvatarBounds, Camera, FrameImage, Orbit, Posed},
};
use std::{f64::consts::TAU, path::Path, sync::Arc, time::Instant};

/// Frames of each method after which the answer is known.
const PAIRS: usize = 5;
/// Time of frames after which it is too, ms.
const BUDGET_MS: f64 = 300.0;
/// The least PSNR of the rival's image against that of the class's method, dB over covered pixels:
/// the methods end at saturated pixels, each by its own rule, and have what the default promises
/// against nothing skipped.
const RIGHT_DB: f64 = 50.0;
/// The most by which a channel may be off: the methods differ by up to 0.26 in single pixels, where
/// Gaussians of nearly one depth change places, and a lost or garbled block differs by more.
const RIGHT_MOST: f64 = 0.5;

/// Field of view of the frames around an avatar, radians.
const FOV: f64 = 0.6;
/// Sides that an avatar is seen from.
const SIDES: usize = 7;

/// What one frame shows.
#[derive(Clone, Debug)]
pub struct QuestionScene {
    /// The avatar's pose.
    pub posed: Posed,
    /// The view, for images of the renderer's size.
    pub camera: Camera,
}

impl QuestionScene {
    /// Moments of a clip: see [`Self::around`].
    pub fn of_clip(avatar: &Avatar, player: &Player, size: [u32; 2]) -> Vec<Self> {
        let duration = player.clip().duration();
        let poses: Vec<Posed> = (0..SIDES)
            .map(|side| {
                let seconds = duration * side as f64 / SIDES as f64;
                Posed::new(avatar, &player.pose(seconds))
            })
            .collect();
        Self::around(avatar, &poses, size)
    }

    /// Poses of an avatar in turn, the whole of it seen from another side in each frame: even of an
    /// avatar that has one pose no two frames are the same. `size`: of the image, px.
    pub fn around(avatar: &Avatar, poses: &[Posed], size: [u32; 2]) -> Vec<Self> {
        let bounds = AvatarBounds::new(avatar);
        let poses = poses.iter().cycle();
        (0..SIDES)
            .zip(poses)
            .map(|(side, posed)| {
                let framing = bounds.framing(&posed.joints);
                let yaw = TAU * side as f64 / SIDES as f64;
                Self {
                    posed: posed.clone(),
                    camera: Camera::around(
                        framing,
                        Orbit {
                            yaw,
                            pitch: 0.1,
                            fov: FOV,
                        },
                        size,
                    ),
                }
            })
            .collect()
    }
}

/// What both methods draw.
#[derive(Clone, Copy)]
pub struct Question<'a> {
    /// The avatar.
    pub avatar: &'a Avatar,
    /// How to draw it, besides the method.
    pub options: RendererOptions,
    /// The frames, at least three that differ.
    pub scenes: &'a [QuestionScene],
}

impl Question<'_> {
    /// Whether there is something to find out on a device: nobody has measured yet, and the options
    /// leave the method open.
    pub fn is_open(gpu: &Gpu, options: &RendererOptions) -> bool {
        let rival = rival(&gpu.probe).filter(|_| options.method.is_none());
        rival.is_some_and(|rival| Tried::outcome_of(&MethodChoice::of(gpu).tried, rival).is_none())
    }

    /// Measures, unless somebody has. Tests the sorts first, if nobody did.
    ///
    /// # Errors
    /// When nothing can be drawn, or the rival brings the device down, which later starts do not
    /// repeat.
    pub fn ask(&self, gpu: &Arc<Gpu>) -> Result<MethodChoice> {
        sort::choice::choose(gpu)?;
        match rival(&gpu.probe) {
            Some(rival) => self.ask_about(gpu, rival, gpu.cache_folder()),
            None => Ok(MethodChoice::of(gpu)),
        }
    }

    /// [`Self::ask`] about any method that the device can draw with, with the record in `folder`.
    ///
    /// # Errors
    /// Those of [`Self::ask`].
    pub fn ask_about(
        &self,
        gpu: &Arc<Gpu>,
        rival: RasterMethod,
        folder: Option<&Path>,
    ) -> Result<MethodChoice> {
        let mut race = RendererRace {
            gpu,
            question: *self,
            renderers: None,
        };
        MethodTrial::new(gpu, rival, folder).run(&mut race)
    }
}

/// A device beside the one that a window is drawn to: the same one, opened again, so that a driver
/// that hangs or is lost in a trial takes nothing from the window.
pub struct Aside {
    options: GpuOptions,
    window: Record<RasterMethod>,
}

impl Aside {
    /// `options`: how the window's device was opened.
    pub fn of(window: &Gpu, options: &GpuOptions) -> Self {
        Self {
            options: GpuOptions {
                surface_extensions: Vec::new(),
                device: Some(window.probe.name.clone()),
                ..options.clone()
            },
            window: choice::record(window, None),
        }
    }

    /// Opens it.
    ///
    /// # Errors
    /// When it can't be opened or is another than the window's.
    pub fn open(&self) -> Result<Arc<Gpu>> {
        let gpu = Gpu::new(&self.options)?;
        if !self.window.is_of(&gpu) {
            return Err(Error::NoSuchDevice {
                wanted: self.options.device.clone().unwrap_or_default(),
                found: format!("another one, or another driver: `{}`", gpu.probe.name),
            });
        }
        Ok(gpu)
    }
}

/// Draws the same frames with both methods. Tests put drivers in its place that fail.
pub trait Race {
    /// The first frame by the class's method, then by the rival, for which it compiles all that
    /// they need.
    fn images(&mut self, methods: [RasterMethod; 2]) -> Result<[FrameImage; 2]>;

    /// The times of another frame, ms, one after the other without a pause, so that clocks are the
    /// same. `number`: of the pair.
    fn pair(&mut self, number: usize) -> Result<[f64; 2]>;
}

/// A trial of two methods, in which their frames are timed in turn.
pub struct MethodTrial {
    /// That of the device's class.
    pub class: RasterMethod,
    /// The other.
    pub rival: RasterMethod,
    /// Whether a frame that takes too long may be a busy machine's.
    pub is_cpu: bool,
    /// Where the answer is kept.
    record: Record<RasterMethod>,
}

impl MethodTrial {
    /// Of the method of a device's class and its rival, with the record in `folder`.
    pub fn new(gpu: &Gpu, rival: RasterMethod, folder: Option<&Path>) -> Self {
        Self {
            class: choice::class_method(&gpu.probe),
            rival,
            is_cpu: gpu.probe.is_cpu(),
            record: choice::record(gpu, folder),
        }
    }

    /// Measures, unless the record has an answer.
    ///
    /// # Errors
    /// Those of [`Question::ask`].
    pub fn run(&self, race: &mut impl Race) -> Result<MethodChoice> {
        let tried = self.record.read();
        let is_known = Tried::outcome_of(&tried, self.rival).is_some();
        // Before anything is compiled: a driver may end the program there.
        if is_known || !self.record.begin(&tried, self.rival) {
            return Ok(MethodChoice::new(self.class, tried));
        }
        let raced = self.race(race);
        let tried = match &raced {
            Ok(tried) => tried.clone(),
            Err(error) if error.may_pass(self.is_cpu) => Vec::new(),
            Err(error) => vec![self.refused(error.to_string())],
        };
        self.record.write(&tried);
        match raced {
            Err(error) if !error.leaves_the_device() => Err(error),
            _ => Ok(MethodChoice::new(self.class, tried)),
        }
    }

    fn refused(&self, why: String) -> Tried<RasterMethod> {
        Tried {
            variant: self.rival,
            outcome: TrialOutcome::Refused(why),
        }
    }

    fn race(&self, race: &mut impl Race) -> Result<Vec<Tried<RasterMethod>>> {
        let methods = [self.class, self.rival];
        let [own, rivals] = race.images(methods)?;
        if let Some(fault) = difference(&own, &rivals) {
            return Ok(vec![self.refused(fault)]);
        }
        let mut pairs = Vec::new();
        let mut spent = 0.0;
        while pairs.len() < PAIRS && (pairs.is_empty() || spent < BUDGET_MS) {
            let pair = race.pair(pairs.len())?;
            spent += pair.iter().sum::<f64>();
            pairs.push(pair);
        }
        let timed = [0, 1].map(|of| {
            let mut ms: Vec<f64> = pairs.iter().map(|pair| pair[of]).collect();
            ms.sort_by(f64::total_cmp);
            Tried {
                variant: methods[of],
                outcome: TrialOutcome::Right(ms[ms.len() / 2]),
            }
        });
        Ok(timed.into())
    }
}

/// What is wrong with an image, if anything: it must show what the other shows.
fn difference(own: &FrameImage, other: &FrameImage) -> Option<String> {
    if own.size != other.size {
        return Some("its image has another size".into());
    }
    let mut squares = 0.0;
    let mut most = 0.0_f64;
    let mut covered = 0_usize;
    for (a, b) in own.pixels.iter().zip(&other.pixels) {
        // Colours without coverage show, since images are premultiplied; NaN is not 0 either.
        if a.iter().chain(b).any(|&channel| channel != 0.0) {
            covered += 1;
            for k in 0..4 {
                let off = f64::from(a[k] - b[k]).abs();
                squares += off * off;
                most = if off <= most { most } else { off };
            }
        }
    }
    let mean = squares / (4 * covered.max(1)) as f64;
    let db = -10.0 * mean.log10();
    // Written so that NaN is wrong.
    let is_right = db >= RIGHT_DB && most <= RIGHT_MOST;
    (!is_right).then(|| {
        format!(
            "its image is wrong: {db:.1} dB and {most:.2} at most, \
             where {RIGHT_DB} and {RIGHT_MOST} are right"
        )
    })
}

/// Draws a question's scenes on a device.
struct RendererRace<'a> {
    gpu: &'a Arc<Gpu>,
    question: Question<'a>,
    renderers: Option<[Renderer; 2]>,
}

impl RendererRace<'_> {
    fn draw(&self, renderer: &mut Renderer, scene: usize) -> Result<()> {
        let scene = &self.question.scenes[scene % self.question.scenes.len()];
        renderer.draw(&scene.posed, &scene.camera, None)
    }

    /// Times of a scene, ms. Where the device tells its own, neither waits for the other, so that
    /// its clocks have no time to change; each comes first in every second pair.
    fn time(&self, renderers: &mut [Renderer; 2], number: usize, scene: usize) -> Result<[f64; 2]> {
        let mut ms = [0.0; 2];
        if self.gpu.probe.timestamp_bits == 0 {
            for (renderer, ms) in renderers.iter_mut().zip(&mut ms) {
                let began = Instant::now();
                self.draw(renderer, scene)?;
                renderer.finish()?;
                *ms = began.elapsed().as_secs_f64() * 1e3;
            }
            return Ok(ms);
        }
        for turn in 0..2 {
            self.draw(&mut renderers[(number + turn) % 2], scene)?;
        }
        for (renderer, ms) in renderers.iter_mut().zip(&mut ms) {
            renderer.finish()?;
            *ms = renderer.report().gpu_ms();
        }
        Ok(ms)
    }
}

impl Race for RendererRace<'_> {
    fn images(&mut self, methods: [RasterMethod; 2]) -> Result<[FrameImage; 2]> {
        let Question {
            avatar, options, ..
        } = self.question;
        let draw = |method| -> Result<(FrameImage, Renderer)> {
            let options = RendererOptions {
                method: Some(method),
                ..options
            };
            let mut renderer = Renderer::new(self.gpu, avatar, options)?;
            self.draw(&mut renderer, 0)?;
            Ok((renderer.read_image()?, renderer))
        };
        let (own, first) = draw(methods[0])?;
        let (rivals, second) = draw(methods[1])?;
        self.renderers = Some([first, second]);
        Ok([own, rivals])
    }

    fn pair(&mut self, number: usize) -> Result<[f64; 2]> {
        let mut renderers = self.renderers.take().expect("images were drawn");
        // A frame in which nothing changes takes no time: no scene follows itself. The first is the
        // image's.
        let scene = 1 + number % (self.question.scenes.len() - 1).max(1);
        let ms = self.time(&mut renderers, number, scene);
        self.renderers = Some(renderers);
        ms
    }
}
