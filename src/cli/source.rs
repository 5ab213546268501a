//! Where a command's avatar and clips come from: files that the user names, else the demo inside
//! the program.

use crate::{files::print_assumptions, kept, options::named};
use anyhow::{Context, ensure};
use effigy_core::{
    avatar::{Avatar, Clip, Pose, motion::Player},
    io::{splats::Up, text},
    scene::{AvatarBounds, Camera},
};
use effigy_formats::{
    cameras,
    open::{self, CaptureOptions, ClipOptions, OpenOptions, OpenedClip},
    retarget::{Correction, Report, RetargetOptions},
    webavatar::ForeignAvatar,
};
use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
    time::Instant,
};

/// The avatar and clips of every command that draws.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct Source {
    /// Avatar to draw: an .avatar file, the paper's .npz, mmlphuman's checkpoint (.pth, to which one
    /// is fitted first), or splats, which stand still: .ply, .splat, .spz, .sog, .ksplat, .glb or
    /// .gltf. Motion of any body moves the demo. `render` takes scenes of several people too,
    /// .scene.json [default: the built-in demo]
    pub avatar: Option<PathBuf>,
    /// Clip that moves the avatar: a .motion file, or motion of any body (.bvh, .fbx, glTF, VRM,
    /// SMPL's parameters, the paper's _poses.json); repeat for several [default: the poses beside
    /// an .npz, else the built-in demo clip]
    #[arg(long, value_name = "FILE")]
    pub motion: Vec<PathBuf>,
    /// Which motion of a file, and of which joints.
    #[command(flatten)]
    pub capture: CaptureArgs,
    /// Axis that points up in splats [default: the file's own, else its format's: y in .spz, .glb
    /// and .gltf, -y in others, as 3DGS trains]
    #[arg(long, value_parser = named(Up::NAMES, Up::ALL), value_name = "AXIS", allow_hyphen_values = true)]
    pub up: Option<Up>,
    /// Whether the networks see the nearest pose that the avatar was trained for, within 2σ along
    /// each principal component of its training poses; off: the pose itself
    #[arg(long, value_enum, default_value_t = PoseProjection::On)]
    pub project: PoseProjection,
}

/// Which motion of a file of another program, and of which joints.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct CaptureArgs {
    /// Joints of motion capture that are other parts than they seem: a JSON file,
    /// {"LeftArm": "their joint", …}
    #[arg(long, value_name = "FILE")]
    joints: Option<PathBuf>,
    /// Animation of a file with several, by its name or its number from 0 [default: the first]
    #[arg(long, value_name = "NAME")]
    animation: Option<String>,
    /// Person of a file with several, from 0: those who are seen longer come first
    #[arg(long, value_name = "N", default_value_t)]
    person: usize,
}

impl CaptureArgs {
    /// Which motion of a file. `rate`: frames a second where the file leaves it open.
    pub fn capture(&self, rate: Option<f64>) -> CaptureOptions {
        CaptureOptions {
            rate,
            animation: self.animation.clone(),
            person: self.person,
        }
    }

    /// How a motion file becomes a clip. `rate`: frames a second where the file leaves it open.
    pub fn clip_options(&self, rate: Option<f64>) -> anyhow::Result<ClipOptions> {
        Ok(ClipOptions {
            capture: self.capture(rate),
            retarget: RetargetOptions {
                corrections: self.corrections()?,
                ..RetargetOptions::default()
            },
        })
    }

    /// Reads which joints are which, where the user says.
    pub fn corrections(&self) -> anyhow::Result<Vec<Correction>> {
        let Some(path) = &self.joints else {
            return Ok(vec![]);
        };
        let bytes =
            std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
        let map: BTreeMap<String, String> = serde_json::from_slice(&text::utf8(&bytes))
            .with_context(|| format!("{} is no list of joints", path.display()))?;
        let correction = |(part, joint)| Correction { part, joint };
        Ok(map.into_iter().map(correction).collect())
    }
}

/// The projection of poses in
/// [`Posed::with_projection`](effigy_core::scene::Posed::with_projection), as an argument.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum PoseProjection {
    /// The networks see the nearest pose that the avatar was trained for.
    // The argument's help already says what both values do.
    #[value(help = None::<&'static str>)]
    #[default]
    On,
    /// The networks see the pose itself.
    #[value(help = None::<&'static str>)]
    Off,
}

