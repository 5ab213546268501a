// The page: an avatar with controls for pointers, keys and buttons.
import { bench } from "./bench.js";
import { DEFAULT_CAMERA } from "./camera.js";
import { Effigy, Unsupported, isSupported, kindOf } from "./effigy.js";
import { orbitControls } from "./orbit.js";

/** Time between updates of the page's numbers, ms: faster ones can't be read. */
const UPDATE_MS = 100;

const element = (id) => document.getElementById(id);
const query = new URLSearchParams(location.search);
let effigy;

function showUnsupported(reason = "") {
  element("stage").hidden = true;
  document.querySelector("nav").hidden = true;
  element("why").textContent = reason;
  element("unsupported").hidden = false;
}

/** Shows an error. Calls that were given up for another one are none. */
function showError(error) {
  if (error.name === "AbortError") return;
  element("text").textContent = error.message ?? String(error);
  element("message").hidden = false;
}

/** Shows what a file of another program left open. */
function showNotes({ name, notes }) {
  for (const note of notes) {
    const line = document.createElement("li");
    line.textContent = `${name}: ${note}`;
    element("notes-list").append(line);
  }
  if (notes.length > 0) element("notes").hidden = false;
}

function closeNotes() {
  element("notes").hidden = true;
  element("notes-list").replaceChildren();
}

/** Loads under way: what to call each, and the share of it that has arrived, if known. */
const loads = new Set();

/** Shows one bar for all loads. */
function showProgress() {
  const bar = element("progress");
  const all = [...loads];
  const what = all.at(-1)?.what ?? "";
  element("loading").hidden = all.length === 0;
  // Screen readers announce every assignment.
  if (element("what").textContent !== what) element("what").textContent = what;
  if (all.length > 0 && all.every((load) => load.share !== undefined)) {
    bar.value = all.reduce((sum, load) => sum + load.share, 0) / all.length;
  } else {
    bar.removeAttribute("value");
  }
}

/** Calls `act(onProgress)`, and shows a bar until it is done. Errors are shown. */
async function withProgress(what, act) {
  const load = { what, share: undefined };
  loads.add(load);
  showProgress();
  try {
    await act((loaded, total) => {
      load.share = total ? loaded / total : undefined;
      showProgress();
    });
  } catch (error) {
    showError(error);
  } finally {
    loads.delete(load);
    showProgress();
  }
}

/** Opens the last of some avatars, and all clips, told apart by their content. */
async function openFiles(files) {
  const found = { avatar: [], motion: [], unknown: [] };
  const sort = async (file) => found[await kindOf(file)].push(file);
  // A list of the page's own: that of an input is emptied meanwhile.
  const all = [...files];
  await withProgress("Opening files", () => Promise.all(all.map(sort)));
  const [unknown] = found.unknown;
  if (unknown) {
    showError(new Error(`${unknown.name} is neither an avatar nor motion of a known format`));
  }

  const opened = [];
  const avatar = found.avatar.at(-1);
  if (avatar) {
    opened.push(withProgress(`Opening ${avatar.name}`, () => effigy.loadAvatar(avatar)));
  }
  for (const motion of found.motion) {
    opened.push(withProgress(`Opening ${motion.name}`, () => effigy.loadMotion(motion)));
  }
  await Promise.all(opened);
}

function togglePlaying() {
  if (effigy.playing) effigy.pause();
  else if (effigy.clips.length > 0) effigy.play();
}

function toggleFullScreen() {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen();
}

async function saveScreenshot() {
  try {
    const image = await effigy.screenshot();
    const link = document.createElement("a");
    link.href = URL.createObjectURL(image);
    link.download = "effigy.png";
    link.click();
    URL.revokeObjectURL(link.href);
  } catch (error) {
    showError(error);
  }
}

function connectControls() {
  const showPlaying = () => {
    element("play").textContent = effigy.playing ? "Pause" : "Play";
  };
  effigy.addEventListener("play", showPlaying);
  effigy.addEventListener("pause", showPlaying);
  element("play").onclick = togglePlaying;
  element("time").oninput = () => {
    effigy.pause();
    effigy.time = Number(element("time").value) * effigy.duration;
    showTime({ isSliderHeld: true });
  };
  element("reset").onclick = () => {
    effigy.camera = { yaw: DEFAULT_CAMERA.yaw, pitch: DEFAULT_CAMERA.pitch };
    effigy.frameAvatar();
  };
  element("full").onclick = toggleFullScreen;
  element("numbers").onclick = () => {
    const overlay = element("overlay");
    overlay.hidden = !overlay.hidden;
    element("numbers").setAttribute("aria-pressed", String(!overlay.hidden));
  };
  element("shot").onclick = saveScreenshot;
  element("file").onchange = () => {
    openFiles(element("file").files);
    // Without this the same file could not be opened again.
    element("file").value = "";
  };
  element("close").onclick = () => {
    element("message").hidden = true;
  };
  element("notes-close").onclick = closeNotes;
  element("canvas").addEventListener("keydown", (event) => {
    if (event.key === " ") {
      togglePlaying();
      event.preventDefault();
    }
  });
  effigy.addEventListener("error", (event) => showError(event.detail));
  effigy.addEventListener("import", (event) => showNotes(event.detail));
}

