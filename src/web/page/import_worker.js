// A worker that reads one file of another program. foreign.js starts it, and ends it.
import init, { import_avatar, import_motion, kind } from "./effigy_import.js";

/** The answer to a request of foreign.js. */
function answer({ what, name, skeleton, skin }, bytes) {
  if (what === "kind") return { kind: kind(bytes, name) };
  const imported =
    what === "avatar" ? import_avatar(bytes, name) : import_motion(bytes, name, skeleton, skin);
  return {
    bytes: imported.take_bytes(),
    isSplats: imported.is_splats(),
    notes: imported.take_notes(),
  };
}

async function load() {
  const url = new URL("effigy_import_bg.wasm", import.meta.url);
  try {
    await init({ module_or_path: url });
  } catch (error) {
    throw new Error(`effigy_import_bg.wasm can't be loaded: ${error.message}`, { cause: error });
  }
}

async function serve(request) {
  const { file } = request;
  try {
    await load();
    const bytes = file instanceof Blob ? new Uint8Array(await file.arrayBuffer()) : file;
    const found = answer(request, bytes);
    postMessage(found, found.bytes ? [found.bytes.buffer] : []);
  } catch (error) {
    // A panic, most likely for want of memory.
    const isPanic = error instanceof WebAssembly.RuntimeError;
    postMessage({ error: isPanic ? `its reader has failed: ${error.message}` : error.message });
  }
}

onmessage = ({ data }) => serve(data);
