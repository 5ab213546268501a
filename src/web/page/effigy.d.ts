/** Draws animatable avatars of Gaussians on a canvas, through WebGPU. */

/** A URL, a file, or the bytes themselves. */
export type Source = string | URL | Blob | ArrayBuffer | Uint8Array;

/** From where the avatar is seen: around a point. Numbers that can't be looked through are a RangeError and change nothing. */
export interface Camera {
  /** What is looked at, metres; y is up, the avatar faces +z. */
  target: [number, number, number];
  /** Radians around the avatar: 0 sees its front, growing towards its left. */
  yaw: number;
  /** Radians above the horizon; beyond ±1.55 it is drawn as if it were that. */
  pitch: number;
  /** Metres from the target, 0.001 to 1e9. */
  distance: number;
  /** Vertical field of view, radians, 0.001 to 3.1. */
  fov: number;
}

export interface Options {
  camera?: Partial<Camera>;
  /** Pixels of the canvas in one of the page's, at most; 2 unless given. */
  maxPixelRatio?: number;
}

export interface LoadOptions {
  /** Told how many bytes have come, and of how many where the server says it. */
  onProgress?: (loaded: number, total?: number) => void;
  signal?: AbortSignal;
}

export interface Description {
  name: string;
  credit: string;
  gaussians: number;
  parts: number;
  nodes: number;
  /** Correctives kept: of rotation, scale and colour. */
  rows: [number, number, number];
  /** The skeleton's joints, in the order that poses have them. */
  joints: string[];
  /** Numbers of an expression. */
  expression: number;
  /** Lower and upper corner of a box around the avatar as it stood when it was described, metres: by `loadAvatar`, `loadMotion`, `frameAvatar`. */
  bounds: [[number, number, number], [number, number, number]];
  clips: { name: string; /** seconds */ duration: number }[];
}

export interface Pose {
  /** Axis-angle rotation of each joint against its parent, radians: 3 numbers a joint. */
  rotation: ArrayLike<number>;
  /** Of the root, metres, at most 10,000: 3 numbers. */
  translation?: ArrayLike<number>;
  /** At most `description.expression` numbers; the others are 0. */
  expression?: ArrayLike<number>;
}

export interface Statistics {
  /** Median time from frame to frame of the last 240 drawn, ms. Pauses in which nothing had to be drawn do not count. */
  frameMs?: number;
  p95Ms?: number;
  fps: number;
  device?: string;
  /** How splats are drawn: `hulls` or `tiles`. */
  raster?: string;
  /** The device's time for each stage, ms; empty where the browser does not tell. */
  stages?: Record<string, number>;
  counters?: Record<string, number>;
  /** All that it is drawn with, as in the reports of `effigy bench`. */
  options?: Record<string, string | number>;
  /** Of Effigy. */
  version?: string;
}

/** Whether this browser has WebGPU. A device may still be missing: then `create` fails. */
export function isSupported(): boolean;

/** There is no WebGPU, or no device for it. */
export class Unsupported extends Error {}

/**
 * An avatar on a canvas. It draws when something has changed and the canvas can be seen, follows the canvas's size and the screen's pixel ratio,
 * and opens a lost device again by itself. Events: `frame` after each one drawn, `play`, `pause`, `lost`, `restored`, and `error` (a CustomEvent
 * whose detail is the Error): nothing more is drawn before something is changed. A device that is lost five times in a minute, or can't be had
 * for some seconds, is such an error too: the next `loadAvatar` tries again.
 */
export class Effigy extends EventTarget {
  static create(canvas: HTMLCanvasElement, options?: Options): Promise<Effigy>;
  /**
   * Takes the place of the avatar there is, which stays where loading fails, and pauses. Of several the last asked for is shown, the others
   * fail with an AbortError. Clips go with the avatar. `frame: false` leaves the camera.
   * Of a URL whose file comes slowly the avatar is shown without its correctives as soon as it can be, then as a whole, with clip, time and
   * camera kept; should the rest not come, the avatar from before comes back.
   */
  loadAvatar(source: Source, options?: LoadOptions & { frame?: boolean }): Promise<Description>;
  /**
   * Adds a clip and plays it; gives its number. It is for the avatar that was asked for last, and may be asked for before that one has come: if
   * that one never comes, or another has, it fails with an AbortError.
   */
  loadMotion(source: Source, options?: LoadOptions & { play?: boolean }): Promise<number>;
  play(clip?: number): void;
  pause(): void;
  /** Drives the avatar live, at any rate; between poses it is interpolated. A pose that can't be drawn is a RangeError and changes nothing. */
  setPose(pose: Pose): void;
  /** Looks at all of the avatar. */
  frameAvatar(): void;
  /** The canvas as a PNG, even where it can't be seen; fails where nothing can be drawn. */
  screenshot(): Promise<Blob>;
  /** Loses the device on purpose, to test what follows. */
  loseDevice(): void;
  /** Gives everything back, the device's memory too; what is under way fails. */
  dispose(): void;
  readonly description: Description;
  readonly clips: Description["clips"];
  readonly clip: number;
  /** Of the clip, seconds. */
  readonly duration: number;
  readonly playing: boolean;
  /** Seconds into the clip. */
  get time(): number;
  /** What is no number is a RangeError. */
  set time(seconds: number);
  loop: boolean;
  /** Speed: 1 is as captured, negative is backwards. */
  rate: number;
  get camera(): Camera;
  set camera(camera: Partial<Camera>);
  /** Whether networks see poses as the nearest ones that the avatar knows (as at first), or as they are. */
  set projection(on: boolean);
  /** Red, green and blue behind the avatar, 0 to 1. */
  set background(color: [number, number, number]);
  readonly statistics: Statistics;
}
