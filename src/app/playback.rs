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

/// Plays one of several clips. Times of the clock are seconds that only rise.
///
/// While it plays, the position is worked out from when playing began, never summed up over frames, so it does not drift.
#[derive(Clone, Debug)]
pub struct Playback {
    tracks: Vec<Track>,
    clip: usize,
    time: f64,
    speed: f64,
    repeat: Repeat,
    /// The clock, and the clip's position at that time; None while paused.
    since: Option<(f64, f64)>,
}

impl Playback {
    /// Starts paused at the beginning of the first clip. Without any clip there is one moment.
    pub fn new(tracks: Vec<Track>) -> Self {
        Self { tracks, clip: 0, time: 0.0, speed: 1.0, repeat: Repeat::default(), since: None }
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
        self.since.is_some()
    }

    /// The moment changes without anyone's doing: frames have to be drawn.
    pub fn is_moving(&self) -> bool {
        self.is_playing() && self.duration() > 0.0
    }

    /// Moves on to the clock's time.
    pub fn advance(&mut self, clock: f64) -> Moment {
        if let Some((began, from)) = self.since
            && self.duration() > 0.0
        {
            self.time = from + (clock - began).max(0.0) * self.speed;
            if self.time >= self.duration() {
                self.end(clock);
            }
        }
        self.moment()
    }

    /// The clip's end has been reached.
    fn end(&mut self, clock: f64) {
        match self.repeat {
            Repeat::Off => {
                self.time = self.duration();
                self.since = None;
            }
            Repeat::Clip => self.set_time(self.time % self.duration(), clock),
            Repeat::All => {
                let all: f64 = self.tracks.iter().map(|track| track.duration).sum();
                let mut over = (self.time - self.duration()) % all;
                loop {
                    self.clip = (self.clip + 1) % self.tracks.len();
                    if over < self.duration() {
                        break;
                    }
                    over -= self.duration();
                }
                self.set_time(over, clock);
            }
        }
    }

    fn set_time(&mut self, time: f64, clock: f64) {
        self.time = time;
        self.since = self.since.map(|_| (clock, time));
    }

    /// Plays or pauses. Playing from the end of a clip that does not repeat begins it again.
    pub fn play(&mut self, play: bool, clock: f64) {
        self.advance(clock);
        if play && self.repeat == Repeat::Off && self.time >= self.duration() {
            self.time = 0.0;
        }
        self.since = play.then_some((clock, self.time));
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
        self.repeat = repeat;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn playing(durations: &[f64], repeat: Repeat) -> Playback {
        let track = |(i, &duration)| Track { name: format!("clip {i}"), duration, rate: 30.0 };
        let mut playback = Playback::new(durations.iter().enumerate().map(track).collect());
        playback.set_repeat(repeat);
        playback.play(true, 0.0);
        playback
    }

    #[test]
    fn ten_hours_of_playing_do_not_drift() {
        let mut playback = playing(&[3.1], Repeat::Clip);
        let frame = 1.0 / 59.94;
        let mut clock = 0.0;
        for i in 0..2_000_000_u32 {
            clock = f64::from(i) * frame;
            playback.advance(clock);
        }
        let expected = clock % 3.1;
        let got = playback.moment().time;
        let off = (got - expected).abs();
        assert!(off.min(3.1 - off) < 1e-6, "{got} instead of {expected} after {clock} s");
    }

    #[test]
    fn speed_changes_without_a_jump() {
        let mut playback = playing(&[100.0], Repeat::Clip);
        playback.advance(10.0);
        playback.set_speed(0.5, 10.0);
        assert_eq!(playback.advance(10.0).time, 10.0);
        assert_eq!(playback.advance(14.0).time, 12.0);
        playback.set_speed(1e9, 14.0);
        assert_eq!(playback.speed(), SPEED[1]);
        playback.set_speed(f64::NAN, 14.0);
        assert_eq!(playback.speed(), SPEED[1]);
    }

    #[test]
    fn a_clip_that_does_not_repeat_stops_at_its_end_and_can_be_played_again() {
        let mut playback = playing(&[2.0], Repeat::Off);
        assert_eq!(playback.advance(5.0).time, 2.0);
        assert!(!playback.is_playing() && !playback.is_moving());
        playback.play(true, 9.0);
        assert_eq!(playback.advance(9.5).time, 0.5);
    }

    #[test]
    fn all_clips_follow_one_another_and_the_time_left_over_is_not_lost() {
        let mut playback = playing(&[1.0, 0.0, 2.0], Repeat::All);
        assert_eq!(playback.advance(1.25), Moment { clip: 2, time: 0.25 });
        assert_eq!(playback.advance(3.5), Moment { clip: 0, time: 0.5 });
        assert_eq!(playback.advance(3.5 + 3000.0), Moment { clip: 0, time: 0.5 });
        assert_eq!(playback.advance(3.5 + 3001.0), Moment { clip: 2, time: 0.5 });
    }

    #[test]
    fn a_paused_clip_and_a_single_pose_do_not_move() {
        let mut playback = playing(&[2.0, 0.0], Repeat::All);
        playback.play(false, 0.5);
        assert_eq!(playback.advance(100.0).time, 0.5);
        assert!(!playback.is_moving());
        playback.next(1, 100.0);
        playback.play(true, 100.0);
        assert!(!playback.is_moving());
        assert_eq!(playback.advance(200.0), Moment { clip: 1, time: 0.0 });
        let mut empty = playing(&[], Repeat::All);
        empty.next(1, 1.0);
        empty.step(1, 1.0);
        empty.scrub(1.0, 1.0);
        assert_eq!(empty.advance(2.0), Moment { clip: 0, time: 0.0 });
    }

    #[test]
    fn stepping_goes_from_frame_to_frame() {
        let mut playback = playing(&[2.0], Repeat::Clip);
        playback.advance(0.51);
        playback.step(1, 0.51);
        assert!(!playback.is_playing());
        let frame = |playback: &Playback| (playback.moment().time * 30.0 * 1e6).round() / 1e6;
        assert_eq!(frame(&playback), 16.0);
        playback.step(-1, 0.6);
        assert_eq!(frame(&playback), 15.0);
        playback.step(-16, 0.6);
        assert_eq!(frame(&playback), 60.0, "before the first frame comes the last");
        playback.step(1, 0.6);
        assert_eq!(frame(&playback), 0.0);
    }

    #[test]
    fn scrubbing_goes_round_the_ends_only_where_the_clip_repeats() {
        let mut playback = playing(&[4.0], Repeat::Clip);
        playback.scrub(-1.0, 0.0);
        assert_eq!(playback.moment().time, 3.0);
        assert_eq!(playback.advance(0.5).time, 3.5, "it plays on from there");
        playback.set_repeat(Repeat::Off);
        playback.scrub(9.0, 0.5);
        assert_eq!(playback.moment().time, 4.0);
        playback.seek(f64::NAN, 1.0);
        assert_eq!(playback.moment().time, 4.0);
    }

    #[test]
    fn next_and_previous_go_round() {
        let mut playback = playing(&[1.0, 1.0, 1.0], Repeat::Clip);
        playback.advance(0.7);
        playback.next(-1, 0.7);
        assert_eq!(playback.moment(), Moment { clip: 2, time: 0.0 });
        playback.next(1, 0.8);
        assert_eq!(playback.advance(1.0).clip, 0);
        playback.choose(17, 1.0);
        assert_eq!(playback.moment().clip, 0);
    }
}
