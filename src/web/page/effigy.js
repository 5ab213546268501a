// An avatar in a page:
//
//     const effigy = await Effigy.create(canvas);
//     await effigy.loadAvatar("demo.avatar");
//
// effigy.d.ts describes all of it.
import { DEFAULT_CAMERA, checkedCamera, fitCanvas, framing } from "./camera.js";
import { DeviceRecovery } from "./device_recovery.js";
import { readBytes } from "./download.js";
import { AvatarCanvas, DrawingOptions, Drawn } from "./effigy_core.js";
import { fileName, importMotion, isOwn, kindOf } from "./foreign.js";
import { FrameTimes } from "./frame_times.js";
import { Loader } from "./loader.js";
import {
  Unsupported,
  isSupported,
  loadModule,
  moduleFailure,
  openSurface,
  pageError,
} from "./module.js";
import { Playback } from "./playback.js";
import { Screenshots } from "./screenshots.js";
import { abortError, checkedNumber } from "./validate.js";
import { Visibility } from "./visibility.js";

export { Unsupported, isSupported, kindOf };

const DISPOSED = "this avatar's canvas was disposed of";
/** A live pose is interpolated for this long, ms: frames are drawn meanwhile. */
const LIVE_POSE_MS = 300;
/** Pause before a frame for a screenshot of a canvas that can't be seen, ms. */
const UNSEEN_FRAME_MS = 20;

const toFloat32 = (list) => (list instanceof Float32Array ? list : Float32Array.from(list));

export class Effigy extends EventTarget {
  #canvas;
  #maxPixelRatio;
  /** The device's limit for a canvas, px a side. */
  #maxSide = 8192;
  /** The module's AvatarCanvas. */
  #view;
  #camera;
  #description = {};
  /** The ticket of the avatar that is shown; 0 if there is none. */
  #shownTicket = 0;
  /** The ticket of the last avatar that was given what its first frame did without. */
  #completedTicket = 0;
  #playback = new Playback();
  /** When the last live pose came, ms; 0 if a clip is shown. */
  #livePoseAt = 0;

  // Frames.
  #frameRequest = 0;
  #timer = 0;
  #visibility;
  #frameTimes = new FrameTimes();
  #screenshots = new Screenshots();
  #disposed = false;
  /** The error that stopped drawing, until something changes. */
  #failure;

  // The device.
  #deviceRecovery;
  /** A promise that resolves once the lost device is replaced, or has been given up. */
  #recovery;
  /** The device was lost for good: only another avatar asks for a new one. */
  #deviceGivenUp = false;

