// Orbit, zoom and pan by mouse, touch and keys.

/** Lets a canvas's pointers and keys move an avatar's camera. */
export function orbit(effigy, canvas) {
  const pointers = new Map();
  const turn = (dx, dy) => {
    const { yaw, pitch } = effigy.camera, scale = Math.PI / canvas.clientHeight;
    effigy.camera = { yaw: yaw - dx * scale, pitch: Math.min(Math.max(pitch + dy * scale, -1.5), 1.5) };
  };
  const zoom = (factor) => { effigy.camera = { distance: Math.min(Math.max(effigy.camera.distance * factor, 0.15), 100) }; };
  const pan = (dx, dy) => {
    const { target: [x, y, z], yaw, pitch, distance, fov } = effigy.camera;
    const meters = (2 * distance * Math.tan(fov / 2)) / canvas.clientHeight, up = dy * meters, right = dx * meters;
    const lean = Math.sin(pitch) * up;
    effigy.camera = {
      target: [x - Math.cos(yaw) * right - Math.sin(yaw) * lean, y + Math.cos(pitch) * up, z + Math.sin(yaw) * right - Math.cos(yaw) * lean],
    };
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const dx = event.clientX - before.clientX, dy = event.clientY - before.clientY;
    if (pointers.size >= 2) {
      const other = [...pointers.values()].find((pointer) => pointer.pointerId !== event.pointerId);
      const apart = (pointer) => Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY) || 1;
      zoom(apart(before) / apart(event));
      pan(dx / 2, dy / 2);
    } else if (event.shiftKey || event.buttons & 6) pan(dx, dy);
    else turn(dx, dy);
    pointers.set(event.pointerId, event);
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(event.deltaY * (event.deltaMode === 1 ? 0.03 : 0.001)));
  }, { passive: false });
  const arrow = (right, down) => (shift) => (shift ? pan(40 * right, 40 * down) : turn(-40 * right, -40 * down));
  const keys = {
    ArrowLeft: arrow(-1, 0), ArrowRight: arrow(1, 0), ArrowUp: arrow(0, -1), ArrowDown: arrow(0, 1),
    "+": () => zoom(0.9), "=": () => zoom(0.9), "-": () => zoom(1 / 0.9), r: () => effigy.frameAvatar(),
  };
  canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    keys[event.key](event.shiftKey);
    event.preventDefault();
  });
}
