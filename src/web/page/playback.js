// Which clip plays, and at which time of it.

/** Longest time that a clip moves on in one frame, ms: after a pause nothing is skipped. */
const MAX_STEP_MS = 250;

export class Playback {
  clip = 0;
  /** Into the clip, seconds. */
  time = 0;
  playing = false;
  loop = true;
  /** Speed: 1 is as captured, negative is backwards. */
  rate = 1;
  /** When the last frame was drawn, ms; 0 before the first one. */
  #lastFrame = 0;

  play() {
    this.playing = true;
    this.#lastFrame = 0;
  }

  /** Moves on to `now`, ms, in a clip of `duration` seconds. Returns whether the clip has ended. */
  advance(now, duration) {
    if (this.#lastFrame > 0) {
      const elapsed = Math.min(now - this.#lastFrame, MAX_STEP_MS);
      this.time += (this.rate * elapsed) / 1000;
    }
    this.#lastFrame = now;
    if (this.time >= 0 && this.time <= duration) return false;
    if (this.loop && duration > 0) {
      this.time = ((this.time % duration) + duration) % duration;
    } else {
      this.time = Math.min(Math.max(this.time, 0), duration);
    }
    return !this.loop;
  }
}
