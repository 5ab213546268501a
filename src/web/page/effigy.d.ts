/** Draws animatable avatars of Gaussians on a canvas, through WebGPU. */

/** A URL, a file, or the bytes themselves. */
export type Source = string | URL | Blob | ArrayBuffer | Uint8Array;

/** From where the avatar is seen: around a point. */
export interface Camera {
  /** What is looked at, metres; y is up, the avatar faces +z. */
  target: [number, number, number];
  /** Radians around the avatar: 0 sees its front, growing towards its left. */
  yaw: number;
  /** Radians above the horizon. */
  pitch: number;
  /** Metres from the target. */
  distance: number;
  /** Vertical field of view, radians. */
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
  /** The skeleton's joints, in the order that poses have them. */
  joints: string[];
  /** Numbers of an expression. */
  expression: number;
  /** Lower and upper corner of a box around the avatar at rest, metres. */
  bounds: [[number, number, number], [number, number, number]];
  clips: { name: string; /** seconds */ duration: number }[];
}

export interface Pose {
  /** Axis-angle rotation of each joint against its parent, radians: 3 numbers a joint. */
  rotation: ArrayLike<number>;
  /** Of the root, metres: 3 numbers. */
  translation?: ArrayLike<number>;
  /** At most `description.expression` numbers; the others are 0. */
  expression?: ArrayLike<number>;
}

export interface Statistics {
  /** Median time from frame to frame of the last 240 drawn, ms. */
  frameMs?: number;
  p95Ms?: number;
  fps: number;
  device?: string;
  /** How splats are drawn: `hulls` or `tiles`. */
  raster?: string;
  /** The device's time for each stage, ms; empty where the browser does not tell. */
  stages?: Record<string, number>;
  counters?: Record<string, number>;
}

/** Whether this browser has WebGPU. A device may still be missing: then `create` fails. */
export function isSupported(): boolean;

export class Unsupported extends Error {}

/**
 * An avatar on a canvas. It draws when something has changed and the page is visible, follows the canvas's size and the screen's pixel ratio,
 * and opens a lost device again by itself. Events: `frame` after each one drawn, `play`, `pause`, `lost`, `restored`, and `error`
 * (a CustomEvent whose detail is the Error) after which nothing more is drawn.
 */
export class Effigy extends EventTarget {
  static create(canvas: HTMLCanvasElement, options?: Options): Promise<Effigy>;
  /** Takes the place of the avatar there is, which stays where loading fails. Clips go with the avatar. `frame: false` leaves the camera. */
  loadAvatar(source: Source, options?: LoadOptions & { frame?: boolean }): Promise<Description>;
  /** Adds a clip and plays it; gives its number. */
  loadMotion(source: Source, options?: LoadOptions & { play?: boolean }): Promise<number>;
  play(clip?: number): void;
  pause(): void;
  /** Drives the avatar live, at any rate; between poses it is interpolated. */
  setPose(pose: Pose): void;
  /** Looks at all of the avatar. */
  frameAvatar(): void;
  /** The canvas as a PNG. */
  screenshot(): Promise<Blob>;
  /** Loses the device on purpose, to test what follows. */
  loseDevice(): void;
  /** Gives everything back. */
  dispose(): void;
  readonly description: Description;
  readonly clips: Description["clips"];
  readonly clip: number;
  /** Of the clip, seconds. */
  readonly duration: number;
  readonly playing: boolean;
  /** Seconds into the clip. */
  time: number;
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
