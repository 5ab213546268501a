// Times from one frame to the next. Pauses in which nothing had to be drawn do not count.

/** Frames that the statistics cover. */
const HISTORY = 240;
/** A request for a frame that comes this long after the last one starts a new series, ms. */
const PAUSE_MS = 50;

export class FrameTimes {
  #history = new Float64Array(HISTORY);
  #count = 0;
  /** When the last frame was drawn, ms; 0 after a pause. */
  #lastFrame = 0;
  /** Since when no frame is requested, ms; 0 while one is. */
  #restingSince = 0;

  /** A frame was drawn at `now`, ms. */
  frameDrawn(now) {
    if (this.#lastFrame > 0) {
      this.#history[this.#count % HISTORY] = now - this.#lastFrame;
      ++this.#count;
    }
    this.#lastFrame = now;
  }

  /** No frame is requested from now on. */
  rest() {
    this.#restingSince = performance.now();
  }

  /** A frame is requested. */
  wake() {
    const isPause = this.#restingSince > 0 && performance.now() - this.#restingSince > PAUSE_MS;
    if (isPause) this.startPause();
    this.#restingSince = 0;
  }

  /** Nothing had to be drawn, or no one could see it. */
  startPause() {
    this.#lastFrame = 0;
  }

  /** Median and 95th percentile of the last frames, ms, and their mean rate. */
  get summary() {
    const times = this.#history.slice(0, this.#count).sort();
    const percentile = (share) => times[Math.floor(share * (times.length - 1))];
    const mean = times.reduce((sum, time) => sum + time, 0) / times.length;
    return {
      frameMs: percentile(0.5),
      p95Ms: percentile(0.95),
      fps: mean > 0 ? 1000 / mean : 0,
    };
  }
}
