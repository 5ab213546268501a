// Cameras, and how many pixels a canvas has.
import { checkedNumber } from "./validate.js";

/** The camera before an avatar is loaded. */
export const DEFAULT_CAMERA = {
  target: [0, 1, 0],
  yaw: 0.35,
  pitch: 0.09,
  distance: 3.2,
  fov: 0.61,
};

/** The box to show before an avatar is loaded, metres. */
const DEFAULT_BOUNDS = [
  [-0.5, 0, -0.5],
  [0.5, 1.8, 0.5],
];

/** Copies a complete camera. Throws a RangeError for one that nothing can be drawn with. */
export function checkedCamera({ target, yaw, pitch, distance, fov }) {
  if (target?.length !== 3) {
    throw new RangeError(`the camera's target is ${target}, expected three numbers`);
  }
  return {
    target: Array.from(target, (metres) => checkedNumber("the camera's target", metres, -1e9, 1e9)),
    yaw: checkedNumber("the camera's yaw", yaw, -1e9, 1e9),
    pitch: checkedNumber("the camera's pitch", pitch, -1e9, 1e9),
    distance: checkedNumber("the camera's distance", distance, 1e-6, 1e9),
    fov: checkedNumber("the camera's field of view", fov, 1e-3, 3.1),
  };
}

/** Half the diagonal of a box, metres. */
export function radius([min, max] = DEFAULT_BOUNDS) {
  return Math.hypot(...max.map((high, axis) => high - min[axis])) / 2;
}

/** Radius of the cylinder around who stands, metres. */
const PERSON = 0.57;

/**
 * Target and distance from which all of a box is visible, from every side; of who `stands` in it,
 * head and feet: Camera::framing_distance and standing_distance in src/core/scene/camera.rs.
 */
export function framing([min, max] = DEFAULT_BOUNDS, fov, aspect, stands) {
  const half = max.map((high, axis) => (high - min[axis]) / 2);
  const radius = Math.hypot(half[0], half[2]);
  const slope = Math.tan(fov / 2);
  const [tall, wide] = [(1.05 * half[1]) / slope, (1.05 * radius) / (slope * aspect)];
  const person = Math.min(radius, PERSON);
  const distance = stands
    ? Math.max(Math.hypot(tall, person) + radius - person, Math.hypot(wide, radius))
    : Math.max(tall, wide) + radius;
  return { target: min.map((low, axis) => low + half[axis]), distance };
}

/**
 * Gives a canvas as many pixels as it covers on the screen: at most `maxRatio` for one of the
 * page's, and at most `maxSide` a side.
 */
export function fitCanvas(canvas, maxRatio, maxSide) {
  const longSide = Math.max(canvas.clientWidth, canvas.clientHeight, 1);
  const ratio = Math.min(window.devicePixelRatio || 1, maxRatio, maxSide / longSide);
  const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  // Assigning a size clears the canvas, even if it is the same.
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
}
