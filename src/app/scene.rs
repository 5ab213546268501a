//! What the window shows: an avatar, its clips, the view and the background. Wishes and the clock go in, what to draw comes out.

use super::{
    action::Action,
    gesture::Gesture,
    orbit::Orbit,
    playback::{Moment, Playback, Track},
};
use crate::{
    avatar::{Avatar, Clip, motion::Player},
    frame::{Camera, Extent, Posed},
    measure::upright,
};
use glam::DVec3;

/// What is behind the avatar unless someone says otherwise: a light grey.
pub const BACKGROUND: [f32; 3] = BACKGROUNDS[0];
/// Backgrounds that the key goes through, display-referred RGB: light grey, white, black, dark blue.
const BACKGROUNDS: [[f32; 3]; 4] = [[0.847, 0.867, 0.890], [1.0; 3], [0.0; 3], [0.10, 0.12, 0.17]];
/// A frame after a rest, or after a long one, counts as this long at most, seconds: the view glides from where it was.
const LONGEST: f64 = 0.1;

/// All that decides about a picture: two frames that look the same need not both be drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    pub moment: Moment,
    pub camera: Camera,
    pub background: [f32; 3],
}

/// The avatar in its view.
pub struct Scene {
    avatar: Avatar,
    players: Vec<Player>,
    extent: Extent,
    playback: Playback,
    orbit: Orbit,
    posed: Posed,
    /// What `posed` is the pose of.
    moment: Moment,
    background: [f32; 3],
    follow: bool,
    /// The clock at the last advance.
    clock: f64,
}

impl Scene {
    /// The first clip plays. `size` is the window's, px; `clock` the time now, seconds.
    pub fn new(avatar: Avatar, clips: Vec<Clip>, background: [f32; 3], (size, clock): ([u32; 2], f64)) -> Self {
        let mut playback = Playback::new(clips.iter().map(Track::from).collect());
        playback.play(true, clock);
        let players: Vec<_> = clips.into_iter().map(|clip| Player::new(clip, &avatar.skeleton)).collect();
        let moment = playback.moment();
        let posed = pose(&avatar, &players, moment);
        let extent = Extent::new(&avatar);
        let orbit = Orbit::new(upright(extent.bounds(&posed.joints)), anchor(&avatar, &posed), size);
        Self { avatar, players, extent, playback, orbit, posed, moment, background, follow: true, clock }
    }

    pub fn avatar(&self) -> &Avatar {
        &self.avatar
    }

    pub fn playback(&self) -> &Playback {
        &self.playback
    }

    pub fn background(&self) -> [f32; 3] {
        self.background
    }

    pub fn follows(&self) -> bool {
        self.follow
    }

    /// The pose of the last advance.
    pub fn posed(&self) -> &Posed {
        &self.posed
    }

    /// Frames have to be drawn without anyone's doing.
    pub fn is_moving(&self) -> bool {
        self.playback.is_moving() || !self.orbit.is_at_rest()
    }

    /// The clip that plays; None without any.
    pub fn player(&self) -> Option<&Player> {
        self.players.get(self.moment.clip)
    }

    /// The first of its clips.
    pub fn first_player(&self) -> Option<&Player> {
        self.players.first()
    }

    /// Moves on to the clock's time, and says what that looks like in a picture of `size` px.
    pub fn advance(&mut self, clock: f64, size: [u32; 2]) -> Look {
        let moment = self.playback.advance(clock);
        self.look(clock, size, moment)
    }

    /// The same but for what plays: its pose stays as it was last shown.
    pub fn hold(&mut self, clock: f64, size: [u32; 2]) -> Look {
        let moment = if self.playback.is_moving() { self.moment } else { self.playback.moment() };
        self.look(clock, size, moment)
    }

    fn look(&mut self, clock: f64, size: [u32; 2], moment: Moment) -> Look {
        self.orbit.advance((clock - self.clock).clamp(0.0, LONGEST));
        self.clock = clock;
        if moment != self.moment {
            self.posed = pose(&self.avatar, &self.players, moment);
            self.moment = moment;
        }
        if self.follow {
            self.orbit.follow(anchor(&self.avatar, &self.posed));
        }
        Look { moment, camera: self.orbit.camera(size), background: self.background }
    }

    /// The clock goes on without frames while nothing moves: that time is no part of a later movement.
    pub fn rest(&mut self, clock: f64) {
        self.clock = clock;
    }

    pub fn resize(&mut self, size: [u32; 2]) {
        self.orbit.resize(size);
    }

    pub fn gesture(&mut self, gesture: &Gesture, size: [u32; 2]) {
        self.orbit.apply(gesture, size);
    }

    /// Does what is asked for, where it is about the scene.
    pub fn act(&mut self, action: Action, clock: f64, size: [u32; 2]) {
        let playback = &mut self.playback;
        match action {
            Action::PlayOrPause => playback.play(!playback.is_playing(), clock),
            Action::Step(frames) => playback.step(frames, clock),
            Action::Scrub(seconds) => playback.scrub(seconds, clock),
            Action::Seek(seconds) => playback.seek(seconds, clock),
            Action::Next(by) => playback.next(by, clock),
            Action::Choose(clip) => playback.choose(clip, clock),
            Action::Speed(speed) => playback.set_speed(speed, clock),
            Action::Repeat(repeat) => playback.set_repeat(repeat),
            Action::ResetView => {
                self.orbit.attach(anchor(&self.avatar, &self.posed));
                self.orbit.reset(upright(self.extent.bounds(&self.posed.joints)), size);
            }
            Action::Follow(follow) => {
                self.follow = follow;
                if follow {
                    self.orbit.attach(anchor(&self.avatar, &self.posed));
                }
            }
            Action::Background(color) => self.background = color.map(|channel| channel.clamp(0.0, 1.0)),
            Action::NextBackground => {
                let next = BACKGROUNDS.iter().position(|known| close(known, &self.background)).map_or(0, |at| at + 1);
                self.background = BACKGROUNDS[next % BACKGROUNDS.len()];
            }
            Action::Avatar(_)
            | Action::NextAvatar
            | Action::Share
            | Action::FullScreen
            | Action::LeaveFullScreenOrQuit
            | Action::Screenshot
            | Action::Capture
            | Action::Overlay
            | Action::Quit => {}
        }
    }
}

/// Whether two colours are the same in 8 bits a channel.
fn close(a: &[f32; 3], b: &[f32; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1.0 / 255.0)
}

fn pose(avatar: &Avatar, players: &[Player], moment: Moment) -> Posed {
    let rest = || crate::avatar::Pose::rest(avatar.skeleton.len(), avatar.inputs.expression);
    Posed::new(avatar, &players.get(moment.clip).map_or_else(rest, |player| player.pose(moment.time)))
}

/// What the view follows: where the root joint stands on the ground. Its height is left out, so that a jump is seen as one.
fn anchor(avatar: &Avatar, posed: &Posed) -> DVec3 {
    let (Some(joint), Some(rest)) = (posed.joints.first(), avatar.skeleton.rest.first()) else { return DVec3::ZERO };
    joint.transform_point3(DVec3::from(rest.map(f64::from))) * DVec3::new(1.0, 0.0, 1.0)
}
