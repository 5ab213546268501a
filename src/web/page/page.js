// The page: what effigy.js offers, with a pointer, a keyboard and some buttons.
import { Effigy, isSupported } from "./effigy.js";
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

function complain(error) {
  at("text").textContent = error.message ?? String(error);
  at("message").hidden = false;
}

/** Does something that takes a while, with a bar to show it. */
async function loading(what, act) {
  const bar = at("progress");
  at("what").textContent = what;
  bar.removeAttribute("value");
  at("loading").hidden = false;
  try {
    return await act((loaded, total) => { if (total) bar.value = loaded / total; });
  } catch (error) {
    complain(error);
  } finally {
    at("loading").hidden = true;
  }
}

async function open(files) {
  const list = [...files], ends = (ending) => (file) => file.name.toLowerCase().endsWith(ending);
  const others = list.filter((file) => !ends(".avatar")(file) && !ends(".motion")(file));
  if (others.length > 0) complain(new Error(`${others[0].name} is neither an .avatar nor a .motion file`));
  for (const file of list.filter(ends(".avatar"))) await loading(`Opening ${file.name}`, () => effigy.loadAvatar(file));
  for (const file of list.filter(ends(".motion"))) await loading(`Opening ${file.name}`, () => effigy.loadMotion(file));
}

function controls() {
  const play = () => (effigy.playing ? effigy.pause() : effigy.clips.length > 0 && effigy.play());
  const show = () => {
    at("play").textContent = effigy.playing ? "Pause" : "Play";
    at("play").setAttribute("aria-pressed", String(effigy.playing));
  };
  at("play").onclick = play;
  effigy.addEventListener("play", show);
  effigy.addEventListener("pause", show);
  at("time").oninput = () => { effigy.pause(); effigy.time = Number(at("time").value) * effigy.duration; };
  at("reset").onclick = () => { effigy.camera = { yaw: 0.35, pitch: 0.09 }; effigy.frameAvatar(); };
  at("full").onclick = () => (document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen());
  at("numbers").onclick = () => {
    at("overlay").hidden = !at("overlay").hidden;
    at("numbers").setAttribute("aria-pressed", String(!at("overlay").hidden));
  };
  at("shot").onclick = async () => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(await effigy.screenshot());
    link.download = "effigy.png";
    link.click();
    URL.revokeObjectURL(link.href);
  };
  at("file").onchange = () => open(at("file").files);
  at("close").onclick = () => { at("message").hidden = true; };
  at("canvas").addEventListener("keydown", (event) => {
    if (event.key === " ") { play(); event.preventDefault(); }
  });
  effigy.addEventListener("frame", () => {
    if (document.activeElement !== at("time")) at("time").value = effigy.duration > 0 ? effigy.time / effigy.duration : 0;
    at("clock").textContent = `${effigy.time.toFixed(1)} of ${effigy.duration.toFixed(1)} s`;
    if (!at("overlay").hidden) at("overlay").textContent = numbers();
  });
  effigy.addEventListener("error", (event) => complain(event.detail));
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
    return unsupported(error.message);
  }
  Object.assign(globalThis, { effigy });
  controls();
  orbit(effigy, at("canvas"));
  dropping();
  // Both at once; whatever has no avatar of its own moves the demo's clip.
  const motion = query.get("motion") ?? "demo.motion";
  const clip = fetch(motion);
  await loading("Loading the avatar", (progress) => effigy.loadAvatar(query.get("avatar") ?? "demo.avatar", { onProgress: progress }));
  await loading("Loading the motion", async () => {
    const response = await clip;
    if (!response.ok) throw new Error(`${motion} can't be loaded: the server says ${response.status}`);
    if (effigy.description.name) await effigy.loadMotion(await response.arrayBuffer());
  });
  if (query.get("bench")) document.body.append(Object.assign(document.createElement("pre"), { id: "bench", textContent: await bench(effigy, query) }));
  if ("serviceWorker" in navigator && location.protocol.startsWith("http")) navigator.serviceWorker.register("sw.js").catch(() => {});
}

main();
