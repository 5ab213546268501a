// A lost device is opened again: with pauses where that fails, and not for ever where it is lost again and again.
import { Screen } from "./effigy_core.js";

/** Losses in a minute that are made good. */
const LOSSES = 4;
/** First and last pause before a device is asked for again, ms. */
const PAUSES = [250, 4000];
const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

export class Devices {
  #canvas; #lost; #losses = [];

  /** `lost` is called when a device is, whoever lost it. */
  constructor(canvas, lost) { [this.#canvas, this.#lost] = [canvas, lost]; }

  /** What was lost before counts no more. */
  forgive() { this.#losses = []; }

  follow(screen) {
    screen.lost().then(this.#lost);
    return screen;
  }

  /** Hands another device to `adopt`, after which it is that one's; throws where there is none. `wanted` says whether it still is. */
  async reopen(adopt, wanted) {
    const now = performance.now();
    this.#losses = this.#losses.filter((at) => now - at < 60_000);
    if (this.#losses.push(now) > LOSSES) throw new Error(`the device was lost ${LOSSES + 1} times in a minute: load the avatar again to go on`);
    for (let pause = PAUSES[0]; wanted(); pause *= 2) {
      try {
        const screen = await Screen.open(this.#canvas);
        if (wanted()) adopt(this.follow(screen));
        else screen.close();
        return;
      } catch (error) {
        if (error instanceof WebAssembly.RuntimeError || pause > PAUSES[1]) throw error;
        await sleep(pause);
      }
    }
  }
}
