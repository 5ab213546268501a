// Tests the page, its API (api.mjs) and files of other programs (foreign.mjs) in Chromium, from the
// repository's root.
// usage: node page.mjs PAGE_DIR REFERENCE.png OUT_DIR      (tools/test_web.sh makes all three)
// REFERENCE.png is the demo at 1.3 s: `effigy render --reference --size 512x512 --time 1.3`.
import assert from "node:assert/strict";
import { readFile, readdir, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { api } from "./api.mjs";
import { foreign } from "./foreign.mjs";
import {
  browser,
  waitForFrames,
  home,
  openMoving,
  openPage,
  out,
  collectComplaints,
} from "./harness.mjs";

/** PSNR of the canvas against an image, over the pixels that are not background, dB. */
const decibels = (page, url) =>
  page.evaluate(async (url) => {
    const pixels = async (blob) => {
      const image = await createImageBitmap(blob);
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.width, image.height);
    };
    const expected = await pixels(await (await fetch(url)).blob());
    const got = await pixels(await effigy.screenshot());
    if (got.width !== expected.width || got.height !== expected.height) {
      throw new Error(`${got.width} × ${got.height} px`);
    }
    let sum = 0;
    let count = 0;
    for (let at = 0; at < got.data.length; at += 4) {
      if ([216, 221, 227].every((value, k) => expected.data[at + k] === value)) continue;
      ++count;
      for (let k = 0; k < 3; ++k) sum += ((got.data[at + k] - expected.data[at + k]) / 255) ** 2;
    }
    return { covered: count, psnr: 10 * Math.log10((3 * count) / sum) };
  }, url);

