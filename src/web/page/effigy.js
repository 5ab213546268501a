// Effigy in a page: `const effigy = await Effigy.create(canvas); await effigy.loadAvatar("demo.avatar");`. effigy.d.ts says all of it.
import { Drawn, Stage } from "./effigy_core.js";
import { firstScreen, isBroken, loaded, told, Unsupported } from "./core.js";
import { Devices } from "./devices.js";
import { Playback } from "./playback.js";
import { aborted, bytesOf, within } from "./source.js";
import { Times } from "./times.js";
import { VIEW, checkedCamera, fit, framing } from "./view.js";
import { Watched } from "./watched.js";

export { Unsupported };

/** Whether this browser can draw at all. */
export const isSupported = () => "gpu" in navigator;

export class Effigy extends EventTarget {
  #stage; #canvas; #pixels; #longest = 8192; #camera; #described = {}; #disposed = false;
  #playback = new Playback(); #live = 0;
  #request = 0; #timer = 0; #watched; #times = new Times(); #shots = []; #drew = new Event("frame");
  // The last avatar asked for, the one that is shown, and what is under way.
  #ticket = 0; #shown = 0; #loading; #abort;
  #devices; #recovery; #failed; #gone = false;

  // Bound once: a frame makes no functions.
  #onFrame = (now) => { this.#request = 0; this.#frame(now); };
  #onTimer = () => { this.#timer = 0; this.#frame(performance.now()); };

  /** Makes a device for a canvas that nothing else draws on. The canvas's size on the page decides its pixels. */
  static async create(canvas, options = {}) {
    if (!isSupported()) throw new Unsupported();
    const effigy = new Effigy();
    effigy.#canvas = canvas;
    effigy.#pixels = within("maxPixelRatio", options.maxPixelRatio ?? 2, 0.01, 16);
    effigy.#camera = checkedCamera({ ...VIEW, ...options.camera });
    await loaded();
    effigy.#begin(await firstScreen(canvas));
    return effigy;
  }

