// Avatars come: of several the last asked for, its neutral look first where the rest takes a while.
import { isBroken, told } from "./core.js";
import { Early } from "./early.js";
import { aborted, bytesOf } from "./source.js";

/**
 * What a loader asks of the one it loads for: `open()` throws where nothing can be shown any more, `ready()` is kept once there is a device,
 * `lost()` says whether there is none, `stage()` is fitted to its canvas, `save()` gives what `revert` takes, `arrived(ticket, frame)` is
 * told that another avatar is there, `completed()` that it has all of its file.
 */
export class Loader {
  #host; #ticket = 0; #abort;
  /** What is under way: its ticket, and a promise that is kept once something of it is shown. */
  loading;

  constructor(host) { this.#host = host; }

  stop(why) { this.#abort?.abort(aborted(why)); }

  async load(source, { onProgress, signal, frame = true } = {}) {
    const abort = new AbortController(), loading = { ticket: ++this.#ticket };
    this.stop("another avatar was asked for");
    this.#abort = abort;
    if (signal?.aborted) abort.abort(signal.reason);
    signal?.addEventListener("abort", () => abort.abort(signal.reason), { once: true });
    loading.shown = new Promise((resolve, reject) => Object.assign(loading, { resolve, reject }));
    loading.shown.catch(() => {});
    this.loading = loading;
    try {
      await this.#bring(source, onProgress, abort.signal, loading, frame);
    } catch (error) {
      loading.reject(error);
      throw told(error);
    } finally {
      if (this.loading === loading) this.loading = undefined;
    }
  }

  async #bring(source, onProgress, signal, loading, frame) {
    let before;
    const arrived = () => {
      this.#host.arrived(loading.ticket, frame);
      loading.resolve();
    };
    const early = new Early(async (bytes, total) => {
      while (!(await this.#replace((stage) => stage.prepare_neutral(bytes, total), signal, true)));
      before = this.#host.save();
      arrived();
      return true;
    });
    try {
      const bytes = await bytesOf(source, onProgress, signal, (...came) => early.came(...came));
      if (await early.shown) {
        this.#host.open();
        signal.throwIfAborted();
        this.#host.stage().complete(bytes);
        return this.#host.completed();
      }
      while (!(await this.#replace((stage) => stage.prepare(bytes), signal, false)));
      arrived();
    } catch (error) {
      await early.shown;
      if (before && !isBroken()) this.#host.revert(loading.ticket, before);
      throw error;
    }
  }

  /** Shows what is prepared; false where the device was lost on the way. `keep`: what was shown may come back. */
  async #replace(prepare, signal, keep) {
    await this.#host.ready();
    this.#host.open();
    signal.throwIfAborted();
    let candidate;
    try {
      candidate = prepare(this.#host.stage());
      // The browser hands on what was asked of the device: it compiles while this thread fills the buffers.
      await null;
      this.#host.open();
      signal.throwIfAborted();
      await candidate.fill();
      this.#host.open();
      signal.throwIfAborted();
    } catch (error) {
      if (!isBroken() && !(error instanceof WebAssembly.RuntimeError)) candidate?.free();
      if (isBroken() || !this.#host.lost()) throw error;
      return false;
    }
    return this.#host.stage().show(candidate, keep);
  }
}
