/** Draws animatable avatars of 3D Gaussians on a canvas, with WebGPU. */

/**
 * A URL, a file, or the bytes themselves: of Effigy's own files, or of other programs' (docs/formats.md
 * lists them; all but FBX). What reads those is loaded when it is first needed, and runs in a worker:
 * this module must be of the page's own origin for them. They may not refer to files beside them.
 */
export type Source = string | URL | Blob | ArrayBuffer | Uint8Array;

/**
 * A camera that looks at a point. Assigning numbers that nothing can be drawn with throws a
 * RangeError and changes nothing.
 */
export interface Camera {
  /** The point that the camera looks at, metres; y is up, the avatar faces +z. */
  target: [number, number, number];
  /** Angle around the avatar, radians: 0 sees its front, larger ones its left. */
  yaw: number;
  /** Angle above the horizon, radians. It is drawn as if limited to ±1.55. */
  pitch: number;
  /** Distance from the target, metres, 1e-6 to 1e9. */
  distance: number;
  /** Vertical field of view, radians, 0.001 to 3.1. */
  fov: number;
}

export interface Options {
  camera?: Partial<Camera>;
  /** Most pixels of the canvas for one of the page's, a side; 2 by default. */
  maxPixelRatio?: number;
  /**
   * How many times its size an avatar is drawn, before it is averaged: `--supersample` of the
   * command. With "auto", the default, an avatar under 720 px is drawn as if it had that many, at
   * most 4 times as large, and from a level of detail of its file where nothing is lost by that. 1
   * draws it as large as it is shown, too thick and flickering. Another value is a RangeError.
   */
  supersample?: "auto" | 1 | 2 | 4;
  /**
   * How many of the Gaussians are drawn where no level of detail of the file is: `--detail` of the
   * command. Less than "full", the default, is faster and shows. Another value is a RangeError.
   */
  detail?: "full" | "1/2" | "1/4" | "1/8" | "auto";
}

export interface LoadOptions {
  /**
   * Called with the number of bytes that have arrived, and with their total if the server says it.
   */
  onProgress?: (loaded: number, total?: number) => void;
  /** Aborts loading. */
  signal?: AbortSignal;
}

/** The avatar that is shown, and its clips. */
export interface Description {
  name: string;
  credit: string;
  gaussians: number;
  parts: number;
  nodes: number;
  /** Rows of the correctives' basis after pruning: of rotation, scale and colour. */
  rows: [number, number, number];
  /** Names of the skeleton's joints, in the order of poses. */
  joints: string[];
  /** Numbers of an expression. */
  expression: number;
  /**
   * Lower and upper corner of a box around the avatar, metres. It is for the pose at the last call
   * of `loadAvatar`, `loadMotion` or `frameAvatar`.
   */
  bounds: [[number, number, number], [number, number, number]];
  clips: {
    name: string;
    /** Seconds. */
    duration: number;
  }[];
}

export interface Pose {
  /** Rotation of each joint against its parent, axis-angle, radians: three numbers a joint. */
  rotation: ArrayLike<number>;
  /** Translation of the root, metres, three numbers of at most 10,000; 0 by default. */
  translation?: ArrayLike<number>;
  /** At most `description.expression` numbers; the missing ones are 0. */
  expression?: ArrayLike<number>;
}

export interface Statistics {
  /**
   * Median time from one frame to the next, of the last 240 frames, ms. Pauses in which nothing had
   * to be drawn do not count.
   */
  frameMs?: number;
  /** 95th percentile of the same times, ms. */
  p95Ms?: number;
  /** Mean rate of the same frames. */
  fps: number;
  /** The device's name. */
  device?: string;
  /** The method that rasterizes splats. */
  raster?: string;
  /** GPU time of each stage, ms; empty if the browser does not report it. */
  stages?: Record<string, number>;
  /**
   * Counts of a frame at most two frames old: `gaussians` of the avatar, `drawn` of them,
   * `supersampled` avatars, their `most_samples` a pixel along each axis, the `coarsest_level` that
   * one is drawn from (0 is the avatar itself), and more.
   */
  counters?: Record<string, number>;
  /** The renderer's options, in the form of the reports of `effigy bench`. */
  options?: Record<string, string | number>;
  /** Effigy's version. */
  version?: string;
}