const tests = {
  ...api,
  ...foreign,
  // Those that no page uses on this adapter too. Browsers are stricter than wgpu outside of them:
  // what may differ between invocations must not decide whether they come to a barrier.
  async "every shader compiles"() {
    const folder = process.env.EFFIGY_WGSL;
    const files = await readdir(folder, { recursive: true });
    const modules = [];
    for (const file of files.filter((name) => name.endsWith(".wgsl"))) {
      const text = await readFile(join(folder, file), "utf8");
      const lengths = new Set(text.match(/LENGTH_\w+/g));
      const constants = [...lengths].map((name) => `const ${name}: u32 = 1024u;\n`);
      modules.push([file, constants.join("") + text]);
    }
    assert(modules.length >= 30);
    const page = await openPage("one.html");
    const messages = await page.evaluate(async (modules) => {
      const adapter = await navigator.gpu.requestAdapter();
      const device = await adapter.requestDevice();
      const messages = [];
      for (const [file, code] of modules) {
        device.pushErrorScope("validation");
        const module = device.createShaderModule({ code });
        const info = await module.getCompilationInfo();
        messages.push(...info.messages.map((one) => `${file}:${one.lineNum}: ${one.message}`));
        if (/@compute/.test(code)) {
          const compute = { module };
          await device.createComputePipelineAsync({ layout: "auto", compute }).catch(() => {});
        }
        const error = await device.popErrorScope();
        if (error) messages.push(`${file}: ${error.message}`);
      }
      return messages;
    }, modules);
    assert.deepEqual(messages, []);
    return page;
  },
  async "the demo plays at once, and pauses"() {
    const page = await openMoving();
    const before = await page.evaluate(() => effigy.time);
    await waitForFrames(page, 3);
    assert.notEqual(await page.evaluate(() => effigy.time), before);
    await page.click("#play");
    // Frames under way may still come: on a busy machine for some seconds.
    const drawn = () =>
      page.evaluate(
        () =>
          new Promise((resolve) => {
            effigy.addEventListener("frame", () => resolve(true), { once: true });
            setTimeout(resolve, 3000, false);
          }),
      );
    let more = 4;
    while (more > 0 && (await drawn())) --more;
    assert.ok(more > 0, "frames are drawn although nothing changes");
    await page.screenshot({ path: join(out, "page.png") });
    return page;
  },
  async "the image matches the reference"() {
    const page = await openMoving();
    await page.evaluate(async () => {
      effigy.pause();
      const canvas = document.getElementById("canvas");
      Object.assign(canvas.style, { width: "512px", height: "512px" });
      await new Promise((resolve) => setTimeout(resolve, 200));
      effigy.time = 1.3;
      effigy.camera = {
        yaw: (20 * Math.PI) / 180,
        pitch: (5 * Math.PI) / 180,
        fov: (35 * Math.PI) / 180,
      };
      effigy.frameAvatar();
      await effigy.screenshot();
      effigy.frameAvatar();
    });
    const { covered, psnr } = await decibels(page, "reference.png");
    console.log(`  ${psnr.toFixed(2)} dB over ${covered} covered pixels`);
    assert.ok(covered > 20_000 && psnr >= 48, `${psnr} dB`);
    return page;
  },
  async "numbers say how a small avatar is drawn, and the address that it is not drawn larger"() {
    for (const [query, expected] of [
      ["", /small: up to \d × \d samples a pixel/],
      ["?supersample=1&detail=1/4", /drawn$/],
    ]) {
      const page = await openMoving(query, { width: 300, height: 300 });
      await page.click("#numbers");
      await waitForFrames(page, 3);
      assert.match(await page.textContent("#overlay"), expected);
      await page.click("#numbers");
      await page.screenshot({ path: join(out, query ? "large.png" : "small.png") });
    }
    const page = await openPage("?supersample=3");
    await page.waitForSelector("#message:not([hidden])");
    assert.match(await page.textContent("#text"), /write auto, 1, 2 or 4/);
    return page;
  },
  async "the canvas follows the window's size"() {
    const page = await openMoving("", { width: 500, height: 400 });
    await page.setViewportSize({ width: 700, height: 500 });
    await waitForFrames(page, 3);
    assert.equal(await page.evaluate(() => document.getElementById("canvas").width), 700);
    return page;
  },
  async "a lost device comes back with the avatar"() {
    const page = await openMoving();
    const restored = page.evaluate(
      () => new Promise((resolve) => effigy.addEventListener("restored", resolve, { once: true })),
    );
    await page.evaluate(() => effigy.loseDevice());
    await restored;
    await waitForFrames(page, 3);
    assert.ok(await page.evaluate(() => effigy.playing && effigy.statistics.counters.drawn > 1000));
    return page;
  },
  async "a bad file shows a message, and the old avatar stays"() {
    const page = await openMoving();
    const error = await page.evaluate(() =>
      effigy.loadAvatar("none.avatar").then(
        () => "",
        (error) => error.message,
      ),
    );
    assert.match(error, /expected/);
    await page.setInputFiles("#file", {
      name: "bad.avatar",
      mimeType: "application/octet-stream",
      buffer: Buffer.from("nothing of ours"),
    });
    await page.waitForSelector("#message:not([hidden])");
    await waitForFrames(page);
    assert.ok(await page.evaluate(() => effigy.description.gaussians > 1000));
    return page;
  },
  async "a missing file is named"() {
    const page = await openPage("?avatar=missing.avatar&bench=1");
    await page.waitForSelector("#message:not([hidden])");
    assert.match(await page.textContent("#text"), /missing\.avatar.*404/);
    await page.waitForSelector("#bench");
    assert.match(await page.textContent("#bench"), /nothing to measure/);
    page.allowed = /404/;
    return page;
  },
  async "keys orbit, and the wheel zooms"() {
    const page = await openMoving();
    const before = await page.evaluate(() => effigy.camera);
    await page.focus("#canvas");
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("Shift+ArrowUp");
    assert.ok(
      await page.evaluate((before) => effigy.camera.target[1] < before.target[1], before),
      "Shift and an arrow key pan",
    );
    await page.mouse.move(300, 300);
    await page.mouse.wheel(0, -300);
    await page.waitForFunction(
      (before) => effigy.camera.yaw !== before.yaw && effigy.camera.distance < before.distance,
      before,
    );
    await page.keyboard.press(" ");
    assert.equal(await page.evaluate(() => effigy.playing), false);
    return page;
  },
  async "a module that fails to load is not reported as missing WebGPU"() {
    const page = collectComplaints(await browser.newPage());
    await page.route("**/effigy_core_bg.wasm", (route) => route.abort());
    await page.goto(home);
    await page.waitForSelector("#message:not([hidden])");
    assert.match(await page.textContent("#text"), /effigy_core_bg\.wasm/);
    assert.ok(await page.isHidden("#unsupported"));
    page.allowed = /ERR_FAILED/;
    return page;
  },
  async "controls show the state, to screen readers too"() {
    const page = await openMoving();
    assert.equal(await page.textContent("#play"), "Pause");
    assert.match(
      await page.getAttribute("#time", "aria-valuetext"),
      /^\d+\.\d of \d+\.\d seconds$/,
    );
    assert.notEqual(await page.getAttribute("#canvas", "role"), "img");
    assert.equal(
      await page.locator("output, [aria-live]").count(),
      0,
      "nothing is announced every frame",
    );
    const file = {
      name: "demo.avatar",
      mimeType: "application/octet-stream",
      buffer: await readFile(join(process.argv[2], "demo.avatar")),
    };
    for (let turn = 0; turn < 2; ++turn) {
      await page.setInputFiles("#file", file);
      await page.waitForFunction(() => effigy.clips.length === 0);
      assert.equal(
        await page.textContent("#play"),
        "Play",
        "an avatar without a clip is not playing",
      );
      await page.evaluate(() => effigy.loadMotion("demo.motion"));
    }
    return page;
  },
  async "a measurement has the format of effigy bench"() {
    const page = await openPage("?bench=1&frames=2", { width: 200, height: 200 });
    const text = await (await page.waitForSelector("#bench")).textContent();
    assert.ok(JSON.parse(text).cases[0].frame_ms.mean > 0, text);
    // tools/test_web.sh passes it to `effigy compare`.
    await writeFile(join(out, "bench.json"), text);
    return page;
  },
  async "without WebGPU the page names browsers that have it"() {
    const page = await openPage("", undefined, () => {
      delete Navigator.prototype.gpu;
    });
    await page.waitForSelector("#unsupported:not([hidden])");
    assert.match(await page.textContent("#unsupported"), /Chrome/);
    return page;
  },
  async "the page works without a network after the first visit"() {
    const context = await browser.newContext({ viewport: { width: 300, height: 300 } });
    const page = collectComplaints(await context.newPage());
    await page.goto(home);
    await page.evaluate(() => navigator.serviceWorker.ready);
    await context.setOffline(true);
    await page.reload();
    await page.waitForFunction(() => globalThis.effigy?.playing);
    return page;
  },
};

