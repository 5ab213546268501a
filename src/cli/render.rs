//! `effigy render`: images of an avatar, drawn by the GPU or by the f64 reference.

use crate::{
    backdrop::{self, Backdrop, BackdropArg},
    backend::BackendArg,
    camera_path::{CrowdPlacement, FrameRange, followed, held},
    cast::Cast,
    files,
    options::{self, CameraArgs, QualityArgs},
    output::{self, IMAGE, Output},
    picture, progress,
    source::{self, Source},
};
use anyhow::{bail, ensure};
use effigy_core::{
    frame::AvatarId,
    io::cameras,
    reference,
    scene::{AvatarBounds, Camera, FrameImage, Framing, Posed},
};
use effigy_measure::bench::Backend;
use effigy_render::vulkan::{Gpu, PreparedAvatar, Renderer, RendererOptions, cache};
#[cfg(feature = "webgpu")]
use effigy_render::webgpu;
use effigy_runtime::slow_start::{self, SlowStart};
use glam::DVec3;
use std::{
    f64::consts::TAU,
    ops::Range,
    path::{Path, PathBuf},
};

/// Width and height of an image unless the user or a camera says otherwise, pixels.
const SIZE: [u32; 2] = [1024, 1024];
/// The largest image that the reference draws, pixels: at 32 bytes each, 4 GB.
const REFERENCE_PIXELS: u64 = 1 << 27;

/// A camera that does not hold everybody goes so much further away, so often at most.
const FURTHER: f64 = 1.03;
const STEPS: i32 = 150;

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Image to write, a .png, .jpg or .webp (without loss), or - for a .png on the standard
    /// output; with --frames or --cameras a number goes before the ending, with both the camera's
    /// and the frame's [default: effigy.png]
    #[arg(short, long, value_name = "FILE", value_parser = IMAGE.parser())]
    out: Option<Output>,
    /// The same without `--out`
    #[arg(hide = true, conflicts_with = "out", value_parser = IMAGE.parser())]
    to: Option<Output>,
    /// Width and height of the image, pixels [default: 1024x1024, or each camera's own of
    /// --cameras]
    #[arg(long, value_name = "WxH", value_parser = options::size)]
    size: Option<[u32; 2]>,
    /// Time in the clip, seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = options::seconds, conflicts_with = "frames")]
    time: f64,
    /// Frames of the clip to render, from A up to B, which is not included: 0..30, 10.., ..30, or
    /// all. One camera holds all of them
    #[arg(long, value_name = "A..B", value_parser = FrameRange::parse)]
    frames: Option<FrameRange>,
    /// Frames a second that --frames counts, each at its time of the clip [default: the clip's own]
    #[arg(long, value_name = "N", value_parser = options::rate, requires = "frames")]
    fps: Option<f64>,
    /// Let the camera of --frames go along with the avatar over the ground
    #[arg(long, requires = "frames", conflicts_with = "cameras")]
    follow: bool,
    /// Draw from each camera of this file: cameras.json of 3DGS or mmlphuman, transforms.json, or
    /// COLMAP's cameras.txt and images.txt or their folder
    #[arg(long, value_name = "FILE")]
    cameras: Option<PathBuf>,
    /// Copies of the avatar, 1 to 1024, each at another time of the clip: up to 16 in a row a metre
    /// apart, more in rows
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    count: u16,
    /// Colour behind the avatar, a PNG or JPEG that covers the image, or `none` for a transparent
    /// image
    #[arg(long, value_name = "RRGGBB|FILE", default_value = options::BACKGROUND, value_parser = backdrop::argument)]
    background: BackdropArg,
    /// Draw with the f64 reference on the CPU instead of the GPU
    #[arg(long)]
    reference: bool,
    /// Graphics API to draw with
    #[arg(long, value_enum, default_value_t = BackendArg::Vulkan)]
    backend: BackendArg,
    #[command(flatten, next_help_heading = "Camera")]
    camera: CameraArgs,
    #[command(flatten, next_help_heading = "Quality")]
    quality: QualityArgs,
}

/// Draws single images: a renderer of either backend with the size of its image, or the reference.
enum ImageRenderer<'a> {
    Vulkan {
        renderer: Box<Renderer>,
        ids: Vec<AvatarId>,
        size: [u32; 2],
        /// Until the first frame is drawn.
        slow_start: Option<SlowStart>,
    },
    #[cfg(feature = "webgpu")]
    WebGpu {
        renderer: Box<webgpu::Renderer>,
        ids: Vec<AvatarId>,
        size: [u32; 2],
    },
    Reference {
        quality: &'a QualityArgs,
    },
}