impl PoseProjection {
    /// An avatar whose networks see what the user has asked for.
    pub fn apply(self, mut avatar: Avatar) -> Avatar {
        if self == Self::Off {
            avatar.inputs.pose_space = None;
            avatar.inputs.expression_space = None;
        }
        avatar
    }
}

impl Source {
    /// These arguments for another avatar, without those that do not apply to it: what stands still
    /// takes no clips, and nothing but files of splats an axis.
    #[cfg(feature = "window")]
    pub fn for_avatar(&self, path: &Path) -> Self {
        let mut source = self.clone();
        if let Some(motion) = source.avatar.replace(path.to_owned())
            && open::is_motion(&motion)
        {
            source.motion.insert(0, motion);
        }
        if !open::is_splats(path) {
            source.up = None;
        }
        if !source.motion.is_empty() && stands_still(path) {
            source.motion.clear();
        }
        source
    }

    /// Reads the avatar and its clips. There is at least one clip: a static avatar has one of a
    /// single pose. A clip that moves no joint of the avatar is an error.
    pub fn load(&self) -> anyhow::Result<(Avatar, Vec<Clip>)> {
        ensure!(
            self.up.is_none() || self.avatar.as_deref().is_some_and(open::is_splats),
            "--up is for splats only: an avatar file says which axis points up"
        );
        let avatar = match &self.avatar {
            Some(path) if open::is_checkpoint(path) || !open::is_motion(path) => {
                let imported = self.read(path)?;
                print_assumptions(path, &imported.assumptions);
                imported.avatar
            }
            _ => self.project.apply(effigy_demo::avatar()?),
        };
        let clips = self.checked_clips(&avatar)?;
        Ok((avatar, clips))
    }

    /// Reads the clips of an avatar, each of which must move a joint of it.
    fn checked_clips(&self, avatar: &Avatar) -> anyhow::Result<Vec<Clip>> {
        let clips = self.clips(avatar)?;
        for clip in &clips {
            check_joints(clip, avatar)?;
        }
        Ok(clips)
    }

    /// Reads the clips of an avatar as players. There is at least one.
    pub fn players(&self, avatar: &Avatar) -> anyhow::Result<Vec<Player>> {
        Ok(players(self.checked_clips(avatar)?, avatar))
    }

    /// Reads an avatar.
    pub fn read(&self, path: &Path) -> anyhow::Result<ForeignAvatar> {
        let options = OpenOptions {
            up: self.up,
            ..OpenOptions::default()
        };
        let began = Instant::now();
        let imported = opened(path, &options)?;
        let took = began.elapsed().as_secs_f64() * 1e3;
        tracing::info!("read {} in {took:.1} ms", path.display());
        Ok(ForeignAvatar {
            avatar: self.project.apply(imported.avatar),
            ..imported
        })
    }

    /// Reads the avatar, and its clips as players. There is at least one.
    pub fn load_players(&self) -> anyhow::Result<(Avatar, Vec<Player>)> {
        let (avatar, clips) = self.load()?;
        let players = players(clips, &avatar);
        Ok((avatar, players))
    }

    /// Reads the avatar, and its first clip as a player.
    pub fn load_player(&self) -> anyhow::Result<(Avatar, Player)> {
        let (avatar, players) = self.load_players()?;
        let player = players.into_iter().next().context("there is no clip")?;
        Ok((avatar, player))
    }

    /// Reads the clips of an avatar: those that the user names, else the poses beside it, else the
    /// demo's.
    pub fn clips(&self, avatar: &Avatar) -> anyhow::Result<Vec<Clip>> {
        let mut files = self.motion.clone();
        if let Some(path) = &self.avatar {
            if open::is_motion(path) {
                files.insert(0, path.clone());
            } else if files.is_empty() && open::is_foreign(path) {
                files.extend(open::poses_beside(path));
            }
        }
        if files.is_empty() {
            let clip = if avatar.is_static() {
                Clip::still(&avatar.skeleton)
            } else {
                effigy_demo::clip()?
            };
            return Ok(vec![clip]);
        }
        check_moves(avatar)?;
        let options = self.capture.clip_options(None)?;
        let read = files.iter().map(|path| clip(path, avatar, &options));
        read.collect()
    }
}

fn players(clips: Vec<Clip>, avatar: &Avatar) -> Vec<Player> {
    let player = |clip| Player::new(clip, &avatar.skeleton);
    clips.into_iter().map(player).collect()
}