/** What a page is doing, for a test that waited in vain. */
function stateOf(page) {
  const state = page.evaluate(async () =>
    JSON.stringify({
      drawsFrames: await Promise.race([
        new Promise((resolve) => requestAnimationFrame(() => resolve(true))),
        new Promise((resolve) => setTimeout(resolve, 2000, false)),
      ]),
      ratio: devicePixelRatio,
      hidden: document.hidden,
      canvases: [...document.querySelectorAll("canvas")].map((canvas) => [
        canvas.clientWidth,
        canvas.width,
      ]),
      playing: globalThis.effigy?.playing,
      statistics: globalThis.effigy?.statistics,
    }),
  );
  const late = new Promise((resolve) => setTimeout(resolve, 5000, "the page does not answer"));
  return Promise.race([state, late]).catch((error) => `no state: ${error.message}`);
}

let failed = 0;
const limit = Number(process.env.EFFIGY_TEST_SECONDS ?? 240);
for (const [name, test] of Object.entries(tests).filter(([name]) =>
  name.includes(process.env.ONLY ?? ""),
)) {
  const started = Date.now();
  let page;
  try {
    const late = new Promise((_, reject) =>
      setTimeout(reject, 1000 * limit, new Error(`took longer than ${limit} s`)),
    );
    page = await Promise.race([test(), late]);
    assert.deepEqual(
      page.complaints.filter((text) => !page.allowed.test(text)),
      [],
      "the page has reported errors",
    );
    console.log(`ok ${name} (${((Date.now() - started) / 1000).toFixed(1)} s)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED ${name}\n  ${error.stack ?? error}`);
    for (const open of browser.contexts().flatMap((context) => context.pages())) {
      console.log("  ", await stateOf(open));
      console.log("  ", (open.complaints ?? []).slice(0, 5).join("\n   "));
    }
  }
  for (const open of browser.contexts().flatMap((context) => context.pages())) {
    await open.close().catch(() => {});
  }
}
await writeFile(join(out, "result.txt"), failed ? `${failed} failed\n` : "passed\n");
await Promise.race([browser.close(), new Promise((resolve) => setTimeout(resolve, 5000))]);
process.exit(failed ? 1 : 0);
