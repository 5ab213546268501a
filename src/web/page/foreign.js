// Files of other programs. A worker turns them into Effigy's own: the page goes on meanwhile, and
// what one of them takes of memory goes with its worker. What reads them is loaded with the first.
import { is_motion } from "./effigy_core.js";

/** The longest header of a file of Effigy's own, bytes. */
const LONGEST_HEADER = 100_000_000n;
/** Enough of a file to tell whether it is Effigy's own, bytes. */
const START_BYTES = 9;

/** Whether bytes begin as a file of Effigy's own: with the length of its header, which is JSON. */
export function isOwn(bytes) {
  if (bytes.length < START_BYTES) return false;
  const length = new DataView(bytes.buffer, bytes.byteOffset).getBigUint64(0, true);
  return length <= LONGEST_HEADER && bytes[START_BYTES - 1] === "{".charCodeAt();
}

/** What a source's file is called. */
export function fileName(source) {
  if (typeof source === "string" || source instanceof URL) {
    const path = new URL(source, document.baseURI).pathname.split("/").at(-1);
    try {
      return decodeURIComponent(path);
    } catch {
      return path;
    }
  }
  return source.name ?? "unnamed";
}

/** What a file is by its content: "avatar", "motion" or "unknown". */
export async function kindOf(file) {
  const bytesOf = async (blob) => new Uint8Array(await blob.arrayBuffer());
  if (!isOwn(await bytesOf(file.slice(0, START_BYTES)))) {
    return (await ask({ what: "kind", file, name: fileName(file) })).kind;
  }
  try {
    return is_motion(await bytesOf(file)) ? "motion" : "avatar";
  } catch {
    // What is wrong with it is said when it is opened.
    return file.name?.toLowerCase().endsWith(".motion") ? "motion" : "avatar";
  }
}

/**
 * Turns an avatar of another program into `bytes` of an .avatar file, or if `isSplats`, of splats
 * for the module, and `notes` on what the file left open.
 */
export const importAvatar = (file, name, signal) => ask({ what: "avatar", file, name }, signal);

/**
 * Turns motion of another program into `bytes` of a .motion file for a body, and `notes` on what
 * the file left open. `body`: what the module says of the avatar, `skeleton` and `skin`.
 */
export const importMotion = (file, name, body, signal) =>
  ask({ what: "motion", file, name, ...body }, signal);

/** The answer of a worker to a request. A signal ends the worker. */
function ask(request, signal) {
  return new Promise((resolve, reject) => {
    signal?.throwIfAborted();
    const worker = new Worker(new URL("import_worker.js", import.meta.url), { type: "module" });
    const end = (settle, value) => {
      worker.terminate();
      signal?.removeEventListener("abort", abort);
      settle(value);
    };
    const abort = () => end(reject, signal.reason);
    signal?.addEventListener("abort", abort, { once: true });
    worker.onmessage = ({ data }) => {
      if (data.error === undefined) end(resolve, data);
      else end(reject, new Error(`${request.name}: ${data.error}`));
    };
    worker.onerror = (event) => {
      event.preventDefault();
      const reason = event.message ?? "it can't be loaded";
      end(reject, new Error(`${request.name} can't be read: import_worker.js: ${reason}`));
    };
    worker.postMessage(request);
  });
}