/** Shows the time and the statistics of the frames that are drawn. */
function connectNumbers() {
  let lastUpdate = 0;
  effigy.addEventListener("frame", () => {
    const now = performance.now();
    if (now - lastUpdate < UPDATE_MS && effigy.playing) return;
    lastUpdate = now;
    showTime({ isSliderHeld: document.activeElement === element("time") });
    const overlay = element("overlay");
    if (!overlay.hidden) overlay.textContent = statisticsText();
  });
}

/** Shows the time. A slider that the user holds stays where it is. */
function showTime({ isSliderHeld }) {
  const slider = element("time");
  const text = `${effigy.time.toFixed(1)} of ${effigy.duration.toFixed(1)}`;
  element("clock").textContent = `${text} s`;
  if (!isSliderHeld) slider.value = effigy.duration > 0 ? effigy.time / effigy.duration : 0;
  slider.setAttribute("aria-valuetext", `${text} seconds`);
}

function statisticsText() {
  const { fps, frameMs, p95Ms, stages = {}, counters = {}, device, raster } = effigy.statistics;
  const milliseconds = (value) => `${(value ?? 0).toFixed(1)} ms`;
  const lines = [
    `${device}, ${raster}`,
    `${fps.toFixed(1)} fps, ${milliseconds(frameMs)}, 95 % within ${milliseconds(p95Ms)}`,
  ];
  for (const [stage, time] of Object.entries(stages)) {
    lines.push(`${stage.padEnd(10)}${milliseconds(time).padStart(10)}`);
  }
  lines.push(`${counters.gaussians ?? 0} Gaussians, ${counters.drawn ?? 0} drawn`);
  const { supersampled, most_samples: samples, coarsest_level: level } = counters;
  if (supersampled) {
    const ofLevel = level > 0 ? `, level ${level}` : "";
    lines.push(`small: up to ${samples} × ${samples} samples a pixel${ofLevel}`);
  }
  return lines.join("\n");
}

/** Opens files that are dropped on the page. */
function connectDropping() {
  const hasFiles = (event) => event.dataTransfer?.types.includes("Files");
  addEventListener("dragover", (event) => {
    if (hasFiles(event)) {
      event.preventDefault();
      element("drop").hidden = false;
    }
  });
  addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) element("drop").hidden = true;
  });
  addEventListener("drop", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    element("drop").hidden = true;
    openFiles(event.dataTransfer.files);
  });
}

/** Measures, and appends the report to the page. */
async function showBench() {
  const report = document.createElement("pre");
  report.id = "bench";
  report.textContent = await bench(effigy, query).catch((error) => error.message);
  document.body.append(report);
}

/** Opens what the address names, or the demo. */
async function openFirst() {
  const avatar = query.get("avatar") ?? "demo.avatar";
  const motion = query.get("motion") ?? "demo.motion";
  const loadMotion = () =>
    withProgress("Loading the motion", (onProgress) => effigy.loadMotion(motion, { onProgress }));
  const loaded = withProgress("Loading the avatar", (onProgress) =>
    effigy.loadAvatar(avatar, { onProgress }),
  );
  if (query.has("avatar") && !query.has("motion")) {
    // The demo's clip is not for splats, which have one joint.
    await loaded;
    if (effigy.description.joints?.length > 1) await loadMotion();
  } else {
    // At the same time: the clip waits for the avatar.
    await Promise.all([loaded, loadMotion()]);
  }
}

async function main() {
  if (!isSupported()) {
    showUnsupported();
    return;
  }
  try {
    const options = {};
    for (const name of ["supersample", "detail"]) {
      if (query.has(name)) options[name] = query.get(name);
    }
    effigy = await Effigy.create(element("canvas"), options);
  } catch (error) {
    if (error instanceof Unsupported) {
      showUnsupported(error.message);
    } else {
      showProgress();
      showError(error);
    }
    return;
  }
  // For the browser's console, and for tests.
  globalThis.effigy = effigy;
  connectControls();
  connectNumbers();
  connectDropping();
  orbitControls(effigy, element("canvas"));

  await openFirst();
  if (query.get("bench")) await showBench();
  if ("serviceWorker" in navigator && location.protocol.startsWith("http")) {
    // Without it the page needs a network, and nothing else changes.
    navigator.serviceWorker.register("sw.js").catch(() => {});
  }
}

main();