impl<'a> ImageRenderer<'a> {
    /// Opens what the arguments name, for images of `size` unless a camera has its own.
    fn open(args: &'a Args, cast: &Cast, image_size: [u32; 2]) -> anyhow::Result<Self> {
        if args.reference {
            return Ok(Self::Reference {
                quality: &args.quality,
            });
        }
        let options = RendererOptions {
            instances: cast.len(),
            ..args.quality.renderer(image_size)
        };
        let gpu = args.quality.gpu();
        let [first, others @ ..] = &cast.avatars[..] else {
            bail!("there is nobody to draw");
        };
        let mut ids = vec![AvatarId::FIRST];
        Ok(match args.backend.try_into()? {
            Backend::Vulkan => {
                let gpu = Gpu::new(&gpu)?;
                println!("drawing with {}", gpu.probe.name);
                let slow_start = slow_start(&gpu);
                let mut renderer = Box::new(Renderer::new(&gpu, first, options)?);
                for avatar in others {
                    ids.push(renderer.add_avatar(&PreparedAvatar::new(avatar)?)?);
                }
                Self::Vulkan {
                    renderer,
                    ids,
                    size: image_size,
                    slow_start,
                }
            }
            #[cfg(feature = "webgpu")]
            Backend::WebGpu => {
                let gpu = webgpu::Gpu::open(gpu.device.as_deref())?;
                println!("drawing with {} through WebGPU", gpu.name());
                let mut renderer = Box::new(webgpu::Renderer::new(&gpu, first, options)?);
                for avatar in others {
                    let id = renderer.add_avatar(avatar)?;
                    renderer.upload(id, avatar)?;
                    ids.push(id);
                }
                Self::WebGpu {
                    renderer,
                    ids,
                    size: image_size,
                }
            }
        })
    }

    /// Draws one image of the camera's size.
    fn draw(
        &mut self,
        cast: &Cast,
        posed: &[Posed],
        camera: &Camera,
    ) -> anyhow::Result<FrameImage> {
        match self {
            Self::Reference { quality } => {
                let [width, height] = camera.size;
                let pixels = u64::from(width) * u64::from(height);
                ensure!(
                    pixels <= REFERENCE_PIXELS,
                    "the reference draws at most {REFERENCE_PIXELS} pixels, not {width} x {height}"
                );
                let options = quality.renderer(camera.size);
                Ok(reference::render_shown(
                    &cast.reference(posed),
                    camera,
                    options.supersampling,
                    options.filter,
                ))
            }
            Self::Vulkan {
                renderer,
                ids,
                size,
                slow_start,
            } => {
                if camera.size != *size {
                    renderer.resize(camera.size)?;
                    *size = camera.size;
                }
                renderer.draw_scene(&cast.people(posed, ids), camera, None)?;
                let image = renderer.read_image()?;
                slow_start.take();
                Ok(image)
            }
            #[cfg(feature = "webgpu")]
            Self::WebGpu {
                renderer,
                ids,
                size,
            } => {
                if camera.size != *size {
                    renderer.resize(camera.size)?;
                    *size = camera.size;
                }
                renderer.draw_scene(&cast.people(posed, ids), camera)?;
                Ok(renderer.read_image()?)
            }
        }
    }
}

/// Everything that the images of one command have in common.
struct Shoot<'a> {
    args: &'a Args,
    out: &'a Output,
    cast: &'a Cast,
}

/// An image to take.
struct Shot {
    camera: Camera,
    /// Time of the clip.
    seconds: f64,
    out: Output,
}

