// The API: what a page may do with it, and what must not harm it.
import assert from "node:assert/strict";
import { openBare, waitForFrames, openMoving, openPage } from "./harness.mjs";

/** Calls made while the device is lost take effect. */
async function callsTakeEffectWhileLost(page) {
  const found = await page.evaluate(async () => {
    const joints = effigy.description.joints.length;
    let calls = 0;
    let over = false;
    const restored = event("restored").then(() => {
      over = true;
    });
    effigy.loseDevice();
    const shot = effigy.screenshot();
    while (!over) {
      effigy.camera = { yaw: 1 + 0.001 * ++calls };
      effigy.setPose({ rotation: new Float32Array(3 * joints) });
      effigy.background = [0, 0, 0];
      effigy.time = 0.5;
      effigy.frameAvatar();
      effigy.statistics;
      await new Promise((resolve) => setTimeout(resolve, 1));
    }
    await restored;
    const { data } = await pixels(await shot);
    effigy.loseDevice();
    const lost = event("lost");
    const pending = failure(effigy.screenshot());
    await lost;
    effigy.dispose();
    effigy.dispose();
    return {
      calls,
      corner: [...data.slice(0, 3)],
      pending: await pending,
      after: await failure(effigy.loadAvatar("demo.avatar")),
    };
  });
  assert.ok(found.calls > 1, `${found.calls} calls`);
  assert.deepEqual([found.corner, found.pending, found.after], [[0, 0, 0], "Error", "Error"]);
}