/// Whether a file is an avatar in which nothing moves.
#[cfg(feature = "window")]
fn stands_still(path: &Path) -> bool {
    open::is_splats(path)
        || open::avatar(path, &OpenOptions::default()).is_ok_and(|open| open.avatar.is_static())
}

/// Reads the avatar that motion of another body is to move: the demo unless the user names one.
pub fn avatar_to_move(path: Option<&Path>) -> anyhow::Result<Avatar> {
    Ok(match path {
        Some(path) => opened(path, &OpenOptions::default())?.avatar,
        None => effigy_demo::avatar()?,
    })
}

/// Reads an avatar of any kind.
fn opened(path: &Path, options: &OpenOptions) -> anyhow::Result<ForeignAvatar> {
    if open::is_checkpoint(path) {
        return kept::avatar(path);
    }
    Ok(open::avatar(path, options)?)
}

/// Reads a clip for an avatar, and says what its file left open and how it was made.
pub fn clip(path: &Path, avatar: &Avatar, options: &ClipOptions) -> anyhow::Result<Clip> {
    let opened = open_clip(path, avatar, options)?;
    if let Some(report) = &opened.report {
        let follows = how_it_follows(path, report);
        eprintln!("{follows} (`effigy inspect` lists the joints)");
    }
    Ok(opened.clip)
}

/// How well an avatar follows motion of another body.
pub fn how_it_follows(path: &Path, report: &Report) -> String {
    format!(
        "{} moves {} of {} joints, their bones within {:.1}° on average",
        path.display(),
        report.driven,
        report.all,
        report.directions.mean
    )
}

/// Says that a time, seconds, is not in a clip: what is drawn then is its first or last frame.
pub fn check_time(player: &Player, seconds: f64) {
    let clip = player.clip();
    let duration = clip.duration();
    // Times are written with few digits.
    if duration > 0.0 && !(-1e-3..=duration + 1e-3).contains(&seconds) {
        let shown = if seconds < 0.0 { "first" } else { "last" };
        eprintln!(
            "--time {seconds} is outside the clip `{}`, which is {duration:.2} s long: its {shown} \
             frame is drawn",
            clip.name
        );
    }
}

/// Refuses an avatar that stands still.
pub fn check_moves(avatar: &Avatar) -> anyhow::Result<()> {
    ensure!(
        !avatar.is_static(),
        "`{}` has splats, which stand still: motion is for avatars",
        avatar.name
    );
    Ok(())
}

/// Reads a clip for an avatar, and says what its file left open.
pub fn open_clip(
    path: &Path,
    avatar: &Avatar,
    options: &ClipOptions,
) -> anyhow::Result<OpenedClip> {
    let opened = open::clip(path, avatar, options)?;
    print_assumptions(path, &opened.assumptions);
    Ok(opened)
}

/// Refuses a clip that moves no joint of the avatar.
pub fn check_joints(clip: &Clip, avatar: &Avatar) -> anyhow::Result<()> {
    let moved = clip.map_to(&avatar.skeleton).iter().flatten().count();
    ensure!(
        moved > 0,
        "the clip `{}` moves none of the joints of `{}`: it has {}, the avatar has {}",
        clip.name,
        avatar.name,
        first_names(&clip.joint),
        first_names(&avatar.skeleton.name)
    );
    tracing::info!(
        "the clip `{}` moves {moved} of {} joints",
        clip.name,
        avatar.skeleton.len()
    );
    Ok(())
}

/// Reads the cameras of another program's file in the avatar's world, and says what it left open. No
/// such file says where near planes are: they are as near as the avatar's size asks for.
pub fn cameras(path: &Path, avatar: &Avatar) -> anyhow::Result<Vec<Camera>> {
    let rest = Pose::rest(avatar.skeleton.len(), 0);
    let joints = avatar.skeleton.matrices(&rest);
    let opened = cameras::read(path, joints.first().copied().unwrap_or_default())?;
    print_assumptions(path, &opened.assumptions);
    let near = AvatarBounds::new(avatar).framing(&joints).near;
    let placed = opened.cameras.into_iter();
    Ok(placed.map(|camera| Camera { near, ..camera }).collect())
}

/// The first three names of a list.
fn first_names(names: &[String]) -> String {
    let first: Vec<_> = names
        .iter()
        .take(3)
        .map(|name| format!("`{name}`"))
        .collect();
    let rest = if names.len() > first.len() {
        ", …"
    } else {
        ""
    };
    first.join(", ") + rest
}
