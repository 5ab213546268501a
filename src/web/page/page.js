// The page: what effigy.js offers, with a pointer, a keyboard and some buttons.
import { Effigy, Unsupported, isSupported } from "./effigy.js";
import { orbit } from "./orbit.js";
import { bench } from "./bench.js";

const at = (id) => document.getElementById(id);
const query = new URLSearchParams(location.search);
let effigy;

function unsupported(why = "") {
  at("stage").hidden = true;
  document.querySelector("nav").hidden = true;
  at("why").textContent = why;
  at("unsupported").hidden = false;
}

/** Says on the page what went wrong; what was given up for something else did not. */
function complain(error) {
  if (error.name === "AbortError") return;
  at("text").textContent = error.message ?? String(error);
  at("message").hidden = false;
}

const under = new Set();

/** One bar for all that is under way. */
function progress() {
  const bar = at("progress"), all = [...under], what = all.at(-1)?.what ?? "";
  at("loading").hidden = all.length === 0;
  if (at("what").textContent !== what) at("what").textContent = what;
  if (all.length > 0 && all.every(({ share }) => share !== undefined)) bar.value = all.reduce((sum, { share }) => sum + share, 0) / all.length;
  else bar.removeAttribute("value");
}

/** Does something that takes a while, with a bar to show it. */
async function loading(what, act) {
  const entry = { what, share: undefined };
  under.add(entry);
  progress();
  try {
    return await act((loaded, total) => {
      entry.share = total ? loaded / total : undefined;
      progress();
    });
  } catch (error) {
    complain(error);
  } finally {
    under.delete(entry);
    progress();
  }
}

async function open(files) {
  const list = [...files], ends = (ending) => (file) => file.name.toLowerCase().endsWith(ending);
  const others = list.filter((file) => !ends(".avatar")(file) && !ends(".motion")(file));
  if (others.length > 0) complain(new Error(`${others[0].name} is neither an .avatar nor a .motion file`));
  const avatar = list.filter(ends(".avatar")).at(-1);
  const loads = avatar ? [loading(`Opening ${avatar.name}`, () => effigy.loadAvatar(avatar))] : [];
  const motion = (file) => loading(`Opening ${file.name}`, () => effigy.loadMotion(file));
  await Promise.all([...loads, ...list.filter(ends(".motion")).map(motion)]);
}

function controls() {
  const play = () => (effigy.playing ? effigy.pause() : effigy.clips.length > 0 && effigy.play());
  const show = () => {
    at("play").textContent = effigy.playing ? "Pause" : "Play";
  };
  at("play").onclick = play;
  effigy.addEventListener("play", show);
  effigy.addEventListener("pause", show);
  at("time").oninput = () => {
    effigy.pause();
    effigy.time = Number(at("time").value) * effigy.duration;
    clock(true);
  };
  at("reset").onclick = () => { effigy.camera = { yaw: 0.35, pitch: 0.09 }; effigy.frameAvatar(); };
  at("full").onclick = () => (document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen());
  at("numbers").onclick = () => {
    at("overlay").hidden = !at("overlay").hidden;
    at("numbers").setAttribute("aria-pressed", String(!at("overlay").hidden));
  };
  at("shot").onclick = () => effigy.screenshot().then((picture) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(picture);
    link.download = "effigy.png";
    link.click();
    URL.revokeObjectURL(link.href);
  }, complain);
  at("file").onchange = () => {
    open(at("file").files);
    // The same file may be opened twice.
    at("file").value = "";
  };
  at("close").onclick = () => { at("message").hidden = true; };
  at("canvas").addEventListener("keydown", (event) => {
    if (event.key === " ") { play(); event.preventDefault(); }
  });
  // Ten times a second is as often as anyone reads.
  let told = 0;
  effigy.addEventListener("frame", () => {
    const now = performance.now();
    if (now - told < 100 && effigy.playing) return;
    told = now;
    clock(document.activeElement === at("time"));
    if (!at("overlay").hidden) at("overlay").textContent = numbers();
  });
  effigy.addEventListener("error", (event) => complain(event.detail));
}

/** Shows the time; `held`: the slider is in someone's hands. */
function clock(held) {
  const text = `${effigy.time.toFixed(1)} of ${effigy.duration.toFixed(1)} s`, slider = at("time");
  at("clock").textContent = text;
  if (!held) slider.value = effigy.duration > 0 ? effigy.time / effigy.duration : 0;
  slider.setAttribute("aria-valuetext", `${effigy.time.toFixed(1)} of ${effigy.duration.toFixed(1)} seconds`);
}

function numbers() {
  const { fps, frameMs, p95Ms, stages = {}, counters = {}, device, raster } = effigy.statistics, ms = (value) => `${(value ?? 0).toFixed(1)} ms`;
  const lines = [`${device}, ${raster}`, `${fps.toFixed(1)} fps, ${ms(frameMs)}, 95 % within ${ms(p95Ms)}`];
  for (const [stage, time] of Object.entries(stages)) lines.push(`${stage.padEnd(10)}${ms(time).padStart(10)}`);
  lines.push(`${counters.gaussians ?? 0} Gaussians, ${counters.drawn ?? 0} drawn`);
  return lines.join("\n");
}

function dropping() {
  const files = (event) => event.dataTransfer?.types.includes("Files");
  addEventListener("dragover", (event) => { if (files(event)) { event.preventDefault(); at("drop").hidden = false; } });
  addEventListener("dragleave", (event) => { if (!event.relatedTarget) at("drop").hidden = true; });
  addEventListener("drop", (event) => {
    if (!files(event)) return;
    event.preventDefault();
    at("drop").hidden = true;
    open(event.dataTransfer.files);
  });
}

async function main() {
  if (!isSupported()) return unsupported();
  try {
    effigy = await Effigy.create(at("canvas"));
  } catch (error) {
    if (error instanceof Unsupported) return unsupported(error.message);
    progress();
    return complain(error);
  }
  Object.assign(globalThis, { effigy });
  controls();
  orbit(effigy, at("canvas"));
  dropping();
  // Both at once; whatever has no avatar of its own moves the demo's clip.
  await Promise.all([
    loading("Loading the avatar", (onProgress) => effigy.loadAvatar(query.get("avatar") ?? "demo.avatar", { onProgress })),
    loading("Loading the motion", (onProgress) => effigy.loadMotion(query.get("motion") ?? "demo.motion", { onProgress })),
  ]);
  if (query.get("bench")) {
    const textContent = await bench(effigy, query).catch((error) => error.message);
    document.body.append(Object.assign(document.createElement("pre"), { id: "bench", textContent }));
  }
  if ("serviceWorker" in navigator && location.protocol.startsWith("http")) navigator.serviceWorker.register("sw.js").catch(() => {});
}

main();