impl Shoot<'_> {
    /// Where everybody is at a time of the clip.
    fn place(&self, seconds: f64) -> CrowdPlacement {
        let posed = self.cast.posed(seconds);
        let people = self.cast.reference(&posed);
        place(people.iter().zip(self.cast.bounds()))
    }

    /// The camera of the arguments that looks at a box. `places`: where somebody stands in it.
    fn camera(&self, bounds: [DVec3; 2], places: &[CrowdPlacement]) -> anyhow::Result<Camera> {
        let size = self.args.size.unwrap_or(SIZE);
        let framing = framing(self.cast.is_static(), bounds);
        let mut arguments = self.args.camera.clone();
        // Several stand anywhere in the box.
        if arguments.distance.is_some() || !self.cast.is_one_person() {
            return arguments.camera(framing, size);
        }
        let fov = arguments.fov.to_radians();
        let first = places.first().map_or(bounds, |place| place.bounds);
        let first = Framing::person(first).bounds;
        let nearest = Camera::standing_distance(first, fov, size);
        let mut camera = arguments.camera(framing, size)?;
        // As near as for who stands in the middle, then as far as all of the places need.
        for step in 0..STEPS {
            arguments.distance = Some(nearest * FURTHER.powi(step));
            camera = arguments.camera(framing, size)?;
            if places.iter().all(|place| place.is_in_view(&camera)) {
                break;
            }
        }
        Ok(camera)
    }

    /// A camera for each of these times, `rate` a second: one that holds all of them, or follows.
    fn cameras(&self, times: &[f64], rate: f64) -> anyhow::Result<Vec<Camera>> {
        let places: Vec<CrowdPlacement> =
            times.iter().map(|&seconds| self.place(seconds)).collect();
        if self.args.follow {
            let boxes = followed(&places, rate);
            return boxes
                .into_iter()
                .map(|bounds| self.camera(bounds, &[]))
                .collect();
        }
        Ok(vec![self.camera(held(&places), &places)?; times.len()])
    }

    /// All images to take: of one time or of frames, `rate` a second, from the camera of the
    /// arguments or from those of a file.
    fn shots(
        &self,
        frames: Option<Range<usize>>,
        rate: f64,
        cameras: Option<&[Camera]>,
    ) -> anyhow::Result<Vec<Shot>> {
        let Args { time, size, .. } = self.args;
        let numbers: Vec<usize> = frames.clone().into_iter().flatten().collect();
        let times: Vec<f64> = match frames {
            Some(_) => numbers.iter().map(|&frame| frame as f64 / rate).collect(),
            None => vec![*time],
        };
        // Without frames there is one time and no number for it.
        let named = |out: &Output, at: usize| match numbers.get(at) {
            Some(&frame) => out.numbered(frame),
            None => out.clone(),
        };
        let timed = times.iter().copied().enumerate();
        let Some(cameras) = cameras else {
            let own = self.cameras(&times, rate)?;
            let shot = |((at, seconds), camera)| Shot {
                camera,
                seconds,
                out: named(self.out, at),
            };
            return Ok(timed.zip(own).map(shot).collect());
        };
        let of_camera = |(number, camera): (usize, &Camera)| {
            let camera = cameras::scaled(camera, size.unwrap_or(camera.size));
            let out = self.out.numbered(number);
            let shot = |(at, seconds)| Shot {
                camera,
                seconds,
                out: named(&out, at),
            };
            timed.clone().map(shot).collect::<Vec<_>>()
        };
        Ok(cameras.iter().enumerate().flat_map(of_camera).collect())
    }
}

