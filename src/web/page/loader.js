// Loads avatars. Only the last one requested is shown, first without its correctives if the rest of
// its file takes a while.
import { readBytes } from "./download.js";
import { fileName, importAvatar, isOwn } from "./foreign.js";
import { isPanic, moduleFailure, pageError } from "./module.js";
import { Preview } from "./preview.js";
import { abortError } from "./validate.js";

/**
 * What a loader needs of the view that it loads for:
 * - `checkOpen()` throws if nothing can be shown any more.
 * - `deviceReady()` resolves once there is a device.
 * - `isDeviceLost()` returns whether there is none, and then asks for another.
 * - `fittedView()` returns the module's `AvatarCanvas`, with the size of its canvas.
 * - `saveState()` returns what `revert` needs.
 * - `avatarShown(ticket, frame)`: another avatar is shown. `frame`: the camera should show all of
 *   it.
 * - `avatarCompleted()`: the avatar has its correctives.
 * - `fileImported(name, notes)`: what is shown is a file of another program.
 * - `revert(ticket, state)` brings the avatar from before back, if `ticket` is still shown.
 *
 * @typedef {object} LoaderHost
 */

/** Avatars loaded one after the other. */
export class Loader {
  #host;
  #lastTicket = 0;
  #abort;
  /**
   * The request under way: its ticket, and a promise `shown` that resolves once something of it is
   * shown.
   */
  current;

  /** @param {LoaderHost} host */
  constructor(host) {
    this.#host = host;
  }

  /** Gives up the request under way. */
  stop(reason) {
    this.#abort?.abort(abortError(reason));
  }

  /** Loads an avatar and shows it. Gives up the request before. */
  async load(source, { onProgress, signal, frame = true } = {}) {
    const abort = new AbortController();
    this.stop("another avatar was requested");
    this.#abort = abort;
    if (signal?.aborted) abort.abort(signal.reason);
    signal?.addEventListener("abort", () => abort.abort(signal.reason), { once: true });

    this.#lastTicket += 1;
    const request = { ticket: this.#lastTicket, frame, onProgress, signal: abort.signal };
    request.shown = new Promise((resolve, reject) => {
      request.resolve = resolve;
      request.reject = reject;
    });
    // No one may be waiting for it: that is not an unhandled rejection.
    request.shown.catch(() => {});
    this.current = request;
    try {
      await this.#fetchAndShow(source, request);
    } catch (error) {
      request.reject(error);
      throw pageError(error);
    } finally {
      if (this.current === request) this.current = undefined;
    }
  }

  async #fetchAndShow(source, request) {
    let previousState;
    const preview = new Preview(async (beginning, total) => {
      await this.#show((view) => view.prepare_neutral(beginning, total), request, { keep: true });
      previousState = this.#host.saveState();
      this.#shown(request);
      return true;
    });
    try {
      const bytes = await readBytes(source, {
        onProgress: request.onProgress,
        signal: request.signal,
        onBytes: (bytes, loaded, total) => preview.onBytes(bytes, loaded, total),
      });
      if (await preview.shown) {
        this.#checkWanted(request);
        this.#host.fittedView().complete(bytes);
        this.#host.avatarCompleted();
        return;
      }
      if (isOwn(bytes)) {
        await this.#show((view) => view.prepare(bytes), request, { keep: false });
        this.#shown(request);
      } else {
        await this.#importAndShow(bytes, fileName(source), request);
      }
    } catch (error) {
      await preview.shown;
      if (previousState && !moduleFailure()) this.#host.revert(request.ticket, previousState);
      throw error;
    }
  }

  /** Shows the avatar of another program. */
  async #importAndShow(bytes, name, request) {
    // How long its reader takes is not known.
    request.onProgress?.(bytes.length);
    const avatar = await importAvatar(bytes, name, request.signal);
    const prepare = (view) =>
      avatar.isSplats ? view.prepare_splats(avatar.bytes) : view.prepare(avatar.bytes);
    await this.#show(prepare, request, { keep: false });
    this.#shown(request);
    this.#host.fileImported(name, avatar.notes);
  }

  #shown(request) {
    this.#host.avatarShown(request.ticket, request.frame);
    request.resolve();
  }

  #checkWanted(request) {
    this.#host.checkOpen();
    request.signal.throwIfAborted();
  }

  /**
   * Shows the avatar that `prepare(view)` returns. If the device is lost meanwhile, tries again with
   * the next one. `keep`: the avatar that is shown now may come back.
   */
  async #show(prepare, request, { keep }) {
    let isShown = false;
    while (!isShown) isShown = await this.#tryToShow(prepare, request, keep);
  }

  /** Returns false if the device was lost meanwhile. */
  async #tryToShow(prepare, request, keep) {
    await this.#host.deviceReady();
    this.#checkWanted(request);
    let candidate;
    try {
      candidate = prepare(this.#host.fittedView());
      // This lets the browser pass on the device's commands: it compiles the shaders while this
      // thread fills the buffers.
      await null;
      this.#checkWanted(request);
      await candidate.upload();
      this.#checkWanted(request);
    } catch (error) {
      if (!moduleFailure() && !isPanic(error)) candidate?.free();
      if (moduleFailure() || !this.#host.isDeviceLost()) throw error;
      return false;
    }
    return this.#host.fittedView().show(candidate, keep);
  }
}
