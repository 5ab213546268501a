// Times from frame to frame. What lies between two frames because nothing had to be drawn is none.

/** After so long without a frame to draw nobody waited for one, ms. */
const IDLE = 50;

export class Times {
  #ms = new Float64Array(240); #count = 0; #drawn = 0; #rested = 0;

  /** A frame was drawn at `now`, ms. */
  drew(now) {
    if (this.#drawn > 0) this.#ms[this.#count++ % this.#ms.length] = now - this.#drawn;
    this.#drawn = now;
  }

  /** No frame is asked for from now on. */
  rest() { this.#rested = performance.now(); }

  /** One is asked for. */
  wake() {
    if (this.#rested > 0 && performance.now() - this.#rested > IDLE) this.#drawn = 0;
    this.#rested = 0;
  }

  /** Nothing was to be drawn, or nobody could have seen it. */
  idle() { this.#drawn = 0; }

  get summary() {
    const times = this.#ms.slice(0, this.#count).sort(), at = (share) => times[Math.floor(share * (times.length - 1))];
    const mean = times.reduce((sum, time) => sum + time, 0) / times.length;
    return { frameMs: at(0.5), p95Ms: at(0.95), fps: mean > 0 ? 1000 / mean : 0 };
  }
}