/** Whether this browser has WebGPU. It may still have no device: then `create` fails. */
export function isSupported(): boolean;

/**
 * What a file is by its content: whether it is for `loadAvatar` or for `loadMotion`. There must be
 * an `Effigy` already.
 */
export function kindOf(file: Blob): Promise<"avatar" | "motion" | "unknown">;

/** There is no WebGPU, or no device for it. */
export class Unsupported extends Error {}

/**
 * An avatar on a canvas. It draws a frame when something has changed and the canvas can be seen,
 * follows the canvas's size and the screen's pixel ratio, and replaces a lost device.
 *
 * Events:
 * - `frame` after each frame.
 * - `play` and `pause`.
 * - `import`, a CustomEvent whose `detail` has the `name` of a file of another program that was
 *   loaded, and `notes`: a line on each thing that it left open, and what was taken.
 * - `lost` and `restored`: the device was lost, or replaced.
 * - `error`, a CustomEvent whose `detail` is the Error. Nothing more is drawn until something is
 *   changed. A device that is lost five times in a minute, or can't be replaced for some seconds,
 *   is such an error: the next `loadAvatar` tries again.
 */
export class Effigy extends EventTarget {
  /** Opens a device for a canvas. Throws Unsupported if there is none. */
  static create(canvas: HTMLCanvasElement, options?: Options): Promise<Effigy>;
  /**
   * Replaces the avatar and its clips, and pauses. If loading fails, the current avatar stays. Of
   * several requests only the last one is shown: the others fail with an AbortError. With
   * `frame: false` the camera stays.
   *
   * If the file of a URL arrives slowly, the avatar is shown without its correctives as soon as
   * possible, then with them; clip, time and camera stay. If the rest does not arrive, the avatar
   * from before comes back.
   */
  loadAvatar(source: Source, options?: LoadOptions & { frame?: boolean }): Promise<Description>;
  /**
   * Adds a clip and plays it. Returns its index. Motion of another body is retargeted to the avatar.
   * The clip is for the avatar that was requested last,
   * which may still be loading. If that one fails or is replaced, this fails with an AbortError.
   */
  loadMotion(source: Source, options?: LoadOptions & { play?: boolean }): Promise<number>;
  /** Plays the current clip, or the one with an index. */
  play(clip?: number): void;
  pause(): void;
  /**
   * Drives the avatar live, at any rate; it is interpolated between poses. A pose that can't be
   * drawn is a RangeError and changes nothing.
   */
  setPose(pose: Pose): void;
  /** Moves the camera so that all of the avatar is visible. */
  frameAvatar(): void;
  /** The next frame as a PNG, even if the canvas can't be seen. Fails if nothing can be drawn. */
  screenshot(): Promise<Blob>;
  /** Loses the device on purpose, for tests. */
  loseDevice(): void;
  /** Frees everything, on the device too. Calls under way fail. */
  dispose(): void;
  readonly description: Description;
  readonly clips: Description["clips"];
  /** Index of the clip that is shown. */
  readonly clip: number;
  /** Length of the clip, seconds. */
  readonly duration: number;
  readonly playing: boolean;
  /** Time in the clip, seconds. */
  get time(): number;
  /** Throws a RangeError for NaN and infinities. */
  set time(seconds: number);
  /** Whether the clip starts again at its end. */
  loop: boolean;
  /** Speed: 1 is as captured, negative is backwards. */
  rate: number;
  get camera(): Camera;
  /** Changes the given properties only. */
  set camera(camera: Partial<Camera>);
  /**
   * Whether the networks get each pose projected onto the training poses, as they do at first, or
   * as it is.
   */
  set projection(on: boolean);
  /** Colour behind the avatar: red, green and blue, 0 to 1. */
  set background(color: [number, number, number]);
  readonly statistics: Statistics;
}