pub fn run(mut args: Args) -> anyhow::Result<()> {
    let out = &args
        .out
        .take()
        .or(args.to.take())
        .map_or_else(default_output, Ok)?;
    ensure!(
        out.ending() != "jpg" || !matches!(args.background, BackdropArg::Transparent),
        "a .jpg has no transparency: write a .png or .webp, or give --background a colour"
    );
    let mut cast = Cast::load(&args.source, args.count.into())?;
    for avatar in &mut cast.avatars {
        args.quality.filter.apply(avatar);
    }
    let player = cast.player();
    // What can't be drawn or written is refused before a device is opened, which may take seconds.
    let rate = args.fps.unwrap_or(player.clip().rate);
    let frames = match args.frames {
        Some(frames) => Some(frames.of(player.clip(), rate)?),
        None => None,
    };
    let cameras = match &args.cameras {
        Some(path) => Some(source::cameras(path, &cast.avatars[0])?),
        None => None,
    };
    if frames.is_none() {
        source::check_time(player, args.time);
    }
    let is_series = frames.is_some() || cameras.is_some();
    let mut backdrop = Backdrop::open(&args.background)?;
    let shoot = Shoot {
        args: &args,
        out,
        cast: &cast,
    };
    let shots = shoot.shots(frames, rate, cameras.as_deref())?;
    if is_series {
        output::check_series(out, shots.iter().map(|shot| &shot.out))?;
    }
    let mut renderer = ImageRenderer::open(&args, &cast, args.size.unwrap_or(SIZE))?;
    let bar = progress::items(shots.len() as u64, "images");
    for shot in &shots {
        let posed = cast.posed(shot.seconds);
        let image = renderer.draw(&cast, &posed, &shot.camera)?;
        picture::write(&backdrop.behind(&image), &shot.out)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    match shots.as_slice() {
        [only] => println!("wrote {}", only.out.display()),
        [first, .., last] => println!("wrote {} to {}", first.out.display(), last.out.display()),
        [] => {}
    }
    Ok(())
}

/// The file that is written where none is named.
fn default_output() -> anyhow::Result<Output> {
    let out = Output::new("effigy.png".into(), "png");
    output::check([&out])?;
    Ok(out)
}

/// What a camera frames in a box around avatars.
fn framing(is_static: bool, bounds: [DVec3; 2]) -> Framing {
    if is_static {
        Framing::scene(bounds)
    } else {
        Framing::person(bounds)
    }
}

/// Where people are, each with the bounds of their avatar.
fn place<'a>(
    people: impl Iterator<Item = (&'a reference::Person<'a>, &'a AvatarBounds)>,
) -> CrowdPlacement {
    let places = people.map(|(person, bounds)| {
        let joints = &person.posed.joints;
        CrowdPlacement {
            // A scene is where it shows, not where its furthest splats are.
            bounds: if person.avatar.is_static() {
                bounds.framing(joints).bounds
            } else {
                bounds.bounds(joints)
            },
            ground: person.posed.ground(person.avatar),
        }
    });
    let places: Vec<CrowdPlacement> = places.collect();
    let ground: DVec3 = places.iter().map(|place| place.ground).sum();
    CrowdPlacement {
        bounds: held(&places),
        ground: ground / places.len() as f64,
    }
}

/// Renders a turn around the avatar while it moves, for a machine without a display, and prints
/// where the images are.
pub fn turntable(source: &Source, folder: &Path) -> anyhow::Result<()> {
    const IMAGES: usize = 24;
    /// The part of the clip that is shown, seconds at most.
    const SECONDS: f64 = 6.0;
    const FOV: f64 = 35.0 / 360.0 * TAU;
    let size = [720, 960];
    let (avatar, player) = source.load_player()?;
    let gpu = Gpu::new(&effigy_runtime::cache::headless(None))?;
    println!("drawing a turntable with {}", gpu.probe.name);
    let mut slow_start = slow_start(&gpu);
    let mut renderer = Renderer::new(&gpu, &avatar, RendererOptions::new(size))?;
    files::create_folder(folder)?;
    let mut backdrop =
        Backdrop::Color(options::color(options::BACKGROUND).map_err(anyhow::Error::msg)?);
    let bounds = AvatarBounds::new(&avatar);
    let posed = |number: usize| {
        let share = number as f64 / IMAGES as f64;
        let seconds = share * player.clip().duration().min(SECONDS);
        Posed::new(&avatar, &player.pose(seconds))
    };
    let places = (0..IMAGES).map(|number| {
        let posed = posed(number);
        let person = reference::Person {
            avatar: &avatar,
            posed: &posed,
        };
        place(std::iter::once((&person, &bounds)))
    });
    let places: Vec<CrowdPlacement> = places.collect();
    let framing = framing(avatar.is_static(), held(&places));
    let distance = if avatar.is_static() {
        Camera::framing_distance(framing.bounds, FOV, size)
    } else {
        Camera::standing_distance(framing.bounds, FOV, size)
    };
    let bar = progress::items(IMAGES as u64, "images");
    for number in 0..IMAGES {
        let turn = number as f64 / IMAGES as f64 * TAU;
        let camera = Camera {
            near: framing.near,
            ..Camera::orbit(framing.middle(), turn, 0.09, distance, FOV, size)
        };
        renderer.draw(&posed(number), &camera, None)?;
        let out = Output::new(folder.join(format!("{number:02}.png")), "png");
        let image = renderer.read_image()?;
        slow_start.take();
        picture::write(&backdrop.behind(&image), &out)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    println!("wrote {IMAGES} images to {}", folder.display());
    Ok(())
}

/// Explains a first start, whose wait is for the driver's compiler.
fn slow_start(gpu: &Gpu) -> Option<SlowStart> {
    let sentence = slow_start::compiling(&gpu.probe.name);
    cache::is_first_start(gpu.cache_folder())
        .then(|| SlowStart::new(move || eprintln!("{sentence}")))
}
