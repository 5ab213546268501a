// Effigy in a page: `const effigy = await Effigy.create(canvas); await effigy.loadAvatar("demo.avatar");`. effigy.d.ts says all of it.
import { Drawn, Stage } from "./effigy_core.js";
import { Unsupported, firstScreen, isBroken, isSupported, loaded, told } from "./core.js";
import { Devices } from "./devices.js";
import { Loader } from "./loader.js";
import { Playback } from "./playback.js";
import { aborted, bytesOf, within } from "./source.js";
import { Shots } from "./shots.js";
import { Times } from "./times.js";
import { VIEW, checkedCamera, fit, framing } from "./view.js";
import { Watched } from "./watched.js";

export { Unsupported, isSupported };

const GONE = "this avatar's canvas was disposed of";

export class Effigy extends EventTarget {
  #stage; #canvas; #pixels; #longest = 8192; #camera; #described = {}; #disposed = false;
  #playback = new Playback(); #live = 0;
  #request = 0; #timer = 0; #watched; #times = new Times(); #shots = new Shots(); #drew = new Event("frame");
  // The ticket of the avatar that is shown.
  #shown = 0; #loader = new Loader({
    open: () => this.#open(), ready: () => this.#ready(), lost: () => this.#recover(), stage: () => this.#fitted(),
    save: () => [this.#shown, this.#playback, this.#camera], revert: (ticket, before) => this.#revert(ticket, before),
    arrived: (ticket, frame) => this.#arrived(ticket, frame), completed: () => { this.#describe(); this.#changed(); },
  });
  #devices; #recovery; #failed; #gone = false;

  // Bound once: a frame makes no functions.
  #onFrame = (now) => { this.#request = 0; this.#frame(now); };
  #onTimer = () => { this.#timer = 0; this.#frame(performance.now()); };

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
    this.#fitted();
    this.#devices = new Devices(this.#canvas, () => this.#recover());
    this.#stage = new Stage(this.#devices.follow(screen));
    this.#look();
    this.#watched = new Watched(this.#canvas, (seen) => this.#see(seen));
    this.#wake();
  }

  async loadAvatar(source, options) {
    this.#open();
    await this.#loader.load(source, options);
    return this.description;
  }

  /** Kept once there is a device; one that was given up is asked for again. */
  async #ready() {
    if (this.#gone) {
      [this.#gone, this.#failed] = [false, undefined];
      this.#devices.forgive();
      this.#recover();
    }
    await this.#recovery;
    if (this.#gone) throw this.#failed;
  }

  #fitted() {
    fit(this.#canvas, this.#pixels, this.#longest);
    this.#stage?.resize();
    return this.#stage;
  }

  /** An avatar was put in the place of another. */
  #arrived(ticket, frame) {
    const { playing, loop, rate } = this.#playback;
    this.#playback = Object.assign(new Playback(), { loop, rate });
    [this.#shown, this.#live] = [ticket, 0];
    if (playing) this.pause();
    this.#describe();
    if (frame) this.frameAvatar();
    this.#changed();
  }

  /** The rest of an avatar did not come: the one from before does. */
  #revert(ticket, [shown, playback, camera]) {
    if (this.#disposed || this.#shown !== ticket) return;
    this.#stage.revert();
    [this.#shown, this.#playback, this.#live] = [shown, playback, 0];
    this.#describe();
    this.camera = camera;
    this.dispatchEvent(new Event(playback.playing ? "play" : "pause"));
  }

  async loadMotion(source, { onProgress, signal, play = true } = {}) {
    this.#open();
    const { ticket, shown: avatar } = this.#loader.loading ?? { ticket: this.#shown };
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
    if (this.#disposed) throw new Error(GONE);
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

  frameAvatar() {
    this.#open();
    this.#describe();
    const bounds = this.#described.bounds ?? [[-0.5, 0, -0.5], [0.5, 1.8, 0.5]];
    this.camera = framing(bounds, this.#camera.fov, this.#canvas.width / this.#canvas.height);
  }

  set projection(on) {
    this.#open();
    this.#stage.set_projection(Boolean(on));
    this.#changed();
  }

  set background(color) {
    this.#open();
    const [red, green, blue] = Array.from(color, (channel) => within("the background", channel, 0, 1));
    this.#stage.set_background(red, green, within("the background", blue, 0, 1));
    this.#changed();
  }

  get statistics() {
    const core = this.#disposed || isBroken() ? {} : JSON.parse(this.#stage.statistics());
    return { ...this.#times.summary, ...core };
  }

  async screenshot() {
    this.#open();
    if (this.#failed) throw this.#failed;
    if (!this.#shown) throw new Error("there is no avatar yet to take a picture of: load one first");
    const shot = this.#shots.next();
    this.#stage.redraw();
    this.#wake();
    return shot;
  }

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
    this.#shots.refuse(new Error(GONE));
    this.#loader.stop(GONE);
    if (isBroken()) return;
    this.#stage.lose();
    this.#stage.free();
  }

  #see(other) {
    if (other) {
      // Where nobody sees it no frame is called for: pictures must not wait for one.
      cancelAnimationFrame(this.#request);
      this.#request = 0;
      this.#times.idle();
    }
    this.#wake();
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
    else if (this.#shots.wanted) this.#timer = setTimeout(this.#onTimer, 20);
  }

  #advance(now) {
    if (this.#playback.advance(now, this.duration)) this.pause();
    if (!this.#disposed) this.#stage.seek(this.clip, this.time);
  }

  #frame(now) {
    if (this.#disposed || this.#recovery || this.#failed || isBroken()) return;
    if (!this.#watched.seen && !this.#shots.wanted) return;
    try {
      if (this.#recover()) return;
      this.#fitted();
      if (this.playing) this.#advance(now);
      if (this.#disposed) return;
      const drawn = this.#stage.draw(performance.now());
      if (drawn === Drawn.Frame) {
        this.#times.drew(now);
        if (this.#shots.wanted) this.#shots.take(this.#canvas);
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
    this.#shots.refuse(error);
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
