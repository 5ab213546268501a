//! The scene in the window: an avatar, its clips, the view and the background. Actions, gestures
//! and the clock go in, the content of a frame comes out.

use crate::{
    action::Action,
    gesture::Gesture,
    orbit::OrbitCamera,
    playback::{ClipTime, ClipTiming, Playback},
};
use effigy_core::{
    avatar::{Avatar, Clip, Pose, motion::Player},
    scene::{AvatarBounds, Camera, FrameImage, Posed},
};
use image::RgbaImage;
use std::sync::Arc;

/// Puts a picture behind an image, whatever its size.
pub type BehindImage = Arc<dyn Fn(&FrameImage) -> RgbaImage + Send + Sync>;

/// Default colour behind the avatar: light grey, display-referred RGB.
pub const BACKGROUND: [f32; 3] = BACKGROUNDS[0];
/// Backgrounds that the key B cycles through, display-referred RGB: light grey, white, black, dark
/// blue.
const BACKGROUNDS: [[f32; 3]; 4] = [
    [0.847, 0.867, 0.890],
    [1.0; 3],
    [0.0; 3],
    [0.10, 0.12, 0.17],
];

/// The background of the avatar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewerBackground {
    /// Display-referred RGB, 0 to 1.
    pub color: [f32; 3],
    /// Whether the viewer has a picture to show in its place.
    pub has_picture: bool,
    /// Whether it does.
    pub shows_picture: bool,
}

impl From<[f32; 3]> for ViewerBackground {
    fn from(color: [f32; 3]) -> Self {
        Self {
            color,
            has_picture: false,
            shows_picture: false,
        }
    }
}

impl ViewerBackground {
    /// The picture, then the known colours.
    fn next(self) -> Self {
        let known = BACKGROUNDS
            .iter()
            .position(|known| is_same_color(known, &self.color))
            .filter(|_| !self.shows_picture);
        let index = known.map_or(0, |index| index + 1);
        Self {
            color: BACKGROUNDS[index % BACKGROUNDS.len()],
            shows_picture: self.has_picture && index == BACKGROUNDS.len(),
            ..self
        }
    }
}

/// Longest time that the view glides in one frame, seconds: after a pause it does not jump.
const GLIDE_MAX: f64 = 0.1;

/// Everything that determines a frame's image: a frame equal to the one shown need not be drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameContent {
    /// The clip and the time in it: the pose.
    pub position: ClipTime,
    /// The view.
    pub camera: Camera,
    /// Display-referred RGB, 0 to 1. None: the viewer's picture.
    pub background: Option<[f32; 3]>,
}

/// An avatar with its clips, seen by an orbiting camera. `clock` is always a time in seconds that
/// never goes back.
pub struct ViewerScene {
    avatar: Arc<Avatar>,
    players: Vec<Player>,
    avatar_bounds: AvatarBounds,
    playback: Playback,
    orbit: OrbitCamera,
    posed: Posed,
    /// The clip and time that `posed` is for.
    position: ClipTime,
    background: ViewerBackground,
    /// The view moves with the avatar over the ground.
    follow: bool,
    /// The clock at the last advance.
    clock: f64,
}

impl ViewerScene {
    /// The first clip plays from now on. `size`: the image's, px.
    pub fn new(
        avatar: impl Into<Arc<Avatar>>,
        clips: Vec<Clip>,
        background: impl Into<ViewerBackground>,
        size: [u32; 2],
        clock: f64,
    ) -> Self {
        let avatar = avatar.into();
        let mut playback = Playback::new(clips.iter().map(ClipTiming::from).collect());
        playback.play(true, clock);
        let players: Vec<_> = clips
            .into_iter()
            .map(|clip| Player::new(clip, &avatar.skeleton))
            .collect();
        let position = playback.position();
        let posed = pose(&avatar, &players, position);
        let avatar_bounds = AvatarBounds::new(&avatar);
        let orbit = OrbitCamera::new(
            avatar_bounds.framing(&posed.joints),
            posed.ground(&avatar),
            size,
        );
        let orbit = if avatar.is_static() {
            orbit
        } else {
            orbit.of_person(size)
        };
        Self {
            avatar,
            players,
            avatar_bounds,
            playback,
            orbit,
            posed,
            position,
            background: background.into(),
            follow: true,
            clock,
        }
    }

    /// The avatar.
    pub fn avatar(&self) -> &Arc<Avatar> {
        &self.avatar
    }

    /// Shows another state of the avatar: the clips, the place in them and the view stay. Joints
    /// may have other names and places.
    pub fn replace_avatar(&mut self, avatar: Arc<Avatar>) {
        if avatar.skeleton != self.avatar.skeleton {
            for player in &mut self.players {
                *player = Player::new(player.clip().clone(), &avatar.skeleton);
            }
        }
        self.posed = pose(&avatar, &self.players, self.position);
        self.avatar_bounds = AvatarBounds::new(&avatar);
        self.avatar = avatar;
    }

    /// Adds clips, and plays the first of them.
    pub fn add_clips(&mut self, clips: Vec<Clip>, clock: f64) {
        if clips.is_empty() {
            return;
        }
        let first = self.players.len();
        self.playback.add(clips.iter().map(ClipTiming::from));
        let player = |clip| Player::new(clip, &self.avatar.skeleton);
        self.players.extend(clips.into_iter().map(player));
        self.playback.choose(first, clock);
        self.playback.play(true, clock);
    }

