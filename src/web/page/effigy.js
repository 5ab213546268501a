// Effigy in a page: `const effigy = await Effigy.create(canvas); await effigy.loadAvatar("demo.avatar");`. effigy.d.ts says all of it.
import init, { Drawn, Stage } from "./effigy_core.js";

let ready;

/** Whether this browser can draw at all. */
export const isSupported = () => "gpu" in navigator;

/** What is thrown where there is no WebGPU. */
export class Unsupported extends Error {
  constructor() {
    super("This browser has no WebGPU. Chrome and Edge from 113 on have it, Safari from 26, and Firefox from 141 on Windows, from 145 on Macs.");
    this.name = "Unsupported";
  }
}

async function download(url, onProgress, signal) {
  const response = await fetch(url, { signal });
  if (!response.ok) throw new Error(`${url} can't be loaded: the server says ${response.status} ${response.statusText}`);
  const length = Number(response.headers.get("content-length"));
  // What is compressed on the way is longer than the header says.
  const total = length > 0 && !response.headers.get("content-encoding") ? length : undefined;
  const reader = response.body.getReader();
  let bytes = new Uint8Array(total ?? 1 << 20), loaded = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    if (loaded + value.length > bytes.length) {
      const more = new Uint8Array(Math.max(2 * bytes.length, loaded + value.length));
      more.set(bytes.subarray(0, loaded));
      bytes = more;
    }
    bytes.set(value, loaded);
    loaded += value.length;
    onProgress?.(loaded, total);
  }
  return bytes.subarray(0, loaded);
}

async function bytesOf(source, onProgress, signal) {
  if (typeof source === "string" || source instanceof URL) return download(String(source), onProgress, signal);
  if (source instanceof Blob) return new Uint8Array(await source.arrayBuffer());
  return source instanceof Uint8Array ? source : new Uint8Array(source);
}

export class Effigy extends EventTarget {
  #stage; #canvas; #observer; #pixels; #request = 0; #last; #clip = 0; #time = 0; #playing = false; #loop = true; #rate = 1;
  #described = {}; #camera; #frames = []; #recovering = false; #failed; #disposed = false; #live = 0;
  #onVisible = () => this.#wake();

