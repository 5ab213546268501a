// An avatar is shown as soon as it can be drawn at all, where the rest of its file takes a while longer.
import { neutral_needs } from "./effigy_core.js";

/** The rest comes soon enough, ms. */
const SOON = 300;
/** What surely holds a file's header, bytes. */
const HEAD = (256 << 10) + 8;

export class Early {
  #begin; #needs = 8; #since = performance.now();
  /** Whether it was shown, once that is known. */
  shown = Promise.resolve(false);

  /** `begin` is handed the bytes that are enough, and how many there will be; it tells whether it showed them. */
  constructor(begin) { this.#begin = begin; }

  /** Of `total` bytes so many have come. */
  came(bytes, loaded, total) {
    if (!total || loaded < this.#needs) return;
    try {
      this.#needs = neutral_needs(bytes.subarray(0, Math.min(loaded, HEAD)));
      const rest = ((total - loaded) * (performance.now() - this.#since)) / loaded;
      if (loaded < Math.max(this.#needs, HEAD) || rest <= SOON) return;
      const enough = bytes.slice(0, this.#needs);
      this.#needs = Infinity;
      this.shown = this.#begin(enough, total).catch(() => false);
    } catch {
      // What is wrong with the file is said when all of it is there.
      this.#needs = Infinity;
    }
  }
}
