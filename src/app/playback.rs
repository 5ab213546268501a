//! Which clip plays, and at which time of it: the clock and the user's actions go in, the clip time
//! to draw comes out.

use effigy_core::avatar::Clip;

/// Slowest and fastest speed, seconds of the clip a second.
pub const SPEED: [f64; 2] = [0.1, 4.0];

/// Behaviour at the end of a clip.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Repeat {
    /// Playback stops.
    Off,
    /// The clip starts again.
    #[default]
    Clip,
    /// The next clip that moves starts; the first follows the last.
    All,
}

/// Name and timing of a clip.
#[derive(Clone, Debug, PartialEq)]
pub struct ClipTiming {
    /// The clip's name.
    pub name: String,
    /// Seconds from the first frame to the last; 0 for a single pose.
    pub duration: f64,
    /// Frames a second.
    pub rate: f64,
}

impl From<&Clip> for ClipTiming {
    fn from(clip: &Clip) -> Self {
        Self {
            name: clip.name.clone(),
            duration: clip.duration(),
            rate: clip.rate,
        }
    }
}

/// A time of a clip: it determines the pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipTime {
    /// Index of the clip.
    pub clip: usize,
    /// Seconds from the clip's start.
    pub time: f64,
}

/// When and where playback started.
#[derive(Clone, Copy, Debug)]
struct PlaybackStart {
    /// On the clock, seconds.
    clock: f64,
    /// The position drawn then.
    position: ClipTime,
}

/// Plays one of several clips. `clock` is always a time in seconds that never goes back.
///
/// While a clip plays, its time is computed from the start of playback, never summed over frames or
/// repetitions. So it does not drift, and does not depend on how many frames were drawn.
#[derive(Clone, Debug)]
pub struct Playback {
    tracks: Vec<ClipTiming>,
    clip: usize,
    time: f64,
    speed: f64,
    repeat: Repeat,
    /// None while paused.
    started: Option<PlaybackStart>,
    /// The clock at the last call that passed it.
    clock: f64,
}

impl Playback {
    /// Paused at the beginning of the first clip. Without clips the time is always 0.
    pub fn new(tracks: Vec<ClipTiming>) -> Self {
        Self {
            tracks,
            clip: 0,
            time: 0.0,
            speed: 1.0,
            repeat: Repeat::default(),
            started: None,
            clock: 0.0,
        }
    }

    /// The clips.
    pub fn tracks(&self) -> &[ClipTiming] {
        &self.tracks
    }

    /// Adds clips behind the others.
    pub fn add(&mut self, tracks: impl IntoIterator<Item = ClipTiming>) {
        self.tracks.extend(tracks);
    }

    /// The clip and the time in it that are shown.
    pub fn position(&self) -> ClipTime {
        ClipTime {
            clip: self.clip,
            time: self.time,
        }
    }

    /// Seconds of the clip a second.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Behaviour at the end of a clip.
    pub fn repeat(&self) -> Repeat {
        self.repeat
    }

    /// Length of the current clip, seconds.
    pub fn duration(&self) -> f64 {
        self.tracks
            .get(self.clip)
            .map_or(0.0, |track| track.duration)
    }

    /// Whether a clip plays.
    pub fn is_playing(&self) -> bool {
        self.started.is_some()
    }

    /// Whether the position changes with the clock, so that frames have to be drawn.
    pub fn is_moving(&self) -> bool {
        self.is_playing() && self.duration() > 0.0
    }

    /// Moves on to the clock's time. NaN and infinities are ignored.
    pub fn advance(&mut self, clock: f64) -> ClipTime {
        if clock.is_finite() {
            self.clock = clock;
            if let Some(start) = self.started
                && self.duration() > 0.0
            {
                let seconds = (clock - start.clock).max(0.0) * self.speed;
                self.play_on(start.position, seconds);
            }
        }
        self.position()
    }

