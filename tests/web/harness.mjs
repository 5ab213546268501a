// Shared by the tests of the page: a server, a browser, and helpers.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { chromium } from "playwright-core";

const [root, reference] = process.argv.slice(2);
/** Folder for screenshots and results. */
export const out = process.argv[4];

const types = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".wasm": "application/wasm",
  ".css": "text/css",
  ".png": "image/png",
};
const style =
  "<!doctype html><link rel=icon href=data:,><style>body{height:4000px}canvas{width:200px;height:260px}</style>";
/**
 * Contents that the server makes, by path; all other paths are files of the page, or below /data/
 * those of the tests.
 */
const routes = {
  "/one.html": () => `${style}<canvas id=a></canvas>`,
  "/two.html": () => `${style}<canvas id=a></canvas><canvas id=b></canvas>`,
  "/none.avatar": () => "this is no avatar",
  "/reference.png": () => readFile(reference),
  "/release": () => {
    release();
    return "";
  },
  // The demo with another name, and both in the order that previews need.
  "/other.avatar": async () => rename(await readFile(join(root, "demo.avatar"))),
  "/early.avatar": async () => reorderForPreview(await readFile(join(root, "demo.avatar"))),
  "/early-other.avatar": async () =>
    rename(reorderForPreview(await readFile(join(root, "demo.avatar")))),
  // Levels near enough to be drawn.
  "/levels.avatar": async () => nearer(await readFile("tests/data/kept/2-levels.avatar")),
};

// A request of /release continues one download with `?hold=`, in either order.
let released;
let release;
const resetRelease = () => {
  released = new Promise((resolve) => {
    release = resolve;
  });
};
resetRelease();

/** Changes the first letter of the avatar's name in a file to `~`. */
function rename(file) {
  return Buffer.from(file.toString("latin1").replace(/(\\"name\\":\\")./, "$1~"), "latin1");
}

/** Adds 10 dB to what a file says of its levels. */
function nearer(file) {
  return Buffer.from(file.toString("latin1").replace(/(psnr_db\\":)3/g, "$14"), "latin1");
}

/** Moves the correctives to the end of a file. */
function reorderForPreview(file) {
  const start = 8 + Number(file.readBigUInt64LE());
  const header = JSON.parse(file.subarray(8, start));
  const isCorrective = (name) => /^mlp\.|\.row$|^(rotation|scale|color|node)\.basis$/.test(name);
  const names = Object.keys(header)
    .filter((name) => name !== "__metadata__")
    .sort((a, b) => isCorrective(a) - isCorrective(b));
  const tensors = [];
  let end = 0;
  for (const name of names) {
    const [from, to] = header[name].data_offsets;
    tensors.push(file.subarray(start + from, start + to));
    const tensorStart = end;
    end += to - from;
    header[name].data_offsets = [tensorStart, end];
  }
  const text = Buffer.from(JSON.stringify(header));
  const length = Buffer.alloc(8);
  length.writeBigUInt64LE(BigInt(text.length));
  return Buffer.concat([length, text, ...tensors]);
}

/** The content of a file. */
function read(path) {
  const [folder, name] = path.startsWith("/data/")
    ? ["tests/data", path.slice("/data/".length)]
    : [root, path === "/" ? "/index.html" : path];
  return readFile(join(folder, normalize(name)));
}

async function send(request, response) {
  const url = new URL(request.url, "http://localhost");
  const path = decodeURIComponent(url.pathname);
  const body = Buffer.from(await (routes[path]?.() ?? read(path)));
  response.writeHead(200, {
    "content-type":
      types[extname(path)] ?? (path.endsWith("/") ? "text/html" : "application/octet-stream"),
    "content-length": body.length,
  });
  // `?ms=`: the download takes this long.
  const pieces = url.searchParams.has("ms") ? 40 : 1;
  const size = Math.ceil(body.length / pieces);
  for (let piece = 0; piece < pieces && !response.destroyed; ++piece) {
    response.write(body.subarray(piece * size, (piece + 1) * size));
    if (pieces > 1) {
      await new Promise((resolve) =>
        setTimeout(resolve, Number(url.searchParams.get("ms")) / pieces),
      );
    }
    // `?hold=`: the download stops after this piece until /release is requested; with `&cut` it
    // then ends.
    if (piece === Number(url.searchParams.get("hold") ?? pieces)) {
      await released;
      resetRelease();
      if (url.searchParams.has("cut")) return response.destroy();
    }
  }
  response.end();
}

const server = createServer((request, response) =>
  send(request, response).catch(() => response.headersSent || response.writeHead(404).end()),
);
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
export const home = `http://127.0.0.1:${server.address().port}/`;

const swiftshader = [
  "--enable-unsafe-webgpu",
  "--use-webgpu-adapter=swiftshader",
  "--enable-features=Vulkan",
  "--use-vulkan=swiftshader",
  "--use-angle=swiftshader",
];
const quiet = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--disable-dev-shm-usage",
];
const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
export const browser = await chromium.launch({
  executablePath,
  args: [...quiet, ...swiftshader],
  timeout: 60_000,
});

/** Collects a page's errors. Tests set `allowed` to those that they expect. */
export function collectComplaints(page) {
  page.setDefaultTimeout(120_000);
  page.complaints = [];
  page.allowed = /powerPreference/;
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on(
    "console",
    (message) => message.type() === "error" && page.complaints.push(message.text()),
  );
  return page;
}

/** Opens a path of the server. `script` runs before the page's own. */
export async function openPage(path = "", size = { width: 640, height: 640 }, script = undefined) {
  const page = collectComplaints(await browser.newPage({ viewport: size }));
  if (script) await page.addInitScript(script);
  await page.goto(home + path);
  return page;
}

/** Waits for more frames. */
export const waitForFrames = (page, count = 2) =>
  page.evaluate(async (count) => {
    for (let k = 0; k < count; ++k) {
      await new Promise((resolve) => effigy.addEventListener("frame", resolve, { once: true }));
    }
  }, count);

/** Opens the page, and waits until the demo moves. */
export async function openMoving(path, size, script) {
  const page = await openPage(path, size, script);
  await page.waitForFunction(() => globalThis.effigy?.playing);
  await waitForFrames(page);
  return page;
}

/** Opens a page without controls, with an avatar in `effigy` and helpers for the API. */
export async function openBare(script) {
  const page = await openPage("one.html", undefined, script);
  await page.evaluate(async () => {
    const { Effigy } = await import("./effigy.js");
    globalThis.effigy = await Effigy.create(document.getElementById("a"));
    globalThis.event = (name, of = effigy) =>
      new Promise((resolve) => of.addEventListener(name, resolve, { once: true }));
    globalThis.failure = (promise) =>
      promise.then(
        () => "",
        (error) => error.name,
      );
    globalThis.pixels = async (blob) => {
      const image = await createImageBitmap(blob);
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.width, image.height);
    };
    /** Counts pixels that are not background. */
    globalThis.covered = ({ data }) =>
      data.reduce((sum, value, at) => sum + (at % 4 === 0 && Math.abs(value - 216) > 2), 0);
    /** Counts channels that differ between two images. */
    globalThis.different = (a, b) =>
      a.data.reduce((sum, value, at) => sum + (Math.abs(value - b.data[at]) > 2), 0);
  });
  return page;
}