  /** Makes a device for a canvas that nothing else draws on. The canvas's size on the page decides its pixels. */
  static async create(canvas, options = {}) {
    if (!isSupported()) throw new Unsupported();
    await (ready ??= init({ module_or_path: new URL("effigy_core_bg.wasm", import.meta.url) }));
    const effigy = new Effigy();
    effigy.#canvas = canvas;
    effigy.#pixels = options.maxPixelRatio ?? 2;
    effigy.#fit();
    effigy.#stage = await Stage.create(canvas);
    effigy.camera = { target: [0, 1, 0], yaw: 0.35, pitch: 0.09, distance: 3.2, fov: 0.61, ...options.camera };
    effigy.#observer = new ResizeObserver(() => effigy.#wake());
    effigy.#observer.observe(canvas);
    document.addEventListener("visibilitychange", effigy.#onVisible);
    return effigy;
  }

  /** Takes an avatar from a URL, a File or bytes. Where that fails the old one stays. */
  async loadAvatar(source, { onProgress, signal, frame = true } = {}) {
    const bytes = await bytesOf(source, onProgress, signal);
    this.#open();
    this.#fit();
    this.#stage.resize();
    this.#stage.load(bytes);
    [this.#clip, this.#time, this.#playing, this.#live] = [0, 0, false, 0];
    this.#describe();
    if (frame) this.frameAvatar();
    this.#wake();
    return this.description;
  }

  /** Adds a clip from a URL, a File or bytes, and plays it. Gives its number. */
  async loadMotion(source, { onProgress, signal, play = true } = {}) {
    const bytes = await bytesOf(source, onProgress, signal);
    this.#open();
    const number = this.#stage.add_clip(bytes);
    this.#describe();
    if (play) this.play(number);
    return number;
  }

  #open() { if (this.#disposed) throw new Error("this avatar's canvas was disposed of"); }
  #describe() { this.#described = JSON.parse(this.#stage.describe()); }

  get description() { return this.#described; }
  get clips() { return this.#described.clips ?? []; }
  get clip() { return this.#clip; }
  get duration() { return this.clips[this.#clip]?.duration ?? 0; }
  get playing() { return this.#playing; }
  get time() { return this.#time; }
  set time(seconds) {
    this.#time = seconds;
    this.#stage.seek(this.#clip, seconds);
    this.#live = 0;
    this.#wake();
  }
  get loop() { return this.#loop; }
  set loop(loop) { this.#loop = loop; }
  get rate() { return this.#rate; }
  set rate(rate) { this.#rate = rate; }

  /** Plays a clip from where it stands, or another from its start. */
  play(clip = this.#clip) {
    if (!(clip in this.clips)) throw new RangeError(`there is no clip ${clip}: ${this.clips.length} are loaded`);
    if (clip !== this.#clip || (!this.#loop && this.#time >= this.duration)) this.#time = 0;
    this.#clip = clip;
    this.time = this.#time;
    this.#playing = true;
    this.#last = undefined;
    this.dispatchEvent(new Event("play"));
  }

  pause() {
    this.#playing = false;
    this.dispatchEvent(new Event("pause"));
  }

  /** Drives the avatar live, at any rate: three numbers a joint, in the order of `description.joints`. */
  setPose({ rotation, translation = [0, 0, 0], expression = [] }) {
    this.#open();
    const numbers = (list) => (list instanceof Float32Array ? list : Float32Array.from(list));
    this.#stage.set_pose(performance.now(), numbers(rotation), numbers(translation), numbers(expression));
    this.#playing = false;
    this.#live = performance.now();
    this.#wake();
  }

  get camera() { return { ...this.#camera, target: [...this.#camera.target] }; }
  set camera(camera) {
    this.#camera = { ...this.#camera, ...camera };
    const { target: [x, y, z], yaw, pitch, distance, fov } = this.#camera;
    this.#stage?.set_camera(x, y, z, yaw, pitch, distance, fov);
    this.#wake();
  }

  /** Looks at all of the avatar. */
  frameAvatar() {
    this.#describe();
    const [min, max] = this.#described.bounds ?? [[-0.5, 0, -0.5], [0.5, 1.8, 0.5]];
    const half = max.map((high, axis) => (high - min[axis]) / 2), around = Math.hypot(half[0], half[2]);
    const slope = Math.tan(this.#camera.fov / 2), aspect = this.#canvas.width / this.#canvas.height;
    const distance = 1.05 * Math.max(half[1] / slope, around / (slope * aspect)) + around;
    this.camera = { target: min.map((low, axis) => low + half[axis]), distance };
  }

  /** Whether networks see poses as the nearest ones that the avatar knows (as at first), or as they are. */
  set projection(on) {
    this.#stage.set_projection(on);
    this.#wake();
  }

  /** What lies behind: three numbers from 0 to 1. */
  set background([red, green, blue]) {
    this.#over = [red, green, blue];
    this.#stage.set_background(red, green, blue);
    this.#wake();
  }

  /** Frames a second and times, ms, of the last frames drawn, and what the last one was made of. */
  get statistics() {
    const times = [...this.#frames].sort((a, b) => a - b), at = (share) => times[Math.floor(share * (times.length - 1))];
    const mean = times.reduce((sum, time) => sum + time, 0) / times.length;
    return { frameMs: at(0.5), p95Ms: at(0.95), fps: mean > 0 ? 1000 / mean : 0, ...JSON.parse(this.#stage.statistics()) };
  }

  /** The canvas as a PNG. */
  async screenshot() {
    return new Promise((resolve, reject) => {
      this.#shot = () => this.#canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the browser made no picture"))));
      this.#stage.set_background(...this.#over);
      this.#wake();
    });
  }
  #shot; #over = [216 / 255, 221 / 255, 227 / 255];

  /** For tests: loses the device, which is then opened again. */
  loseDevice() {
    this.#stage.lose();
    this.#wake();
  }

  dispose() {
    if (this.#disposed) return;
    this.#disposed = true;
    cancelAnimationFrame(this.#request);
    this.#observer.disconnect();
    document.removeEventListener("visibilitychange", this.#onVisible);
    this.#stage.free();
  }

  #wake() {
    if (!this.#disposed && !this.#request && !document.hidden && this.#stage) {
      this.#request = requestAnimationFrame((now) => this.#frame(now));
    }
  }

  #fit() {
    const ratio = Math.min(window.devicePixelRatio || 1, this.#pixels), { clientWidth, clientHeight } = this.#canvas;
    const [width, height] = [clientWidth, clientHeight].map((side) => Math.max(1, Math.round(side * ratio)));
    if (this.#canvas.width !== width) this.#canvas.width = width;
    if (this.#canvas.height !== height) this.#canvas.height = height;
  }

  #advance(now) {
    if (!this.#playing) return;
    this.#time += this.#last === undefined ? 0 : (this.#rate * Math.min(now - this.#last, 250)) / 1000;
    this.#last = now;
    const length = this.duration;
    if (this.#time > length || this.#time < 0) {
      this.#time = this.#loop && length > 0 ? ((this.#time % length) + length) % length : Math.min(Math.max(this.#time, 0), length);
      if (!this.#loop) this.pause();
    }
    this.#stage.seek(this.#clip, this.#time);
  }

  #frame(now) {
    this.#request = 0;
    if (this.#recovering || this.#failed) return;
    try {
      if (this.#stage.is_lost()) return void this.#recover();
      this.#fit();
      this.#stage.resize();
      this.#advance(now);
      const drawn = this.#stage.draw(performance.now());
      if (drawn === Drawn.Frame) {
        if (this.#drawn !== undefined && now - this.#drawn < 1000) this.#frames.push(now - this.#drawn);
        if (this.#frames.length > 240) this.#frames.shift();
        this.#drawn = now;
        this.#shot?.();
        this.#shot = undefined;
        this.dispatchEvent(new Event("frame"));
      }
      if (this.#playing || now - this.#live < 300 || drawn === Drawn.Later) this.#wake();
    } catch (error) {
      if (this.#stage.is_lost()) return void this.#recover();
      this.#failed = error;
      this.dispatchEvent(new CustomEvent("error", { detail: error }));
    }
  }
  #drawn;

  async #recover() {
    this.#recovering = true;
    this.dispatchEvent(new Event("lost"));
    try {
      await this.#stage.recover();
      const { target: [x, y, z], yaw, pitch, distance, fov } = this.#camera;
      this.#stage.set_camera(x, y, z, yaw, pitch, distance, fov);
      this.dispatchEvent(new Event("restored"));
    } catch (error) {
      this.#failed = error;
      this.dispatchEvent(new CustomEvent("error", { detail: error }));
    }
    this.#recovering = false;
    this.#wake();
  }
}
