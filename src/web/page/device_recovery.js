// Replaces a lost device: with pauses if that fails, and only a few times a minute.
import { CanvasSurface } from "./effigy_core.js";
import { isPanic } from "./module.js";

/** Losses in a minute after which a device is replaced. */
const MAX_LOSSES = 4;
const MINUTE_MS = 60_000;
/** First and last pause before another attempt. */
const FIRST_PAUSE_MS = 250;
const LAST_PAUSE_MS = 4000;

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

export class DeviceRecovery {
  #canvas;
  #onLost;
  /** When devices were lost, ms. */
  #losses = [];

  /** `onLost` is called when a watched device is lost, on purpose or not. */
  constructor(canvas, onLost) {
    this.#canvas = canvas;
    this.#onLost = onLost;
  }

  /** Forgets earlier losses. */
  forgive() {
    this.#losses = [];
  }

  /** Watches a surface's device. Returns the surface. */
  watch(surface) {
    surface.lost().then(this.#onLost);
    return surface;
  }

  /**
   * Opens another device and passes its surface to `replace`, which owns it from then on. Gives up
   * quietly once `isWanted` returns false. Throws if no device can be opened.
   */
  async reopen(replace, isWanted) {
    const now = performance.now();
    this.#losses = this.#losses.filter((lost) => now - lost < MINUTE_MS);
    this.#losses.push(now);
    if (this.#losses.length > MAX_LOSSES) {
      throw new Error(
        `the device was lost ${MAX_LOSSES + 1} times in a minute: load the avatar again to go on`,
      );
    }
    for (let pause = FIRST_PAUSE_MS; isWanted(); pause *= 2) {
      try {
        const surface = await CanvasSurface.open(this.#canvas);
        if (isWanted()) replace(this.watch(surface));
        else surface.close();
        return;
      } catch (error) {
        if (isPanic(error) || pause > LAST_PAUSE_MS) throw error;
        await sleep(pause);
      }
    }
  }
}