    /// Which clip plays, and how.
    pub fn playback(&self) -> &Playback {
        &self.playback
    }

    /// The background of the avatar.
    pub fn background(&self) -> ViewerBackground {
        self.background
    }

    /// Whether the view moves with the avatar over the ground.
    pub fn follows(&self) -> bool {
        self.follow
    }

    /// The pose of the last frame.
    pub fn posed(&self) -> &Posed {
        &self.posed
    }

    /// Whether the content changes with the clock, so that frames have to be drawn.
    pub fn is_moving(&self) -> bool {
        self.playback.is_moving() || !self.orbit.is_at_rest()
    }

    /// The clip that is shown. None if the avatar has no clip.
    pub fn player(&self) -> Option<&Player> {
        self.players.get(self.position.clip)
    }

    /// The first clip. None if the avatar has no clip.
    pub fn first_player(&self) -> Option<&Player> {
        self.players.first()
    }

    /// Moves on to the clock's time. Returns the content of a frame of `size` px.
    pub fn advance(&mut self, clock: f64, size: [u32; 2]) -> FrameContent {
        let position = self.playback.advance(clock);
        self.content(clock, size, position)
    }

    /// Moves the view on to the clock's time, but repeats the last frame's pose if a clip plays.
    /// Returns the content of a frame of `size` px.
    pub fn hold_pose(&mut self, clock: f64, size: [u32; 2]) -> FrameContent {
        let position = if self.playback.is_moving() {
            self.position
        } else {
            self.playback.position()
        };
        self.content(clock, size, position)
    }

    fn content(&mut self, clock: f64, size: [u32; 2], position: ClipTime) -> FrameContent {
        self.orbit
            .advance((clock - self.clock).clamp(0.0, GLIDE_MAX));
        self.clock = clock;
        if position != self.position {
            self.posed = pose(&self.avatar, &self.players, position);
            self.position = position;
        }
        if self.follow {
            self.orbit.follow(self.posed.ground(&self.avatar));
        }
        FrameContent {
            position,
            camera: self.orbit.camera(size),
            background: (!self.background.shows_picture).then_some(self.background.color),
        }
    }

    /// No frame was drawn until now: this time is not part of a later movement.
    pub fn skip_to(&mut self, clock: f64) {
        self.clock = clock;
    }

    /// The image has a new size, px.
    pub fn resize(&mut self, size: [u32; 2]) {
        self.orbit.resize(size);
    }

    /// Applies a gesture, px of an image of `size`.
    pub fn gesture(&mut self, gesture: &Gesture, size: [u32; 2]) {
        self.orbit.apply(gesture, size);
    }

    /// Carries out an action that concerns the scene; others are ignored.
    pub fn act(&mut self, action: Action, clock: f64, size: [u32; 2]) {
        let playback = &mut self.playback;
        match action {
            Action::PlayOrPause => playback.play(!playback.is_playing(), clock),
            Action::Step(frames) => playback.step(frames, clock),
            Action::Scrub(seconds) => playback.scrub(seconds, clock),
            Action::Seek(seconds) => playback.seek(seconds, clock),
            Action::Next(by) => playback.skip_clips(by, clock),
            Action::Choose(clip) => playback.choose(clip, clock),
            Action::Speed(speed) => playback.set_speed(speed, clock),
            Action::Repeat(repeat) => playback.set_repeat(repeat),
            Action::ResetView => {
                self.orbit.glide_to_anchor(self.posed.ground(&self.avatar));
                self.orbit
                    .reset(self.avatar_bounds.framing(&self.posed.joints), size);
            }
            Action::View(view) => {
                let framing = self.avatar_bounds.framing(&self.posed.joints);
                let sight = view.of(&self.avatar, &self.posed, framing.bounds);
                self.orbit.glide_to_anchor(self.posed.ground(&self.avatar));
                self.orbit.show(framing, &sight, size);
            }
            Action::Zoom(zoom) => {
                let gesture = Gesture {
                    zoom,
                    ..Gesture::default()
                };
                self.orbit.apply(&gesture, size);
            }
            Action::Follow(follow) => {
                self.follow = follow;
                if follow {
                    self.orbit.glide_to_anchor(self.posed.ground(&self.avatar));
                }
            }
            Action::Background(color) => {
                self.background.color = color.map(|channel| channel.clamp(0.0, 1.0));
                self.background.shows_picture = false;
            }
            Action::NextBackground => self.background = self.background.next(),
            Action::Avatar(_)
            | Action::NextAvatar
            | Action::Share
            | Action::FullScreen
            | Action::LeaveFullScreenOrQuit
            | Action::Screenshot
            | Action::Capture
            | Action::Overlay
            | Action::Keys
            | Action::Open
            | Action::Survey
            | Action::ShareSurvey
            | Action::Quit => {}
        }
    }
}

/// Whether two colours are the same in 8 bits a channel.
fn is_same_color(a: &[f32; 3], b: &[f32; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1.0 / 255.0)
}

/// The avatar at a time of a clip; at rest without clips.
fn pose(avatar: &Avatar, players: &[Player], position: ClipTime) -> Posed {
    let pose = match players.get(position.clip) {
        Some(player) => player.pose(position.time),
        None => Pose::rest(avatar.skeleton.len(), avatar.inputs.expression),
    };
    Posed::new(avatar, &pose)
}
