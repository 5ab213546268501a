// Shows an avatar without its correctives while the rest of its file is still loading.
import { neutral_needs } from "./effigy_core.js";

/** No preview if the rest is expected within this time, ms. */
const SOON_MS = 300;
/** Enough for the header of a file, bytes. */
const HEADER_BYTES = (256 << 10) + 8;

export class Preview {
  #show;
  #neededBytes = 8;
  #since = performance.now();
  /** Resolves with whether the preview was shown. */
  shown = Promise.resolve(false);

  /**
   * `show(bytes, total)` is called with the beginning of the file, and its length. It returns a
   * promise of whether it has shown the avatar.
   */
  constructor(show) {
    this.#show = show;
  }

  /** `loaded` of `total` bytes have arrived. */
  onBytes(bytes, loaded, total) {
    if (!total || loaded < this.#neededBytes) return;
    try {
      this.#neededBytes = neutral_needs(bytes.subarray(0, Math.min(loaded, HEADER_BYTES)));
      const elapsed = performance.now() - this.#since;
      const remaining = ((total - loaded) * elapsed) / loaded;
      const isReady = loaded >= Math.max(this.#neededBytes, HEADER_BYTES);
      if (!isReady || remaining <= SOON_MS) return;
      const beginning = bytes.slice(0, this.#neededBytes);
      this.#neededBytes = Infinity;
      this.shown = this.#show(beginning, total).catch(() => false);
    } catch {
      // A broken file is reported once all of it has arrived.
      this.#neededBytes = Infinity;
    }
  }
}
