// `?bench=1`: draws the clip once, every frame with a new pose and from another side, as fast as the
// browser draws.

const DEFAULT_FRAMES = 24;
const MAX_FRAMES = 10_000;
const WARM_UP_FRAMES = 3;

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** Mean and percentiles of some times. Null if there are none. */
function distribution(times) {
  if (times.length === 0) return null;
  const sorted = [...times].sort((a, b) => a - b);
  const percentile = (share) => sorted[Math.round(share * (sorted.length - 1))];
  return {
    mean: mean(times),
    median: percentile(0.5),
    p5: percentile(0.05),
    p95: percentile(0.95),
    p99: percentile(0.99),
  };
}

/** Applies a change and waits for its frame. Resolves with the statistics. */
function drawFrame(effigy, change) {
  return new Promise((resolve, reject) => {
    const onFrame = () => {
      effigy.removeEventListener("error", onError);
      resolve(effigy.statistics);
    };
    const onError = (event) => {
      effigy.removeEventListener("frame", onFrame);
      reject(event.detail);
    };
    effigy.addEventListener("frame", onFrame, { once: true });
    effigy.addEventListener("error", onError, { once: true });
    change();
  });
}

/** Means of the counters that all frames have. */
function meanCounters(counters) {
  const means = {};
  for (const name of Object.keys(counters[0] ?? {})) {
    if (counters.every((frame) => name in frame)) {
      means[name] = mean(counters.map((frame) => frame[name]));
    }
  }
  return means;
}

/** The sum of all stages for each frame, ms. Empty if no stage was timed in every frame. */
function gpuTimes(stages, frames) {
  const complete = Object.values(stages).filter((times) => times.length === frames);
  if (complete.length === 0) return [];
  return Array.from({ length: frames }, (_, frame) =>
    complete.reduce((sum, times) => sum + times[frame], 0),
  );
}

/** Draws the frames. Returns what was measured of each. */
async function measure(effigy, frames) {
  const times = [];
  const stages = {};
  const counters = [];
  let last;
  let statistics;
  for (let frame = -WARM_UP_FRAMES; frame < frames; ++frame) {
    statistics = await drawFrame(effigy, () => {
      effigy.camera = { yaw: (Math.PI / 2) * (Math.abs(frame) % 4) + 0.31 };
      effigy.time = (effigy.duration * Math.max(frame, 0)) / frames;
    });
    const now = performance.now();
    if (frame >= 0) {
      times.push(now - last);
      counters.push(statistics.counters ?? {});
      for (const [stage, ms] of Object.entries(statistics.stages ?? {})) {
        stages[stage] ??= [];
        stages[stage].push(ms);
      }
    }
    last = now;
  }
  return { times, stages, counters, statistics };
}

/**
 * Returns a report that `effigy compare` reads, as JSON. The query's `frames` is how many are timed.
 * Values that a page can't measure are null.
 */
export async function bench(effigy, query) {
  const { name, gaussians, parts, nodes, rows } = effigy.description;
  if (!name) throw new Error("there is nothing to measure: no avatar was loaded");
  const requested = Math.round(Number(query.get("frames") ?? DEFAULT_FRAMES)) || DEFAULT_FRAMES;
  const frames = Math.min(Math.max(requested, 1), MAX_FRAMES);
  effigy.pause();
  const { times, stages, counters, statistics } = await measure(effigy, frames);

  const canvas = document.getElementById("canvas");
  const frameMs = distribution(times);
  const gpuMs = gpuTimes(stages, frames);
  const noBytes = { bytes: null, bytes_floor: null };
  const report = {
    schema: "effigy-bench-2",
    program: {
      version: statistics.version,
      commit: null,
      date: new Date().toISOString(),
      command: [location.href],
    },
    device: {
      name: statistics.device,
      driver: navigator.userAgent,
      vulkan: "",
      subgroup_size: 0,
      timestamps: gpuMs.length > 0,
      backend: "webgpu",
    },
    avatar: { name, clip: effigy.clips[effigy.clip]?.name ?? "", gaussians, parts, nodes, rows },
    size: [canvas.width, canvas.height],
    options: statistics.options,
    cases: [
      {
        name: "full",
        frames,
        frame_ms: frameMs,
        fps: 1000 / frameMs.mean,
        gpu_ms: distribution(gpuMs),
        stages: Object.entries(stages).map(([name, ms]) => ({
          name,
          ms: distribution(ms),
          ran: ms.length / frames,
          ...noBytes,
          operations: null,
          operations_floor: null,
        })),
        ...noBytes,
        counters: meanCounters(counters),
        covered_pixels: null,
        fragments_a_pixel: null,
        gpu_memory_bytes: null,
        gpu_memory_used_bytes: null,
        error: null,
      },
    ],
    sweep: null,
  };
  return JSON.stringify(report, null, 2);
}
