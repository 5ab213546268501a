// Where in which clip an avatar stands.

/** Longest step between two frames, ms: after a pause nothing is skipped. */
const STEP = 250;

export class Playback {
  clip = 0; time = 0; playing = false; loop = true; rate = 1; #last = 0;

  /** From here on time passes. */
  start() { [this.playing, this.#last] = [true, 0]; }

  /** Moves on to `now`, ms, in a clip of so many seconds; says whether that ended it. */
  advance(now, length) {
    if (this.#last > 0) this.time += (this.rate * Math.min(now - this.#last, STEP)) / 1000;
    this.#last = now;
    if (this.time >= 0 && this.time <= length) return false;
    this.time = this.loop && length > 0 ? ((this.time % length) + length) % length : Math.min(Math.max(this.time, 0), length);
    return !this.loop;
  }
}
