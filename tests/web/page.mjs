// The page in a real browser. usage: node page.mjs PAGE_DIR REFERENCE.png OUT_DIR     (tools/test_web.sh makes all three)
// REFERENCE.png is the demo at 1.3 s by `effigy render --reference --size 512x512 --time 1.3`.
import assert from "node:assert/strict";
import { createServer } from "node:http";
import { readFile, writeFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { chromium } from "playwright-core";

const [root, reference, out] = process.argv.slice(2);
const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm", ".css": "text/css", ".png": "image/png" };
const pages = {
  "/two.html": `<!doctype html><style>canvas{width:200px;height:260px}</style><canvas id=a></canvas><canvas id=b></canvas>`,
  "/none.avatar": "this is no avatar",
};
const server = createServer(async (request, response) => {
  const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
  try {
    const body = pages[path] ?? (path === "/reference.png" ? await readFile(reference) : await readFile(join(root, normalize(path === "/" ? "/index.html" : path))));
    response.writeHead(200, { "content-type": types[extname(path)] ?? (path.endsWith("/") ? "text/html" : "application/octet-stream") }).end(body);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
const home = `http://127.0.0.1:${server.address().port}/`;
const swiftshader = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan", "--use-vulkan=swiftshader", "--use-angle=swiftshader"];
const quiet = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage"];
const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
const browser = await chromium.launch({ executablePath, args: [...quiet, ...swiftshader], timeout: 60_000 });

async function opened(path = "", size = { width: 640, height: 640 }) {
  const page = await browser.newPage({ viewport: size });
  page.setDefaultTimeout(60_000);
  page.complaints = [];
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on("console", (message) => message.type() === "error" && page.complaints.push(message.text()));
  await page.goto(home + path);
  return page;
}

/** Waits for some more frames. */
const frames = (page, count = 2) => page.evaluate(async (count) => {
  for (let k = 0; k < count; ++k) await new Promise((resolve) => effigy.addEventListener("frame", resolve, { once: true }));
}, count);
const moving = async (path, size) => {
  const page = await opened(path, size);
  await page.waitForFunction(() => globalThis.effigy?.playing);
  await frames(page);
  return page;
};
/** Distance of the canvas from a picture over what is not background, dB. */
const decibels = (page, url) => page.evaluate(async (url) => {
  const pixels = async (blob) => {
    const image = await createImageBitmap(blob), canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, image.width, image.height);
  };
  const expected = await pixels(await (await fetch(url)).blob()), got = await pixels(await effigy.screenshot());
  if (got.width !== expected.width || got.height !== expected.height) throw new Error(`${got.width} × ${got.height} px`);
  let sum = 0, count = 0;
  for (let at = 0; at < got.data.length; at += 4) {
    if ([216, 221, 227].every((value, k) => expected.data[at + k] === value)) continue;
    ++count;
    for (let k = 0; k < 3; ++k) sum += ((got.data[at + k] - expected.data[at + k]) / 255) ** 2;
  }
  return { covered: count, psnr: 10 * Math.log10((3 * count) / sum) };
}, url);

const tests = {
  async "the demo moves at once, and stops when told to"() {
    const page = await moving();
    const before = await page.evaluate(() => effigy.time);
    await frames(page, 3);
    assert.notEqual(await page.evaluate(() => effigy.time), before);
    await page.click("#play");
    await page.waitForTimeout(1500);
    const drawn = page.evaluate(() => new Promise((resolve) => {
      effigy.addEventListener("frame", () => resolve(true), { once: true });
      setTimeout(resolve, 1500, false);
    }));
    assert.equal(await drawn, false, "frames are drawn though nothing changes");
    await page.screenshot({ path: join(out, "page.png") });
    return page;
  },
  async "the picture is the reference's"() {
    const page = await moving();
    await page.evaluate(async () => {
      effigy.pause();
      const canvas = document.getElementById("canvas");
      Object.assign(canvas.style, { width: "512px", height: "512px" });
      await new Promise((resolve) => setTimeout(resolve, 200));
      effigy.time = 1.3;
      effigy.camera = { yaw: (20 * Math.PI) / 180, pitch: (5 * Math.PI) / 180, fov: (35 * Math.PI) / 180 };
      effigy.frameAvatar();
      await effigy.screenshot();
      effigy.frameAvatar();
    });
    const { covered, psnr } = await decibels(page, "reference.png");
    console.log(`  ${psnr.toFixed(2)} dB over ${covered} covered pixels`);
    assert.ok(covered > 20_000 && psnr >= 48, `${psnr} dB`);
    return page;
  },
  async "it follows the window's size"() {
    const page = await moving("", { width: 500, height: 400 });
    await page.setViewportSize({ width: 700, height: 500 });
    await frames(page, 3);
    assert.equal(await page.evaluate(() => document.getElementById("canvas").width), 700);
    return page;
  },
  async "a lost device comes back with the avatar"() {
    const page = await moving();
    const restored = page.evaluate(() => new Promise((resolve) => effigy.addEventListener("restored", resolve, { once: true })));
    await page.evaluate(() => effigy.loseDevice());
    await restored;
    await frames(page, 3);
    assert.ok(await page.evaluate(() => effigy.playing && effigy.statistics.counters.drawn > 1000));
    return page;
  },
  async "a bad file is a message, and the old avatar stays"() {
    const page = await moving();
    const error = await page.evaluate(() => effigy.loadAvatar("none.avatar").then(() => "", (error) => error.message));
    assert.match(error, /expected/);
    await page.setInputFiles("#file", { name: "bad.avatar", mimeType: "application/octet-stream", buffer: Buffer.from("nothing of ours") });
    await page.waitForSelector("#message:not([hidden])");
    await frames(page);
    assert.ok(await page.evaluate(() => effigy.description.gaussians > 1000));
    return page;
  },
  async "a page whose files are missing says which"() {
    const page = await opened("?avatar=missing.avatar");
    await page.waitForSelector("#message:not([hidden])");
    assert.match(await page.textContent("#text"), /missing\.avatar.*404/);
    page.complaints.length = 0;
    return page;
  },
  async "two on one page, one driven live"() {
    const page = await opened("two.html");
    const drawn = await page.evaluate(async () => {
      const { Effigy } = await import("./effigy.js");
      const both = await Promise.all(["a", "b"].map((id) => Effigy.create(document.getElementById(id))));
      await Promise.all(both.map((one) => one.loadAvatar("demo.avatar")));
      await both[0].loadMotion("demo.motion");
      const joints = both[1].description.joints.length, turns = [0, 0];
      both.forEach((one, k) => one.addEventListener("frame", () => ++turns[k]));
      // Software adapters take their time.
      for (let k = 0; k < 200 && turns.some((count) => count < 2); ++k) {
        const rotation = new Float32Array(3 * joints);
        rotation[1] = 0.1 * k;
        both[1].setPose({ rotation });
        await new Promise((resolve) => setTimeout(resolve, 300));
      }
      let refused = "";
      try { both[1].setPose({ rotation: [1, 2] }); } catch (error) { refused = error.message; }
      both[0].dispose();
      return { turns, refused };
    });
    assert.ok(drawn.turns.every((turns) => turns >= 2), `${drawn.turns}`);
    assert.match(drawn.refused, /expected/);
    return page;
  },
  async "keys turn it, and the wheel comes nearer"() {
    const page = await moving();
    const before = await page.evaluate(() => effigy.camera);
    await page.focus("#canvas");
    await page.keyboard.press("ArrowLeft");
    await page.mouse.move(300, 300);
    await page.mouse.wheel(0, -300);
    await page.waitForFunction((before) => effigy.camera.yaw !== before.yaw && effigy.camera.distance < before.distance, before);
    await page.keyboard.press(" ");
    assert.equal(await page.evaluate(() => effigy.playing), false);
    return page;
  },
  async "without WebGPU it says which browsers have it"() {
    const page = await browser.newPage();
    await page.addInitScript(() => Object.defineProperty(Navigator.prototype, "gpu", { get: undefined, configurable: true }) && delete Navigator.prototype.gpu);
    page.complaints = [];
    await page.goto(home);
    await page.waitForSelector("#unsupported:not([hidden])");
    assert.match(await page.textContent("#unsupported"), /Chrome/);
    return page;
  },
  async "it works without a network after the first time"() {
    const context = await browser.newContext({ viewport: { width: 300, height: 300 } });
    const page = await context.newPage();
    page.complaints = [];
    await page.goto(home);
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.waitForTimeout(500);
    await context.setOffline(true);
    await page.reload();
    await page.waitForFunction(() => globalThis.effigy?.playing);
    return page;
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests).filter(([name]) => name.includes(process.env.ONLY ?? ""))) {
  const started = Date.now();
  let page;
  try {
    page = await Promise.race([test(), new Promise((_, reject) => setTimeout(reject, 120_000, new Error("took longer than 2 minutes")))]);
    assert.deepEqual(page.complaints.filter((text) => !/powerPreference|404/.test(text)), [], "the page complained");
    console.log(`ok ${name} (${((Date.now() - started) / 1000).toFixed(1)} s)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED ${name}\n  ${error.stack ?? error}`);
    for (const open of browser.contexts().flatMap((context) => context.pages())) console.log("  ", (open.complaints ?? []).slice(0, 5).join("\n   "));
  }
  for (const open of browser.contexts().flatMap((context) => context.pages())) await open.close().catch(() => {});
}
await writeFile(join(out, "result.txt"), failed ? `${failed} failed\n` : "passed\n");
await Promise.race([browser.close(), new Promise((resolve) => setTimeout(resolve, 5000))]);
process.exit(failed ? 1 : 0);