  #loader = new Loader({
    checkOpen: () => this.#checkOpen(),
    deviceReady: () => this.#deviceReady(),
    isDeviceLost: () => this.#recoverIfLost(),
    fittedView: () => this.#fittedView(),
    saveState: () => this.#saveState(),
    avatarShown: (ticket, frame) => this.#avatarShown(ticket, frame),
    avatarCompleted: () => this.#avatarCompleted(),
    fileImported: (name, notes) => this.#fileImported(name, notes),
    revert: (ticket, state) => this.#revert(ticket, state),
  });

  // Created once, so that a frame creates no garbage.
  #frameEvent = new Event("frame");
  #onFrame = (now) => {
    this.#frameRequest = 0;
    this.#frame(now);
  };
  #onTimer = () => {
    this.#timer = 0;
    this.#frame(performance.now());
  };

  static async create(canvas, options = {}) {
    if (!isSupported()) throw new Unsupported();
    const effigy = new Effigy();
    effigy.#canvas = canvas;
    effigy.#maxPixelRatio = checkedNumber("maxPixelRatio", options.maxPixelRatio ?? 2, 0.01, 16);
    effigy.#camera = checkedCamera({ ...DEFAULT_CAMERA, ...options.camera });
    await loadModule();
    const { supersample = "auto", detail = "full" } = options;
    const drawing = new DrawingOptions(String(supersample), String(detail));
    effigy.#start(await openSurface(canvas), drawing);
    return effigy;
  }

  #start(surface, drawing) {
    this.#maxSide = surface.max_side();
    this.#fittedView();
    this.#deviceRecovery = new DeviceRecovery(this.#canvas, () => this.#recoverIfLost());
    this.#view = new AvatarCanvas(this.#deviceRecovery.watch(surface), drawing);
    this.#applyCamera();
    this.#visibility = new Visibility(this.#canvas, {
      onVisibility: () => this.#visibilityChanged(),
      onSize: () => this.#requestFrame(),
    });
    this.#requestFrame();
  }

  /** Throws if nothing can be drawn any more. */
  #checkOpen() {
    if (this.#disposed) throw new Error(DISPOSED);
    if (moduleFailure()) throw moduleFailure();
  }

  /** Calls the module, and turns its errors into ones for the page. */
  #call(act) {
    try {
      return act();
    } catch (error) {
      throw pageError(error);
    }
  }

  /** The view, with the size of its canvas. */
  #fittedView() {
    fitCanvas(this.#canvas, this.#maxPixelRatio, this.#maxSide);
    this.#view?.resize();
    return this.#view;
  }

  // Avatars and clips.

  async loadAvatar(source, options) {
    this.#checkOpen();
    await this.#loader.load(source, options);
    return this.description;
  }

  async loadMotion(source, { onProgress, signal, play = true } = {}) {
    this.#checkOpen();
    // The clip is for the avatar that is loading, if there is one.
    const request = this.#loader.current;
    const ticket = request ? request.ticket : this.#shownTicket;
    const bytes = await readBytes(source, { onProgress, signal });
    await request?.shown.catch(() => {
      throw abortError("the avatar that this clip was for could not be loaded");
    });
    const checkWanted = () => {
      this.#checkOpen();
      signal?.throwIfAborted();
      if (this.#shownTicket !== ticket) throw abortError("another avatar is shown by now");
    };
    checkWanted();
    const name = fileName(source);
    let clip = { bytes };
    if (!isOwn(bytes)) {
      // How long its reader takes is not known.
      onProgress?.(bytes.length);
      const body = this.#call(() => ({ skeleton: this.#view.skeleton(), skin: this.#view.skin() }));
      clip = await importMotion(bytes, name, body, signal);
      checkWanted();
    }
    const index = this.#call(() => this.#view.add_clip(clip.bytes));
    this.#describe();
    if (play) this.play(index);
    if (clip.notes) this.#fileImported(name, clip.notes);
    return index;
  }

  #saveState() {
    return { ticket: this.#shownTicket, playback: this.#playback, camera: this.#camera };
  }

  /** Another avatar is shown, without clips. */
  #avatarShown(ticket, frame) {
    const { playing, loop, rate } = this.#playback;
    this.#playback = Object.assign(new Playback(), { loop, rate });
    this.#shownTicket = ticket;
    this.#livePoseAt = 0;
    if (playing) this.pause();
    this.#describe();
    if (frame) this.frameAvatar();
    this.#changed();
  }

  #avatarCompleted() {
    this.#describe();
    this.#changed();
    this.#later(() => this.#view.add_levels());
  }

  #fileImported(name, notes) {
    this.dispatchEvent(new CustomEvent("import", { detail: { name, notes } }));
  }

  /** The rest of an avatar's file did not come: shows the avatar from before again. */
  #revert(ticket, state) {
    if (this.#disposed || this.#shownTicket !== ticket) return;
    this.#view.revert();
    this.#shownTicket = state.ticket;
    this.#playback = state.playback;
    this.#livePoseAt = 0;
    this.#describe();
    this.camera = state.camera;
    this.dispatchEvent(new Event(state.playback.playing ? "play" : "pause"));
  }

  #describe() {
    this.#description = JSON.parse(this.#call(() => this.#view.describe()));
  }

  get description() {
    return this.#description;
  }

  get clips() {
    return this.#description.clips ?? [];
  }

  // Playback and live poses.

  get clip() {
    return this.#playback.clip;
  }

  get duration() {
    return this.#description.clips?.[this.#playback.clip]?.duration ?? 0;
  }

  get playing() {
    return this.#playback.playing;
  }

  get time() {
    return this.#playback.time;
  }

  set time(seconds) {
    this.#checkOpen();
    this.#playback.time = checkedNumber("the time", seconds, -1e9, 1e9);
    this.#view.seek(this.clip, seconds);
    this.#livePoseAt = 0;
    this.#changed();
  }

  get loop() {
    return this.#playback.loop;
  }

  set loop(loop) {
    this.#playback.loop = Boolean(loop);
  }

  get rate() {
    return this.#playback.rate;
  }

  set rate(rate) {
    this.#playback.rate = checkedNumber("the rate", rate, -1000, 1000);
  }

  play(clip = this.clip) {
    this.#checkOpen();
    if (!(clip in this.clips)) {
      throw new RangeError(`there is no clip ${clip}: ${this.clips.length} are loaded`);
    }
    const fromStart = clip !== this.clip || (!this.loop && this.time >= this.duration);
    this.#playback.clip = clip;
    this.time = fromStart ? 0 : this.time;
    this.#playback.play();
    this.dispatchEvent(new Event("play"));
  }

  pause() {
    this.#playback.playing = false;
    this.dispatchEvent(new Event("pause"));
  }

  setPose({ rotation, translation = [0, 0, 0], expression = [] }) {
    this.#checkOpen();
    const now = performance.now();
    this.#call(() =>
      this.#view.set_pose(now, toFloat32(rotation), toFloat32(translation), toFloat32(expression)),
    );
    this.#livePoseAt = now;
    if (this.playing) this.pause();
    this.#changed();
  }

  // The view.

  get camera() {
    return { ...this.#camera, target: [...this.#camera.target] };
  }

  set camera(camera) {
    this.#checkOpen();
    this.#camera = checkedCamera({ ...this.#camera, ...camera });
    this.#applyCamera();
    this.#changed();
  }

  #applyCamera() {
    const { target, yaw, pitch, distance, fov } = this.#camera;
    this.#view.set_target(target[0], target[1], target[2]);
    this.#view.set_orbit(yaw, pitch, distance);
    this.#view.set_fov(fov);
  }

  frameAvatar() {
    this.#checkOpen();
    this.#describe();
    this.camera = framing(
      this.#description.bounds,
      this.#camera.fov,
      this.#canvas.width / this.#canvas.height,
      this.#description.stands,
    );
  }

  set projection(on) {
    this.#checkOpen();
    this.#view.set_projection(Boolean(on));
    this.#changed();
  }

  set background(color) {
    this.#checkOpen();
    const checked = (channel) => checkedNumber("the background", channel, 0, 1);
    const [red, green, blue] = Array.from(color, checked);
    this.#view.set_background(red, green, checked(blue));
    this.#changed();
  }

  get statistics() {
    const isDrawable = !this.#disposed && !moduleFailure();
    const ofModule = isDrawable ? JSON.parse(this.#view.statistics()) : {};
    return { ...this.#frameTimes.summary, ...ofModule };
  }

  async screenshot() {
    this.#checkOpen();
    if (this.#failure) throw this.#failure;
    if (!this.#shownTicket) {
      throw new Error("there is no avatar yet to take a screenshot of: load one first");
    }
    const screenshot = this.#screenshots.request();
    this.#view.redraw();
    this.#requestFrame();
    return screenshot;
  }

  dispose() {
    if (this.#disposed) return;
    this.#disposed = true;
    cancelAnimationFrame(this.#frameRequest);
    clearTimeout(this.#timer);
    this.#visibility.stop();
    this.#screenshots.reject(new Error(DISPOSED));
    this.#loader.stop(DISPOSED);
    if (moduleFailure()) return;
    this.#view.close_device();
    this.#view.free();
  }

  // Frames.

  /** Something has changed, so a frame that failed may now succeed. */
  #changed() {
    if (!this.#deviceGivenUp) this.#failure = undefined;
    this.#requestFrame();
  }

  #visibilityChanged() {
    // The browser may never call for a frame of a canvas that can't be seen, but a screenshot must
    // not wait for that.
    cancelAnimationFrame(this.#frameRequest);
    this.#frameRequest = 0;
    this.#frameTimes.startPause();
    this.#requestFrame();
  }

  #canDraw() {
    return !this.#disposed && !this.#recovery && !this.#failure && !moduleFailure();
  }

  #requestFrame() {
    const isRequested = this.#frameRequest || this.#timer;
    if (isRequested || !this.#canDraw()) return;
    this.#frameTimes.wake();
    if (this.#visibility.isVisible) {
      this.#frameRequest = requestAnimationFrame(this.#onFrame);
    } else if (this.#screenshots.areWanted) {
      this.#timer = setTimeout(this.#onTimer, UNSEEN_FRAME_MS);
    }
  }

  #frame(now) {
    if (!this.#canDraw()) return;
    if (!this.#visibility.isVisible && !this.#screenshots.areWanted) return;
    try {
      if (!this.#recoverIfLost()) this.#draw(now);
    } catch (error) {
      const failure = pageError(error);
      if (moduleFailure() || !this.#recoverIfLost()) this.#fail(failure);
    }
  }

  #draw(now) {
    this.#fittedView();
    if (this.playing) this.#advance(now);
    // A listener of `pause` may have disposed of it.
    if (this.#disposed) return;
    const drawn = this.#view.draw(performance.now());
    if (drawn === Drawn.Frame) {
      this.#frameTimes.frameDrawn(now);
      if (this.#screenshots.areWanted) this.#screenshots.take(this.#canvas);
      if (this.#shownTicket !== this.#completedTicket) this.#completeLater();
      this.dispatchEvent(this.#frameEvent);
    } else if (drawn === Drawn.Nothing) {
      this.#frameTimes.startPause();
    }
    const isLive = now - this.#livePoseAt < LIVE_POSE_MS;
    if (this.playing || isLive || drawn === Drawn.Later) this.#requestFrame();
    if (!this.#frameRequest) this.#frameTimes.rest();
  }

  /** Gives an avatar its levels of detail while the device draws its first frame. */
  #completeLater() {
    this.#completedTicket = this.#shownTicket;
    this.#later(() => this.#view.add_levels());
  }

  /** Calls the module once what waits has been done, for what frames can do without. */
  #later(act) {
    setTimeout(() => {
      if (!this.#canDraw()) return;
      try {
        this.#call(act);
        this.#requestFrame();
      } catch (error) {
        if (moduleFailure()) this.#fail(error);
        else if (!this.#recoverIfLost()) console.warn(`Effigy draws without it: ${error.message}`);
      }
    });
  }

  #advance(now) {
    if (this.#playback.advance(now, this.duration)) this.pause();
    if (!this.#disposed) this.#view.seek(this.clip, this.time);
  }

  /** Stops drawing until something changes. */
  #fail(error) {
    this.#failure = error;
    this.#screenshots.reject(error);
    this.dispatchEvent(new CustomEvent("error", { detail: error }));
  }

  // The device.

  loseDevice() {
    this.#checkOpen();
    this.#view.close_device();
  }

  /** Resolves once there is a device. Asks again for one that was given up. */
  async #deviceReady() {
    if (this.#deviceGivenUp) {
      this.#deviceGivenUp = false;
      this.#failure = undefined;
      this.#deviceRecovery.forgive();
      this.#recoverIfLost();
    }
    await this.#recovery;
    if (this.#deviceGivenUp) throw this.#failure;
  }

  /** Returns whether the device is lost. Then it asks for another one. */
  #recoverIfLost() {
    if (this.#disposed || moduleFailure() || !this.#view?.is_lost()) return false;
    if (!this.#deviceGivenUp) this.#recovery ??= this.#recover();
    return true;
  }

  async #recover() {
    this.dispatchEvent(new Event("lost"));
    const replace = (surface) => {
      this.#maxSide = surface.max_side();
      this.#view.replace_device(surface);
      this.dispatchEvent(new Event("restored"));
    };
    try {
      await this.#deviceRecovery.reopen(replace, () => !this.#disposed);
    } catch (error) {
      this.#deviceGivenUp = true;
      if (!this.#disposed) this.#fail(pageError(error));
    } finally {
      this.#recovery = undefined;
      this.#requestFrame();
    }
  }
}