export const api = {
  async "a device lost at rest comes back with the same image, and calls meanwhile take effect"() {
    const page = await openBare();
    const found = await page.evaluate(async () => {
      await effigy.loadAvatar("demo.avatar");
      await effigy.loadMotion("demo.motion", { play: false });
      effigy.time = 1.3;
      await effigy.screenshot();
      const before = await pixels(await effigy.screenshot());
      const restored = event("restored");
      effigy.loseDevice();
      await restored;
      await event("frame");
      const after = await pixels(await effigy.screenshot());
      return { covered: covered(before), different: different(before, after), time: effigy.time };
    });
    assert.ok(
      found.covered > 2000 && found.different === 0 && found.time === 1.3,
      JSON.stringify(found),
    );
    await callsTakeEffectWhileLost(page);
    return page;
  },
  async "a device that does not come back is an error, and loading an avatar tries again"() {
    const page = await openBare();
    const found = await page.evaluate(async () => {
      await effigy.loadAvatar("demo.avatar");
      const ask = GPU.prototype.requestAdapter;
      let asked = 0;
      GPU.prototype.requestAdapter = async () => {
        ++asked;
        return null;
      };
      const gone = event("error");
      const since = performance.now();
      effigy.loseDevice();
      const why = (await gone).detail.message;
      const took = performance.now() - since;
      const shot = await failure(effigy.screenshot());
      effigy.camera = { yaw: 1 };
      GPU.prototype.requestAdapter = ask;
      await effigy.loadAvatar("demo.avatar");
      const again = covered(await pixels(await effigy.screenshot()));
      // A device that is lost repeatedly.
      const error = event("error").then((event) => event.detail.message);
      let restored = 0;
      effigy.addEventListener("restored", () => {
        ++restored;
        effigy.loseDevice();
      });
      effigy.loseDevice();
      return { why, asked, took, shot, again, error: await error, restored };
    });
    assert.ok(found.asked >= 4 && found.took > 2000, JSON.stringify(found));
    assert.ok(
      /no WebGPU device/.test(found.why) && found.shot === "Error" && found.again > 2000,
      JSON.stringify(found),
    );
    assert.ok(/5 times/.test(found.error) && found.restored === 3, JSON.stringify(found));
    return page;
  },
  async "a small avatar is drawn larger, from a level of its file, unless options say otherwise"() {
    const page = await openBare();
    const found = await page.evaluate(async () => {
      const { Effigy } = await import("./effigy.js");
      const refused = [];
      for (const options of [{ supersample: 3 }, { detail: "none" }]) {
        refused.push(await failure(Effigy.create(document.createElement("canvas"), options)));
      }
      // Counts are of a frame that the device has finished, at most two frames old.
      const seen = async (of) => {
        for (let k = 0; k < 4; ++k) {
          of.camera = { yaw: of.camera.yaw + 0.01 };
          await event("frame", of);
          await new Promise((resolve) => setTimeout(resolve, 300));
        }
        const { counters, options } = of.statistics;
        return {
          supersampled: counters.supersampled,
          samples: counters.most_samples,
          level: counters.coarsest_level,
          skipped: counters.skipped_by_detail,
          option: options.supersample,
        };
      };
      const large = { distance: 0.5 };
      const small = { distance: 20 };
      await effigy.loadAvatar("levels.avatar");
      effigy.camera = small;
      const first = await seen(effigy);
      const image = await pixels(await effigy.screenshot());
      effigy.camera = large;
      const near = await seen(effigy);
      effigy.camera = small;
      const again = await seen(effigy);
      // The levels are drawn with another device, too.
      const restored = event("restored");
      effigy.loseDevice();
      await restored;
      const after = await seen(effigy);
      const canvas = document.createElement("canvas");
      canvas.style = "width: 200px; height: 260px";
      document.body.append(canvas);
      const other = await Effigy.create(canvas, { supersample: 1, detail: "1/2" });
      await other.loadAvatar("levels.avatar");
      other.camera = small;
      return {
        refused,
        first,
        near,
        again,
        after,
        other: await seen(other),
        covered: covered(image),
      };
    });
    assert.deepEqual(found.refused, ["RangeError", "RangeError"], JSON.stringify(found));
    for (const small of [found.first, found.again, found.after]) {
      assert.ok(
        small.supersampled === 1 && small.samples === 4 && small.level > 0 && small.skipped > 0,
        JSON.stringify(found),
      );
    }
    assert.deepEqual([found.near.supersampled, found.near.level], [0, 0], JSON.stringify(found));
    assert.deepEqual(
      [found.other.supersampled, found.other.option, found.other.skipped > 0],
      [0, "1", true],
      JSON.stringify(found),
    );
    assert.ok(found.covered > 0, JSON.stringify(found));
    return page;
  },
  async "invalid numbers are refused, and playback goes on"() {
    const page = await openMoving();
    const found = await page.evaluate(() => {
      const joints = effigy.description.joints.length;
      const rotation = new Float32Array(3 * joints);
      const before = effigy.camera;
      const bad = {
        distance: () => {
          effigy.camera = { distance: NaN };
        },
        fov: () => {
          effigy.camera = { fov: 0 };
        },
        target: () => {
          effigy.camera = { target: [0, Infinity, 0] };
        },
        yaw: () => {
          effigy.camera = { yaw: "1" };
        },
        time: () => {
          effigy.time = NaN;
        },
        rate: () => {
          effigy.rate = Infinity;
        },
        background: () => {
          effigy.background = [0, 2, 0];
        },
        translation: () => effigy.setPose({ rotation, translation: [0, 1e16, 0] }),
        rotation: () => effigy.setPose({ rotation: rotation.map(() => NaN) }),
        length: () => effigy.setPose({ rotation: [1, 2] }),
      };
      const name = (act) => {
        try {
          act();
          return "taken";
        } catch (error) {
          return error.name;
        }
      };
      const named = Object.entries(bad)
        .filter(([, act]) => name(act) !== "RangeError")
        .map(([what]) => what);
      return {
        named,
        same: JSON.stringify(before) === JSON.stringify(effigy.camera),
        playing: effigy.playing,
        time: effigy.time,
      };
    });
    assert.deepEqual([found.named, found.same, found.playing], [[], true, true]);
    assert.ok(Number.isFinite(found.time));
    await waitForFrames(page, 3);
    return page;
  },
  async "the last of several loads wins, and clips stay with their avatar"() {
    const page = await openBare();
    const found = await page.evaluate(async () => {
      const first = failure(effigy.loadAvatar("demo.avatar?ms=3000"));
      const clip = failure(effigy.loadMotion("demo.motion"));
      const second = effigy.loadAvatar("other.avatar");
      const named = [await first, await clip, (await second).name, effigy.clips.length];
      let open;
      const gate = new Promise((resolve) => {
        open = resolve;
      });
      class Late extends Blob {
        arrayBuffer() {
          return gate.then(() => super.arrayBuffer());
        }
      }
      const slow = failure(
        effigy.loadMotion(new Late([await (await fetch("demo.motion")).arrayBuffer()])),
      );
      await effigy.loadAvatar("demo.avatar");
      open();
      // The clip is for the avatar that was requested before it.
      const loading = effigy.loadAvatar("other.avatar?ms=500");
      const number = await effigy.loadMotion("demo.motion");
      // The clip may arrive before the rest of its avatar, which the next load would give up.
      const third = await loading;
      const bad = failure(effigy.loadAvatar("none.avatar"));
      return [
        ...named,
        await slow,
        number,
        third.name,
        effigy.clips.length,
        await bad,
        effigy.description.name,
      ];
    });
    const [first, clip, other, none, slow, number, third, clips, bad, shown] = found;
    assert.deepEqual(
      [first, clip, none, slow, number, clips, bad],
      ["AbortError", "AbortError", 0, "AbortError", 0, 1, "Error"],
      JSON.stringify(found),
    );
    assert.ok(other.startsWith("~") && third === other && shown === other, JSON.stringify(found));
    return page;
  },
  async "a preview is shown while the rest loads, and reverted if the rest does not come"() {
    const page = await openBare();
    const found = await page.evaluate(async () => {
      let over = false;
      const whole = effigy.loadAvatar("early.avatar?ms=2000&hold=25").then(() => {
        over = true;
      });
      await effigy.loadMotion("demo.motion");
      await event("frame");
      effigy.pause();
      effigy.time = 1.3;
      effigy.camera = { yaw: 0.7 };
      const neutral = await pixels(await effigy.screenshot());
      const early = !over;
      await fetch("release");
      await whole;
      const state = () => [
        effigy.time,
        effigy.camera.yaw,
        effigy.clips.length,
        effigy.description.name[0] === "~",
      ];
      const full = await pixels(await effigy.screenshot());
      const kept = state();
      const cut = failure(effigy.loadAvatar("early-other.avatar?ms=2000&hold=25&cut=1"));
      while (effigy.description.name[0] !== "~") {
        await new Promise((resolve) => setTimeout(resolve, 50));
      }
      await fetch("release");
      const failed = await cut;
      const back = await pixels(await effigy.screenshot());
      return {
        early,
        covered: covered(neutral),
        changed: different(neutral, full),
        kept,
        failed,
        same: different(full, back),
        again: state(),
      };
    });
    assert.ok(found.early && found.covered > 2000 && found.changed > 100, JSON.stringify(found));
    assert.deepEqual(
      [found.kept, found.again, found.same, found.failed],
      [[1.3, 0.7, 1, false], [1.3, 0.7, 1, false], 0, "Error"],
      JSON.stringify(found),
    );
    page.allowed = /ERR_/;
    return page;
  },
  async "a replaced or disposed avatar frees its memory"() {
    const page = await openBare(() => {
      globalThis.live = new Set();
      for (const [what, make] of [
        [GPUBuffer, "createBuffer"],
        [GPUTexture, "createTexture"],
      ]) {
        const create = GPUDevice.prototype[make];
        const destroy = what.prototype.destroy;
        GPUDevice.prototype[make] = function (descriptor) {
          // A browser refuses a buffer only after it has returned it.
          const one = create.call(
            this,
            globalThis.refuse && what === GPUBuffer ? { ...descriptor, size: 2 ** 50 } : descriptor,
          );
          live.add(one);
          return one;
        };
        what.prototype.destroy = function () {
          live.delete(this);
          return destroy.call(this);
        };
      }
      const destroy = GPUDevice.prototype.destroy;
      GPUDevice.prototype.destroy = function () {
        live.clear();
        return destroy.call(this);
      };
    });
    const found = await page.evaluate(async () => {
      // What an avatar hides itself with is made right after its first frame.
      const load = async (file) => {
        await effigy.loadAvatar(file);
        await event("frame");
        await new Promise((resolve) => setTimeout(resolve));
        return live.size;
      };
      const once = await load("demo.avatar");
      const twice = await load("other.avatar");
      globalThis.refuse = true;
      const refused = await effigy.loadAvatar("demo.avatar").then(
        () => "",
        (error) => error.message,
      );
      globalThis.refuse = false;
      const kept = [
        live.size,
        effigy.description.name[0],
        covered(await pixels(await effigy.screenshot())) > 2000,
      ];
      effigy.dispose();
      return { once, twice, refused, kept, end: live.size };
    });
    assert.ok(
      found.once > 15 && found.twice === found.once && found.end === 0,
      JSON.stringify(found),
    );
    assert.match(found.refused, /refused/);
    assert.deepEqual(found.kept, [found.once, "~", true], JSON.stringify(found));
    return page;
  },
  async "screenshots come even if the canvas can't be seen, and nothing else is drawn then"() {
    const page = await openBare();
    const found = await page.evaluate(async () => {
      const early = await failure(effigy.screenshot());
      await effigy.loadAvatar("demo.avatar");
      await effigy.loadMotion("demo.motion");
      const both = (await Promise.all([effigy.screenshot(), effigy.screenshot()])).map(
        (blob) => blob.size > 1000,
      );
      let drawn = 0;
      effigy.addEventListener("frame", () => ++drawn);
      const quiet = async () => {
        // Frames under way may still come.
        for (let k = 0; k < 6 && (k === 0 || drawn > 0); ++k) {
          drawn = 0;
          await new Promise((resolve) => setTimeout(resolve, 1500));
        }
        return [drawn, (await effigy.screenshot()).size > 1000];
      };
      scrollTo(0, 2000);
      const away = await quiet();
      scrollTo(0, 0);
      await event("frame");
      Object.defineProperty(document, "hidden", {
        configurable: true,
        get: () => globalThis.hidden,
      });
      globalThis.hidden = true;
      document.dispatchEvent(new Event("visibilitychange"));
      const hidden = await quiet();
      globalThis.hidden = false;
      document.dispatchEvent(new Event("visibilitychange"));
      await event("frame");
      return { early, both, away, hidden };
    });
    assert.deepEqual(found, {
      early: "Error",
      both: [true, true],
      away: [0, true],
      hidden: [0, true],
    });
    return page;
  },
  async "the screen's pixel ratio may change while playback is paused"() {
    const page = await openMoving("", { width: 300, height: 300 });
    await page.click("#play");
    const before = await page.evaluate(() => document.getElementById("canvas").width);
    const session = await page.context().newCDPSession(page);
    // Chromium tells queries and observers of an emulated ratio only if the size changes with it.
    await session.send("Emulation.setDeviceMetricsOverride", {
      width: 300,
      height: 301,
      deviceScaleFactor: 2,
      mobile: false,
    });
    await page.waitForFunction(
      (before) => document.getElementById("canvas").width === 2 * before,
      before,
    );
    return page;
  },
  async "two avatars on one page, one with live poses"() {
    const page = await openPage("two.html");
    const found = await page.evaluate(async () => {
      const { Effigy } = await import("./effigy.js");
      const both = await Promise.all(
        ["a", "b"].map((id) => Effigy.create(document.getElementById(id))),
      );
      await Promise.all(both.map((one) => one.loadAvatar("demo.avatar")));
      await both[0].loadMotion("demo.motion");
      const joints = both[1].description.joints.length;
      const turns = [0, 0];
      both.forEach((one, k) => one.addEventListener("frame", () => ++turns[k]));
      // Software adapters are slow.
      const rotation = new Float32Array(3 * joints);
      for (let k = 0; k < 200 && turns.some((count) => count < 2); ++k) {
        rotation[1] = 0.1 * k + 1;
        both[1].setPose({ rotation });
        await new Promise((resolve) => setTimeout(resolve, 300));
      }
      const pixels = async (blob) => {
        const image = await createImageBitmap(blob);
        const canvas = new OffscreenCanvas(image.width, image.height);
        const context = canvas.getContext("2d");
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, image.width, image.height).data;
      };
      const [a, b] = await Promise.all(both.map(async (one) => pixels(await one.screenshot())));
      const seen = (data) =>
        data.reduce((sum, value, at) => sum + (at % 4 === 0 && Math.abs(value - 216) > 2), 0);
      both[0].dispose();
      rotation[1] = 0;
      both[1].setPose({ rotation });
      await both[1].screenshot();
      return {
        turns,
        covered: [seen(a), seen(b)],
        different: a.reduce((sum, value, at) => sum + (Math.abs(value - b[at]) > 8), 0),
      };
    });
    assert.ok(
      found.turns.every((turns) => turns >= 2) &&
        found.covered.every((pixels) => pixels > 2000) &&
        found.different > 2000,
      JSON.stringify(found),
    );
    return page;
  },
};