  #begin(screen) {
    this.#longest = screen.longest();
    this.#fit();
    this.#devices = new Devices(this.#canvas, () => this.#recover());
    this.#stage = new Stage(this.#devices.follow(screen));
    this.#look();
    this.#watched = new Watched(this.#canvas, (seen) => {
      if (seen) this.#times.idle();
      this.#wake();
    });
    this.#wake();
  }

  /** Takes an avatar from a URL, a File or bytes. Where that fails the old one stays; of several the last asked for is shown. */
  async loadAvatar(source, { onProgress, signal, frame = true } = {}) {
    this.#open();
    const ticket = ++this.#ticket, abort = new AbortController(), before = this.#abort;
    this.#abort = abort;
    before?.abort(aborted("another avatar was asked for"));
    if (signal?.aborted) abort.abort(signal.reason);
    signal?.addEventListener("abort", () => abort.abort(signal.reason), { once: true });
    const shown = this.#bring(source, { onProgress, signal: abort.signal, frame }, ticket);
    const loading = this.#loading = { ticket, shown };
    try {
      await shown;
      return this.description;
    } catch (error) {
      throw told(error);
    } finally {
      if (this.#loading === loading) this.#loading = undefined;
    }
  }

  async #bring(source, { onProgress, signal, frame }, ticket) {
    const bytes = await bytesOf(source, onProgress, signal);
    if (this.#gone) {
      [this.#gone, this.#failed] = [false, undefined];
      this.#devices.forgive();
      this.#recover();
    }
    while (!(await this.#replace(bytes, signal)));
    [this.#shown, this.#live, this.#failed] = [ticket, 0, undefined];
    const { playing } = this.#playback;
    this.#playback.reset();
    if (playing) this.pause();
    this.#describe();
    if (frame) this.frameAvatar();
    this.#wake();
  }

  /** Shows what is in some bytes; false where the device was lost on the way. */
  async #replace(bytes, signal) {
    await this.#recovery;
    this.#open();
    signal.throwIfAborted();
    if (this.#gone) throw this.#failed;
    let candidate;
    try {
      this.#fit();
      this.#stage.resize();
      candidate = this.#stage.prepare(bytes);
      await candidate.made();
      this.#open();
      signal.throwIfAborted();
    } catch (error) {
      if (!isBroken() && !(error instanceof WebAssembly.RuntimeError)) candidate?.free();
      if (this.#disposed || !this.#recover()) throw error;
      return false;
    }
    return this.#stage.show(candidate);
  }

  /** Adds a clip from a URL, a File or bytes to the avatar asked for last, and plays it. Gives its number. */
  async loadMotion(source, { onProgress, signal, play = true } = {}) {
    this.#open();
    const ticket = this.#loading?.ticket ?? this.#shown, avatar = this.#loading?.shown;
    const bytes = await bytesOf(source, onProgress, signal);
    await avatar?.catch(() => { throw aborted("the avatar that this clip was for is not there"); });
    this.#open();
    signal?.throwIfAborted();
    if (this.#shown !== ticket) throw aborted("another avatar has come meanwhile");
    const number = this.#call(() => this.#stage.add_clip(bytes));
    this.#describe();
    if (play) this.play(number);
    return number;
  }

  #open() {
    if (this.#disposed) throw new Error("this avatar's canvas was disposed of");
    if (isBroken()) throw isBroken();
  }
  #call(act) { try { return act(); } catch (error) { throw told(error); } }
  #describe() { this.#described = JSON.parse(this.#call(() => this.#stage.describe())); }

  get description() { return this.#described; }
  get clips() { return this.#described.clips ?? []; }
  get clip() { return this.#playback.clip; }
  get duration() { return this.#described.clips?.[this.#playback.clip]?.duration ?? 0; }
  get playing() { return this.#playback.playing; }
  get time() { return this.#playback.time; }
  set time(seconds) {
    this.#open();
    this.#playback.time = within("the time", seconds, -1e9, 1e9);
    this.#stage.seek(this.clip, seconds);
    this.#live = 0;
    this.#changed();
  }
  get loop() { return this.#playback.loop; }
  set loop(loop) { this.#playback.loop = Boolean(loop); }
  get rate() { return this.#playback.rate; }
  set rate(rate) { this.#playback.rate = within("the rate", rate, -1000, 1000); }

  /** Plays a clip from where it stands, or another from its start. */
  play(clip = this.clip) {
    this.#open();
    if (!(clip in this.clips)) throw new RangeError(`there is no clip ${clip}: ${this.clips.length} are loaded`);
    const again = clip !== this.clip || (!this.loop && this.time >= this.duration);
    this.#playback.clip = clip;
    this.time = again ? 0 : this.time;
    this.#playback.start();
    this.dispatchEvent(new Event("play"));
  }

  pause() {
    this.#playback.playing = false;
    this.dispatchEvent(new Event("pause"));
  }

  /** Drives the avatar live, at any rate: three numbers a joint, in the order of `description.joints`. */
  setPose({ rotation, translation = [0, 0, 0], expression = [] }) {
    this.#open();
    const numbers = (list) => (list instanceof Float32Array ? list : Float32Array.from(list)), now = performance.now();
    this.#call(() => this.#stage.set_pose(now, numbers(rotation), numbers(translation), numbers(expression)));
    this.#live = now;
    if (this.playing) this.pause();
    this.#changed();
  }

  get camera() { return { ...this.#camera, target: [...this.#camera.target] }; }
  set camera(camera) {
    this.#open();
    this.#camera = checkedCamera({ ...this.#camera, ...camera });
    this.#look();
    this.#changed();
  }
  #look() {
    const { target: [x, y, z], yaw, pitch, distance, fov } = this.#camera;
    this.#stage.set_camera(x, y, z, yaw, pitch, distance, fov);
  }

  /** Looks at all of the avatar. */
  frameAvatar() {
    this.#open();
    this.#describe();
    const bounds = this.#described.bounds ?? [[-0.5, 0, -0.5], [0.5, 1.8, 0.5]];
    this.camera = framing(bounds, this.#camera.fov, this.#canvas.width / this.#canvas.height);
  }

  /** What lies behind: three numbers from 0 to 1. */
  set background(color) {
    this.#open();
    const [red, green, blue] = Array.from(color, (channel) => within("the background", channel, 0, 1));
    this.#stage.set_background(red, green, within("the background", blue, 0, 1));
    this.#changed();
  }

  /** Frames a second and times, ms, of the last frames drawn, and what the last one was made of. */
  get statistics() {
    const core = this.#disposed || isBroken() ? {} : JSON.parse(this.#stage.statistics());
    return { ...this.#times.summary, ...core };
  }

  /** The canvas as a PNG. */
  screenshot() {
    return new Promise((resolve, reject) => {
      this.#open();
      if (this.#failed) throw this.#failed;
      if (!this.#shown) throw new Error("there is no avatar yet to take a picture of: load one first");
      this.#shots.push({ resolve, reject });
      this.#stage.redraw();
      this.#wake();
    });
  }
  #shoot() {
    const shots = this.#shots.splice(0);
    const missing = new Error("the browser made no picture of the canvas");
    this.#canvas.toBlob((blob) => shots.forEach(({ resolve, reject }) => (blob ? resolve(blob) : reject(missing))));
  }

  /** For tests: loses the device, which is then opened again. */
  loseDevice() {
    this.#open();
    this.#stage.lose();
  }

  dispose() {
    if (this.#disposed) return;
    this.#disposed = true;
    cancelAnimationFrame(this.#request);
    clearTimeout(this.#timer);
    this.#watched.stop();
    const error = new Error("this avatar's canvas was disposed of");
    this.#shots.splice(0).forEach(({ reject }) => reject(error));
    this.#abort?.abort(aborted(error.message));
    if (isBroken()) return;
    this.#stage.lose();
    this.#stage.free();
  }

  /** Something is other than what a frame failed with. */
  #changed() {
    if (!this.#gone) this.#failed = undefined;
    this.#wake();
  }

  #wake() {
    if (this.#request || this.#timer || this.#disposed || this.#recovery || this.#failed || isBroken()) return;
    this.#times.wake();
    if (this.#watched.seen) this.#request = requestAnimationFrame(this.#onFrame);
    // A picture that was asked for is made all the same.
    else if (this.#shots.length > 0) this.#timer = setTimeout(this.#onTimer, 20);
  }

  #fit() { fit(this.#canvas, this.#pixels, this.#longest); }

  #advance(now) {
    const playback = this.#playback;
    if (!playback.playing) return;
    if (playback.advance(now, this.duration)) this.pause();
    if (!this.#disposed) this.#stage.seek(playback.clip, playback.time);
  }

  #frame(now) {
    if (this.#disposed || this.#recovery || this.#failed || isBroken()) return;
    if (!this.#watched.seen && this.#shots.length === 0) return;
    try {
      if (this.#recover()) return;
      this.#fit();
      this.#stage.resize();
      this.#advance(now);
      if (this.#disposed) return;
      const drawn = this.#stage.draw(performance.now());
      if (drawn === Drawn.Frame) {
        this.#times.drew(now);
        if (this.#shots.length > 0) this.#shoot();
        this.dispatchEvent(this.#drew);
      } else if (drawn === Drawn.Nothing) this.#times.idle();
      if (this.playing || now - this.#live < 300 || drawn === Drawn.Later) this.#wake();
      if (!this.#request) this.#times.rest();
    } catch (error) {
      const reason = told(error);
      if (isBroken() || !this.#recover()) this.#fail(reason);
    }
  }

  #fail(error) {
    this.#failed = error;
    this.#shots.splice(0).forEach(({ reject }) => reject(error));
    this.dispatchEvent(new CustomEvent("error", { detail: error }));
  }

  /** Whether the device is lost: then another is on its way. */
  #recover() {
    if (this.#disposed || isBroken() || !this.#stage?.is_lost()) return false;
    if (!this.#gone) this.#recovery ??= this.#reopen().finally(() => { this.#recovery = undefined; this.#wake(); });
    return true;
  }

  async #reopen() {
    this.dispatchEvent(new Event("lost"));
    const adopt = (screen) => {
      this.#longest = screen.longest();
      this.#stage.adopt(screen);
      this.dispatchEvent(new Event("restored"));
    };
    try {
      await this.#devices.reopen(adopt, () => !this.#disposed);
    } catch (error) {
      this.#gone = true;
      if (!this.#disposed) this.#fail(told(error));
    }
  }
}
