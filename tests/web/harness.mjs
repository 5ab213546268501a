// What the tests of the page share: a server, a browser, and what to ask of a page.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { chromium } from "playwright-core";

const [root, reference] = process.argv.slice(2);
/** Where pictures are left. */
export const out = process.argv[4];

const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm", ".css": "text/css", ".png": "image/png" };
const style = "<!doctype html><link rel=icon href=data:,><style>body{height:4000px}canvas{width:200px;height:260px}</style>";
const made = {
  "/one.html": () => `${style}<canvas id=a></canvas>`,
  "/two.html": () => `${style}<canvas id=a></canvas><canvas id=b></canvas>`,
  "/none.avatar": () => "this is no avatar",
  "/reference.png": () => readFile(reference),
  "/release": () => { release(); return ""; },
  // The demo by another name, and both with what is drawn first in front.
  "/other.avatar": async () => renamed(await readFile(join(root, "demo.avatar"))),
  "/early.avatar": async () => reordered(await readFile(join(root, "demo.avatar"))),
  "/early-other.avatar": async () => renamed(reordered(await readFile(join(root, "demo.avatar")))),
};

// One /release lets one `?hold=` go on, whichever comes first.
let released, release;
const latch = () => { released = new Promise((resolve) => { release = resolve; }); };
latch();

function renamed(file) {
  return Buffer.from(file.toString("latin1").replace(/(\\"name\\":\\")./, "$1~"), "latin1");
}

function reordered(file) {
  const start = 8 + Number(file.readBigUInt64LE()), header = JSON.parse(file.subarray(8, start));
  const late = (name) => /^mlp\.|\.row$|^(rotation|scale|color|node)\.basis$/.test(name);
  const names = Object.keys(header).filter((name) => name !== "__metadata__").sort((a, b) => late(a) - late(b)), tensors = [];
  let end = 0;
  for (const name of names) {
    const [from, to] = header[name].data_offsets;
    tensors.push(file.subarray(start + from, start + to));
    header[name].data_offsets = [end, (end += to - from)];
  }
  const text = Buffer.from(JSON.stringify(header)), length = Buffer.alloc(8);
  length.writeBigUInt64LE(BigInt(text.length));
  return Buffer.concat([length, text, ...tensors]);
}

async function send(request, response) {
  const url = new URL(request.url, "http://localhost"), path = decodeURIComponent(url.pathname);
  const body = Buffer.from(await (made[path]?.() ?? readFile(join(root, normalize(path === "/" ? "/index.html" : path)))));
  response.writeHead(200, {
    "content-type": types[extname(path)] ?? (path.endsWith("/") ? "text/html" : "application/octet-stream"),
    "content-length": body.length,
  });
  // `?ms=`: over so long a time.
  const pieces = url.searchParams.has("ms") ? 40 : 1, size = Math.ceil(body.length / pieces);
  for (let piece = 0; piece < pieces && !response.destroyed; ++piece) {
    response.write(body.subarray(piece * size, (piece + 1) * size));
    if (pieces > 1) await new Promise((resolve) => setTimeout(resolve, Number(url.searchParams.get("ms")) / pieces));
    // `?hold=`: from there on when /release is asked for; `&cut`: or never.
    if (piece === Number(url.searchParams.get("hold") ?? pieces)) {
      await released;
      latch();
      if (url.searchParams.has("cut")) return response.destroy();
    }
  }
  response.end();
}

const server = createServer((request, response) => send(request, response).catch(() => response.headersSent || response.writeHead(404).end()));
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
export const home = `http://127.0.0.1:${server.address().port}/`;

const swiftshader = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan", "--use-vulkan=swiftshader", "--use-angle=swiftshader"];
const quiet = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage"];
const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
export const browser = await chromium.launch({ executablePath, args: [...quiet, ...swiftshader], timeout: 60_000 });

/** Collects what a page complains of. What it may, a test says. */
export function watched(page) {
  page.setDefaultTimeout(120_000);
  page.complaints = [];
  page.allowed = /powerPreference/;
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on("console", (message) => message.type() === "error" && page.complaints.push(message.text()));
  return page;
}

export async function opened(path = "", size = { width: 640, height: 640 }, script = undefined) {
  const page = watched(await browser.newPage({ viewport: size }));
  if (script) await page.addInitScript(script);
  await page.goto(home + path);
  return page;
}

/** Waits for some more frames. */
export const frames = (page, count = 2) => page.evaluate(async (count) => {
  for (let k = 0; k < count; ++k) await new Promise((resolve) => effigy.addEventListener("frame", resolve, { once: true }));
}, count);

/** The page with the demo in motion. */
export async function moving(path, size, script) {
  const page = await opened(path, size, script);
  await page.waitForFunction(() => globalThis.effigy?.playing);
  await frames(page);
  return page;
}

/** A bare page with an avatar of the API's, `effigy`. */
export async function bare(script) {
  const page = await opened("one.html", undefined, script);
  await page.evaluate(async () => {
    const { Effigy } = await import("./effigy.js");
    globalThis.effigy = await Effigy.create(document.getElementById("a"));
    globalThis.event = (name, of = effigy) => new Promise((resolve) => of.addEventListener(name, resolve, { once: true }));
    globalThis.failure = (promise) => promise.then(() => "", (error) => error.name);
    globalThis.pixels = async (blob) => {
      const image = await createImageBitmap(blob), canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.width, image.height);
    };
    /** Pixels that are not background, and those of two pictures that differ. */
    globalThis.covered = ({ data }) => data.reduce((sum, value, at) => sum + (at % 4 === 0 && Math.abs(value - 216) > 2), 0);
    globalThis.different = (a, b) => a.data.reduce((sum, value, at) => sum + (Math.abs(value - b.data[at]) > 2), 0);
  });
  return page;
}
