// Orbits, zooms and pans the camera with mouse, fingers and keys.
import { radius } from "./camera.js";

const PITCH_MAX = 1.5;
/** Nearest and furthest distance, in radii of the avatar's box. */
const DISTANCE_MIN = 0.15;
const DISTANCE_MAX = 100;
/** How far an arrow key moves, px of a drag. */
const KEY_STEP = 40;
const KEY_ZOOM = 0.9;
/** Logarithm of the zoom of one px, and of one line, of scrolling. */
const ZOOM_PER_PX = 0.001;
const ZOOM_PER_LINE = 0.03;
/** Right and middle button, in `event.buttons`. */
const PAN_BUTTONS = 2 | 4;

const clamp = (value, min, max) => Math.min(Math.max(value, min), max);

/** Lets a canvas's pointers and keys move an avatar's camera. */
export function orbitControls(effigy, canvas) {
  /** Orbits by a drag, px. */
  const turn = (dx, dy) => {
    const { yaw, pitch } = effigy.camera;
    const radiansPerPx = Math.PI / canvas.clientHeight;
    effigy.camera = {
      yaw: yaw - dx * radiansPerPx,
      pitch: clamp(pitch + dy * radiansPerPx, -PITCH_MAX, PITCH_MAX),
    };
  };

  /** Multiplies the distance. */
  const zoom = (factor) => {
    const size = radius(effigy.description.bounds);
    const [min, max] = [DISTANCE_MIN * size, DISTANCE_MAX * size];
    const distance = clamp(effigy.camera.distance * factor, min, max);
    effigy.camera = { distance };
  };

  /** Moves the target with a drag, px. */
  const pan = (dx, dy) => {
    const { target, yaw, pitch, distance, fov } = effigy.camera;
    const metresPerPx = (2 * distance * Math.tan(fov / 2)) / canvas.clientHeight;
    const right = dx * metresPerPx;
    const up = dy * metresPerPx;
    // The image's up leans back by the pitch.
    const back = Math.sin(pitch) * up;
    effigy.camera = {
      target: [
        target[0] - Math.cos(yaw) * right - Math.sin(yaw) * back,
        target[1] + Math.cos(pitch) * up,
        target[2] + Math.sin(yaw) * right - Math.cos(yaw) * back,
      ],
    };
  };

  pointerControls(canvas, { turn, zoom, pan });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const isInLines = event.deltaMode === WheelEvent.DOM_DELTA_LINE;
      zoom(Math.exp(event.deltaY * (isInLines ? ZOOM_PER_LINE : ZOOM_PER_PX)));
    },
    { passive: false },
  );

  const arrow = (right, down) => (shift) => {
    if (shift) pan(KEY_STEP * right, KEY_STEP * down);
    else turn(-KEY_STEP * right, -KEY_STEP * down);
  };
  const keys = {
    ArrowLeft: arrow(-1, 0),
    ArrowRight: arrow(1, 0),
    ArrowUp: arrow(0, -1),
    ArrowDown: arrow(0, 1),
    "+": () => zoom(KEY_ZOOM),
    "=": () => zoom(KEY_ZOOM),
    "-": () => zoom(1 / KEY_ZOOM),
    r: () => effigy.frameAvatar(),
  };
  canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    keys[event.key](event.shiftKey);
    event.preventDefault();
  });
}

/** One pointer turns, or pans with Shift or another button. Two zoom and pan. */
function pointerControls(canvas, { turn, zoom, pan }) {
  /** The last event of each pointer that is down, by its id. */
  const pointers = new Map();
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const dx = event.clientX - before.clientX;
    const dy = event.clientY - before.clientY;
    if (pointers.size >= 2) {
      const other = [...pointers.values()].find((pointer) => pointer.pointerId !== event.pointerId);
      const distance = (pointer) =>
        Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY) || 1;
      zoom(distance(before) / distance(event));
      // The middle of two fingers moves half as far as one of them.
      pan(dx / 2, dy / 2);
    } else if (event.shiftKey || event.buttons & PAN_BUTTONS) {
      pan(dx, dy);
    } else {
      turn(dx, dy);
    }
    pointers.set(event.pointerId, event);
  });
}
