// `?bench=1`: the clip once around, every frame a new pose, as fast as the browser draws.

const spread = (times) => {
  if (times.length === 0) return null;
  const sorted = [...times].sort((a, b) => a - b), at = (share) => sorted[Math.round(share * (sorted.length - 1))];
  return { mean: times.reduce((sum, time) => sum + time, 0) / times.length, median: at(0.5), p5: at(0.05), p95: at(0.95), p99: at(0.99) };
};

/** The next frame, or what hinders it. */
const drawn = (effigy, change) => new Promise((resolve, reject) => {
  const failed = (event) => { effigy.removeEventListener("frame", done); reject(event.detail); };
  const done = () => { effigy.removeEventListener("error", failed); resolve(effigy.statistics); };
  effigy.addEventListener("frame", done, { once: true });
  effigy.addEventListener("error", failed, { once: true });
  change();
});

/** Means of what all frames have. */
function means(counters) {
  const names = Object.keys(counters[0] ?? {}).filter((name) => counters.every((frame) => name in frame));
  return Object.fromEntries(names.map((name) => [name, counters.reduce((sum, frame) => sum + frame[name], 0) / counters.length]));
}

/** Gives a report that `effigy compare` reads. `frames` in the query says how many are timed. What nobody counts here is null. */
export async function bench(effigy, query) {
  const { name, gaussians, parts, nodes, rows } = effigy.description;
  if (!name) throw new Error("there is nothing to measure: no avatar was loaded");
  const frames = Math.min(Math.max(Math.round(Number(query.get("frames") ?? 24)) || 24, 1), 10_000), warmUp = 3;
  effigy.pause();
  const times = [], stages = {}, counters = [];
  let last, statistics;
  for (let frame = -warmUp; frame < frames; ++frame) {
    statistics = await drawn(effigy, () => {
      effigy.camera = { yaw: (Math.PI / 2) * (Math.abs(frame) % 4) + 0.31 };
      effigy.time = (effigy.duration * Math.max(frame, 0)) / frames;
    });
    const now = performance.now();
    if (frame >= 0) {
      times.push(now - last);
      counters.push(statistics.counters ?? {});
      for (const [stage, ms] of Object.entries(statistics.stages ?? {})) (stages[stage] ??= []).push(ms);
    }
    last = now;
  }
  const canvas = document.getElementById("canvas"), frameMs = spread(times), none = { bytes: null, bytes_floor: null };
  const all = Object.values(stages).filter((times) => times.length === frames);
  const gpu = all.length > 0 ? times.map((_, frame) => all.reduce((sum, times) => sum + times[frame], 0)) : [];
  const report = {
    schema: "effigy-bench-2",
    program: { version: statistics.version, commit: null, date: new Date().toISOString(), command: [location.href] },
    device: {
      name: statistics.device, driver: navigator.userAgent, vulkan: "", half_storage: false, subgroup_size: 0,
      timestamps: all.length > 0, backend: "webgpu",
    },
    avatar: { name, clip: effigy.clips[effigy.clip]?.name ?? "", gaussians, parts, nodes, rows },
    size: [canvas.width, canvas.height],
    options: statistics.options,
    cases: [{
      name: "full", frames, frame_ms: frameMs, fps: 1000 / frameMs.mean, gpu_ms: spread(gpu),
      stages: Object.entries(stages).map(([name, ms]) => ({
        name, ms: spread(ms), ran: ms.length / frames, ...none, operations: null, operations_floor: null,
      })),
      ...none, counters: means(counters), covered_pixels: null, fragments_a_pixel: null,
      gpu_memory_bytes: null, gpu_memory_used_bytes: null, error: null,
    }],
    sweep: null,
  };
  return JSON.stringify(report, null, 2);
}
