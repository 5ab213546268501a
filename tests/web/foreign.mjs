// Files of other programs in the page: dropped, named by the address, and loaded by the API.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { basename } from "node:path";
import { browser, collectComplaints, home, openBare, openMoving, openPage } from "./harness.mjs";

const data = (path) => `tests/data/${path}`;

/** Drops files on the page: paths, or objects with a name and a content. */
async function drop(page, ...files) {
  const read = async (file) => {
    const { name, content } =
      typeof file === "string" ? { name: basename(file), content: await readFile(file) } : file;
    return { name, base64: Buffer.from(content).toString("base64") };
  };
  await page.evaluate(
    (files) => {
      const transfer = new DataTransfer();
      for (const { name, base64 } of files) {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt());
        transfer.items.add(new File([bytes], name));
      }
      dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, cancelable: true }));
    },
    await Promise.all(files.map(read)),
  );
}

/** The pixels of the canvas: how many are not background, and all of them. */
const picture = (page) =>
  page.evaluate(async () => {
    const image = await createImageBitmap(await effigy.screenshot());
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    let covered = 0;
    for (let at = 0; at < data.length; at += 4) covered += Math.abs(data[at] - 216) > 2 ? 1 : 0;
    return { covered, pixels: Array.from(data) };
  });

/** Root of the mean squared difference of two pictures, of 255. */
function difference(one, other) {
  assert.equal(one.pixels.length, other.pixels.length);
  const sum = one.pixels.reduce((sum, value, at) => sum + (value - other.pixels[at]) ** 2, 0);
  return Math.sqrt(sum / one.pixels.length);
}

const hasError = (page) => page.isVisible("#message");

