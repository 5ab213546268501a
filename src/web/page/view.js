// Cameras, and how many pixels a canvas has.
import { within } from "./source.js";

export const VIEW = { target: [0, 1, 0], yaw: 0.35, pitch: 0.09, distance: 3.2, fov: 0.61 };

/** A whole camera, or a RangeError on what can't be looked through. */
export function checkedCamera({ target, yaw, pitch, distance, fov }) {
  if (target?.length !== 3) throw new RangeError(`the camera's target is ${target}, expected three numbers`);
  return {
    target: Array.from(target, (metres) => within("the camera's target", metres, -1e9, 1e9)),
    yaw: within("the camera's yaw", yaw, -1e9, 1e9),
    pitch: within("the camera's pitch", pitch, -1e9, 1e9),
    distance: within("the camera's distance", distance, 1e-3, 1e9),
    fov: within("the camera's field of view", fov, 1e-3, 3.1),
  };
}

/** What part of a camera changes so that a box is in the picture from every side. */
export function framing([min, max], fov, aspect) {
  const half = max.map((high, axis) => (high - min[axis]) / 2), around = Math.hypot(half[0], half[2]), slope = Math.tan(fov / 2);
  const distance = 1.05 * Math.max(half[1] / slope, around / (slope * aspect)) + around;
  return { target: min.map((low, axis) => low + half[axis]), distance };
}

/** Gives a canvas the pixels that the page has for it, at most `most` for one of the page's and `longest` a side. */
export function fit(canvas, most, longest) {
  const wide = canvas.clientWidth, high = canvas.clientHeight;
  const ratio = Math.min(window.devicePixelRatio || 1, most, longest / Math.max(wide, high, 1));
  const width = Math.max(1, Math.round(wide * ratio)), height = Math.max(1, Math.round(high * ratio));
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
}