    /// Goes to where playing for some seconds leads from a position.
    fn play_on(&mut self, from: ClipTime, seconds: f64) {
        self.clip = from.clip;
        self.time = from.time + seconds;
        let duration = self.duration();
        if self.time < duration {
            return;
        }
        match self.repeat {
            Repeat::Off => {
                self.time = duration;
                self.started = None;
            }
            Repeat::Clip => self.time %= duration,
            Repeat::All => {
                let all: f64 = self.tracks.iter().map(|track| track.duration).sum();
                self.time = (self.time - duration) % all;
                self.clip = (from.clip + 1) % self.tracks.len();
                while self.time >= self.duration() {
                    self.time -= self.duration();
                    self.clip = (self.clip + 1) % self.tracks.len();
                }
            }
        }
    }

    fn set_time(&mut self, time: f64, clock: f64) {
        self.time = time;
        self.clock = clock;
        if self.is_playing() {
            self.restart(clock);
        }
    }

    /// Plays from the current position on.
    fn restart(&mut self, clock: f64) {
        self.started = Some(PlaybackStart {
            clock,
            position: self.position(),
        });
    }

    /// Plays or pauses. Playing from the end of a clip that does not repeat starts it again.
    pub fn play(&mut self, play: bool, clock: f64) {
        self.advance(clock);
        if play && self.repeat == Repeat::Off && self.time >= self.duration() {
            self.time = 0.0;
        }
        if play {
            self.restart(clock);
        } else {
            self.started = None;
        }
    }

    /// Goes to a time of the current clip, limited to its length. NaN and infinities are ignored.
    pub fn seek(&mut self, time: f64, clock: f64) {
        if time.is_finite() {
            self.set_time(time.clamp(0.0, self.duration()), clock);
        }
    }

    /// Goes forwards or back by some seconds, past the ends if the clip repeats.
    pub fn scrub(&mut self, by: f64, clock: f64) {
        self.advance(clock);
        let duration = self.duration();
        let mut time = self.time + by;
        if self.repeat != Repeat::Off && duration > 0.0 {
            time = time.rem_euclid(duration);
        }
        self.seek(time, clock);
    }

    /// Pauses and goes on by some frames of the clip, or back.
    pub fn step(&mut self, frames: i32, clock: f64) {
        self.play(false, clock);
        let Some(track) = self.tracks.get(self.clip) else {
            return;
        };
        let rate = track.rate;
        let last = (track.duration * rate).round();
        let here = self.time * rate;
        // A time within a thousandth of a frame counts as on it.
        let from = if frames > 0 {
            (here + 1e-3).floor()
        } else {
            (here - 1e-3).ceil()
        };
        let to = from + f64::from(frames);
        let to = if self.repeat == Repeat::Off {
            to.clamp(0.0, last)
        } else {
            to.rem_euclid(last + 1.0)
        };
        self.time = (to / rate).min(self.duration());
    }

    /// Goes to the start of a clip. An index out of range is ignored.
    pub fn choose(&mut self, clip: usize, clock: f64) {
        if clip < self.tracks.len() {
            self.clip = clip;
            self.set_time(0.0, clock);
        }
    }

    /// Goes on by some clips, or back; the first follows the last.
    pub fn skip_clips(&mut self, by: i32, clock: f64) {
        if self.tracks.is_empty() {
            return;
        }
        let clip = (self.clip as i64 + i64::from(by)).rem_euclid(self.tracks.len() as i64);
        self.choose(clip as usize, clock);
    }

    /// Sets the speed, limited to [`SPEED`]. NaN and infinities are ignored.
    pub fn set_speed(&mut self, speed: f64, clock: f64) {
        self.advance(clock);
        if speed.is_finite() {
            self.speed = speed.clamp(SPEED[0], SPEED[1]);
        }
        self.set_time(self.time, clock);
    }

    /// Sets the behaviour at the end of a clip.
    pub fn set_repeat(&mut self, repeat: Repeat) {
        // The new setting applies from now on, not to the time already played.
        self.set_time(self.time, self.clock);
        self.repeat = repeat;
    }
}
