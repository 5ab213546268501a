// `?bench=1`: the clip once around, every frame a new pose, as fast as the browser draws.

const spread = (times) => {
  const sorted = [...times].sort((a, b) => a - b), at = (share) => sorted[Math.round(share * (sorted.length - 1))];
  return { mean: times.reduce((sum, time) => sum + time, 0) / times.length, median: at(0.5), p5: at(0.05), p95: at(0.95), p99: at(0.99) };
};

/** Gives a report like that of `effigy bench --json`. `frames` in the query says how many are timed. */
export async function bench(effigy, query) {
  const frames = Number(query.get("frames") ?? 24), warmUp = 3;
  effigy.pause();
  const times = [], stages = {};
  let last;
  for (let frame = -warmUp; frame < frames; ++frame) {
    const drawn = new Promise((resolve) => effigy.addEventListener("frame", resolve, { once: true }));
    effigy.camera = { yaw: (Math.PI / 2) * (Math.abs(frame) % 4) + 0.31 };
    effigy.time = (effigy.duration * Math.max(frame, 0)) / frames;
    await drawn;
    const now = performance.now();
    if (frame >= 0) {
      times.push(now - last);
      for (const [stage, ms] of Object.entries(effigy.statistics.stages ?? {})) (stages[stage] ??= []).push(ms);
    }
    last = now;
  }
  const { device, raster, counters } = effigy.statistics, canvas = document.getElementById("canvas"), frameMs = spread(times);
  return JSON.stringify({
    schema: "effigy-bench-2",
    device: { name: device, driver: navigator.userAgent, backend: "webgpu", timestamps: Object.keys(stages).length > 0 },
    avatar: { name: effigy.description.name, gaussians: effigy.description.gaussians },
    size: [canvas.width, canvas.height],
    options: { raster },
    cases: [{
      name: "full", frames, frame_ms: frameMs, fps: 1000 / frameMs.mean, counters,
      stages: Object.entries(stages).map(([name, ms]) => ({ name, ms: spread(ms) })),
    }],
  }, null, 2);
}
