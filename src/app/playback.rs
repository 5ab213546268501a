//! Which clip plays and where it stands: a clock and the user's wishes go in, the moment to draw comes out.

use crate::avatar::Clip;

/// Slowest and fastest playing, in seconds of the clip a second.
pub const SPEED: [f64; 2] = [0.1, 4.0];

/// What follows the end of a clip.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Repeat {
    /// It stops there.
    Off,
    /// The same clip again.
    #[default]
    Clip,
    /// The next clip that moves, after the last the first.
    All,
}

/// What playing needs to know of a clip.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    pub name: String,
    /// Seconds from the first frame to the last; 0 for a single pose.
    pub duration: f64,
    /// Frames a second.
    pub rate: f64,
}

impl From<&Clip> for Track {
    fn from(clip: &Clip) -> Self {
        Self { name: clip.name.clone(), duration: clip.duration(), rate: clip.rate }
    }
}

/// What is drawn: two equal moments have the same pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    pub clip: usize,
    /// Seconds from the clip's start.
    pub time: f64,
}

/// Where playing began.
#[derive(Clone, Copy, Debug)]
struct Began {
    /// The clock then.
    clock: f64,
    /// What was drawn then.
    moment: Moment,
}

/// Plays one of several clips. Times of the clock are seconds that only rise.
///
/// While it plays, the position is worked out from when playing began, never summed up over frames or over the clip's repetitions: it
/// does not drift, and depends on the clock alone, not on how many frames were drawn.
#[derive(Clone, Debug)]
pub struct Playback {
    tracks: Vec<Track>,
    clip: usize,
    time: f64,
    speed: f64,
    repeat: Repeat,
    /// None while paused.
    began: Option<Began>,
    /// The clock when it was last told.
    clock: f64,
}

impl Playback {
    /// Starts paused at the beginning of the first clip. Without any clip there is one moment.
    pub fn new(tracks: Vec<Track>) -> Self {
        Self { tracks, clip: 0, time: 0.0, speed: 1.0, repeat: Repeat::default(), began: None, clock: 0.0 }
    }

    pub fn tracks(&self) -> &[Track] {
        &self.tracks
    }

    pub fn moment(&self) -> Moment {
        Moment { clip: self.clip, time: self.time }
    }

    pub fn speed(&self) -> f64 {
        self.speed
    }

    pub fn repeat(&self) -> Repeat {
        self.repeat
    }

    /// Seconds of the current clip.
    pub fn duration(&self) -> f64 {
        self.tracks.get(self.clip).map_or(0.0, |track| track.duration)
    }

    pub fn is_playing(&self) -> bool {
        self.began.is_some()
    }

    /// The moment changes without anyone's doing: frames have to be drawn.
    pub fn is_moving(&self) -> bool {
        self.is_playing() && self.duration() > 0.0
    }

    /// Moves on to the clock's time. A clock that is no number changes nothing.
    pub fn advance(&mut self, clock: f64) -> Moment {
        if clock.is_finite() {
            self.clock = clock;
            if let Some(began) = self.began
                && self.duration() > 0.0
            {
                self.follow(began.moment, (clock - began.clock).max(0.0) * self.speed);
            }
        }
        self.moment()
    }

    /// Goes to where so many seconds of playing lead from a moment.
    fn follow(&mut self, from: Moment, seconds: f64) {
        (self.clip, self.time) = (from.clip, from.time + seconds);
        let duration = self.duration();
        if self.time < duration {
            return;
        }
        match self.repeat {
            Repeat::Off => {
                self.time = duration;
                self.began = None;
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
        self.began = self.began.map(|_| Began { clock, moment: self.moment() });
    }

    /// Plays or pauses. Playing from the end of a clip that does not repeat begins it again.
    pub fn play(&mut self, play: bool, clock: f64) {
        self.advance(clock);
        if play && self.repeat == Repeat::Off && self.time >= self.duration() {
            self.time = 0.0;
        }
        self.began = play.then_some(Began { clock, moment: self.moment() });
    }

    /// Goes to a time of the current clip; beyond its ends, to the nearest.
    pub fn seek(&mut self, time: f64, clock: f64) {
        if time.is_finite() {
            self.set_time(time.clamp(0.0, self.duration()), clock);
        }
    }

    /// Goes forwards or back; over the ends where the clip repeats.
    pub fn scrub(&mut self, by: f64, clock: f64) {
        self.advance(clock);
        let (time, duration) = (self.time + by, self.duration());
        let around = self.repeat != Repeat::Off && duration > 0.0;
        self.seek(if around { time.rem_euclid(duration) } else { time }, clock);
    }

    /// Pauses and goes to the clip's next frame, or the one before.
    pub fn step(&mut self, frames: i32, clock: f64) {
        self.play(false, clock);
        let Some(track) = self.tracks.get(self.clip) else { return };
        let (rate, last) = (track.rate, (track.duration * track.rate).round());
        let here = self.time * rate;
        // What is within a thousandth of a frame stands on it.
        let from = if frames > 0 { (here + 1e-3).floor() } else { (here - 1e-3).ceil() };
        let to = from + f64::from(frames);
        let to = if self.repeat == Repeat::Off { to.clamp(0.0, last) } else { to.rem_euclid(last + 1.0) };
        self.time = (to / rate).min(self.duration());
    }

    /// Goes to the start of a clip, by its number; there is no such clip: nothing happens.
    pub fn choose(&mut self, clip: usize, clock: f64) {
        if clip < self.tracks.len() {
            self.clip = clip;
            self.set_time(0.0, clock);
        }
    }

    /// Goes to the clip so many further on, around the end.
    pub fn next(&mut self, by: i32, clock: f64) {
        if !self.tracks.is_empty() {
            self.choose((self.clip as i64 + i64::from(by)).rem_euclid(self.tracks.len() as i64) as usize, clock);
        }
    }

    pub fn set_speed(&mut self, speed: f64, clock: f64) {
        self.advance(clock);
        if speed.is_finite() {
            self.speed = speed.clamp(SPEED[0], SPEED[1]);
        }
        self.set_time(self.time, clock);
    }

    pub fn set_repeat(&mut self, repeat: Repeat) {
        // What was played until now was played the old way.
        self.set_time(self.time, self.clock);
        self.repeat = repeat;
    }
}
