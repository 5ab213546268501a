// The part of make.py that needs JavaScript: node make.mjs FOLDER, where FOLDER has node_modules.

import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const modules = join(resolve(process.argv[2]), 'node_modules');
const load = path => import(pathToFileURL(join(modules, path)));

// For CommonJS the package is found from a file beside node_modules.
const require = createRequire(join(modules, '..', 'package.json'));
const bytes = readFileSync('truth.ply');
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);

const spz = await load('spz-js/dist/index.js');
const stream = new Blob([bytes]).stream();
const cloud = await spz.loadPly(stream);
writeFileSync('small-js.spz', Buffer.from(await spz.serializeSpz(cloud)));

globalThis.window ??= globalThis;
const splats3d = require('@mkkellogg/gaussian-splats-3d');
const degree = 2;
const array = splats3d.PlyParser.parseToUncompressedSplatArray(buffer, degree);
for (const compression of [0, 1, 2]) {
  const alphaRemoval = 0;
  const generator = splats3d.SplatBufferGenerator.getStandardGenerator(
    alphaRemoval, compression, 0, undefined, 5.0, 10);
  const packed = generator.generateFromUncompressedSplatArray(array);
  writeFileSync(`small-${compression}.ksplat`, Buffer.from(packed.bufferData));
}