export const foreign = {
  async "motion of another body is dropped, and moves the avatar"() {
    const page = await openMoving("", { width: 300, height: 300 });
    assert.equal(
      await page.evaluate(
        () =>
          performance.getEntriesByType("resource").filter(({ name }) => /import/.test(name)).length,
      ),
      0,
      "readers of other programs' files are loaded before there is one",
    );
    await drop(page, data("motion/mixamo.bvh"));
    await page.waitForFunction(() => effigy.clips.length === 2 && effigy.clip === 1);
    const clip = await page.evaluate(() => effigy.clips[1]);
    assert.ok(clip.name === "mixamo" && clip.duration > 0.5, JSON.stringify(clip));
    await page.evaluate(() => effigy.pause());
    const pictureAt = async (share) => {
      await page.evaluate((share) => {
        effigy.time = share * effigy.duration;
      }, share);
      await picture(page);
      return picture(page);
    };
    const [start, later] = [await pictureAt(0), await pictureAt(0.6)];
    assert.ok(start.covered > 1000 && later.covered > 1000, `${start.covered}, ${later.covered}`);
    assert.ok(difference(start, later) > 1, "the picture does not change");
    assert.ok(!(await hasError(page)), await page.textContent("#text"));
    return page;
  },
  async "splats and the paper's model are dropped, and what they left open is said"() {
    const page = await openMoving("", { width: 300, height: 300 });
    const pictures = [await picture(page)];
    for (const file of ["splats/small-4.spz", "splats/truth.ply"]) {
      const name = basename(file).split(".")[0];
      await drop(page, data(file));
      await page.waitForFunction((name) => effigy.description.name === name, name);
      assert.equal(await page.evaluate(() => effigy.description.gaussians), 64);
      pictures.push(await picture(page));
    }
    const [demo, spz, ply] = pictures;
    assert.ok(spz.covered > 500 && ply.covered > 500, `${spz.covered}, ${ply.covered}`);
    assert.ok(difference(demo, spz) > 10);
    assert.ok(difference(spz, ply) < 6, `${difference(spz, ply)} between .spz and .ply`);
    assert.ok(!(await page.isVisible("#notes")));

    await drop(page, data("webavatar/small.npz"));
    await page.waitForFunction(() => effigy.description.gaussians === 160);
    assert.equal(await page.evaluate(() => effigy.description.joints.length), 55);
    // Its Gaussians are smaller than a pixel: as many of them as their area covers.
    assert.ok((await picture(page)).covered > 250);
    await page.waitForSelector("#notes:not([hidden])");
    assert.match(await page.textContent("#notes-list"), /small\.npz: hidden layers: /);
    await page.click("#notes-close");
    assert.ok(!(await page.isVisible("#notes")) && !(await hasError(page)));
    return page;
  },
  async "several files are told apart by content, and clips come after their avatar"() {
    const page = await openMoving("", { width: 300, height: 300 });
    await page.evaluate(() => {
      effigy.addEventListener("error", ({ detail }) => console.error(detail.message));
    });
    await drop(
      page,
      { name: "walk.txt", content: await readFile(data("motion/lafan.bvh")) },
      { name: "own.bin", content: await readFile("src/demo/demo.motion") },
      { name: "body.bin", content: await readFile("src/demo/demo.avatar") },
    );
    await page.waitForFunction(
      () => effigy.clips.length === 2 && effigy.clips.some(({ name }) => name === "walk"),
    );
    assert.ok(await page.evaluate(() => effigy.description.gaussians > 1000));
    assert.ok(!(await hasError(page)), await page.textContent("#text"));
    return page;
  },
  async "a broken file is one sentence, and what is shown stays"() {
    const page = await openMoving("", { width: 300, height: 300 });
    const bvh = await readFile(data("motion/mixamo.bvh"));
    const spz = await readFile(data("splats/small-js.spz"));
    const files = [
      { name: "cut.bvh", content: bvh.subarray(0, 300) },
      { name: "cut.spz", content: spz.subarray(0, spz.length / 2) },
      { name: "junk.bin", content: "nothing of ours" },
      { name: "scene.fbx", content: "Kaydara FBX Binary  \0" },
    ];
    for (const file of files) {
      await drop(page, file);
      await page.waitForSelector("#message:not([hidden])");
      const text = await page.textContent("#text");
      assert.ok(text.startsWith(file.name) && !text.includes("\n") && text.length < 300, text);
      await page.click("#close");
    }
    assert.ok(
      await page.evaluate(() => effigy.description.gaussians > 1000 && effigy.clips.length === 1),
    );
    return page;
  },
  async "the address may name files of other programs"() {
    const page = await openPage("?avatar=data/splats/small.sog", { width: 300, height: 300 });
    await page.waitForFunction(() => globalThis.effigy?.description.gaussians === 64);
    await page.waitForFunction(() => document.getElementById("loading").hidden);
    assert.ok(!(await hasError(page)), await page.textContent("#text"));
    await page.goto(`${home}?motion=data/smpl/aist_5.pkl`);
    await page.waitForFunction(() => globalThis.effigy?.clips[0]?.name === "aist_5");
    assert.ok(!(await hasError(page)), await page.textContent("#text"));
    return page;
  },
  async "the API loads files of other programs from bytes, and gives them up"() {
    const page = await openBare();
    const found = await page.evaluate(async () => {
      const bytes = async (path) => (await fetch(`data/${path}`)).arrayBuffer();
      const early = await failure(effigy.loadMotion("data/motion/mixamo.bvh"));
      const imported = [];
      effigy.addEventListener("import", ({ detail }) => imported.push(detail.name));
      await effigy.loadAvatar("demo.avatar");
      const index = await effigy.loadMotion(await bytes("motion/mixamo.bvh"), { play: false });
      const abort = new AbortController();
      const aborted = failure(
        effigy.loadMotion("data/motion/mixamo.bvh", {
          signal: abort.signal,
          onProgress: (loaded, total) => total === undefined && abort.abort(),
        }),
      );
      const kinds = [];
      const { kindOf } = await import("./effigy.js");
      for (const path of ["splats/small.glb", "gltf/dance.glb", "smpl/amass_x.npz"]) {
        kinds.push(await kindOf(new Blob([await bytes(path)])));
      }
      kinds.push(await kindOf(new Blob([await (await fetch("demo.motion")).arrayBuffer()])));
      const swapped = await failure(effigy.loadAvatar("data/motion/mixamo.bvh"));
      const replaced = failure(effigy.loadAvatar("data/splats/truth.ply"));
      const { gaussians } = await effigy.loadAvatar(await bytes("splats/small.splat"));
      const noBody = await failure(effigy.loadMotion("data/motion/mixamo.bvh"));
      const restored = event("restored");
      const before = await pixels(await effigy.screenshot());
      effigy.loseDevice();
      await restored;
      const after = await pixels(await effigy.screenshot());
      return {
        early,
        index,
        aborted: await aborted,
        kinds,
        swapped,
        replaced: await replaced,
        gaussians,
        noBody,
        imported,
        covered: covered(before),
        different: different(before, after),
      };
    });
    assert.ok(found.covered > 500, JSON.stringify(found));
    delete found.covered;
    assert.deepEqual(found, {
      early: "Error",
      index: 0,
      aborted: "AbortError",
      kinds: ["avatar", "motion", "motion", "motion"],
      swapped: "Error",
      replaced: "AbortError",
      gaussians: 64,
      noBody: "Error",
      imported: ["unnamed", "unnamed"],
      different: 0,
    });
    return page;
  },
  async "what reads other programs' files is kept for use without a network once it was used"() {
    const context = await browser.newContext({ viewport: { width: 300, height: 300 } });
    const page = collectComplaints(await context.newPage());
    await page.goto(home);
    await page.waitForFunction(
      () => globalThis.effigy?.playing && navigator.serviceWorker.controller,
    );
    const dropMotion = async () => {
      await drop(page, data("motion/mixamo.bvh"));
      await page.waitForFunction(() => effigy.clips.length === 2);
    };
    await dropMotion();
    await context.setOffline(true);
    await page.reload();
    await page.waitForFunction(() => globalThis.effigy?.playing);
    await dropMotion();
    return page;
  },
};
