// Reads bytes from a URL, a Blob or memory.

/** Size of the first buffer for a download of unknown length, bytes. */
const FIRST_BUFFER_BYTES = 1 << 20;

/**
 * Returns all bytes of a source. `onProgress(loaded, total)` and `onBytes(bytes, loaded, total)`
 * are called while a URL is downloaded; `total` is undefined if the server does not say it.
 */
export async function readBytes(source, { onProgress, signal, onBytes }) {
  signal?.throwIfAborted();
  if (typeof source === "string" || source instanceof URL) {
    return download(String(source), { onProgress, signal, onBytes });
  }
  if (source instanceof Blob) return new Uint8Array(await source.arrayBuffer());
  return source instanceof Uint8Array ? source : new Uint8Array(source);
}

async function download(url, { onProgress, signal, onBytes }) {
  const fail = (error) => {
    if (error.name === "AbortError") throw error;
    throw new Error(`${url} can't be loaded: ${error.message}`, { cause: error });
  };
  const response = await fetch(url, { signal }).catch(fail);
  if (!response.ok) {
    const status = `${response.status} ${response.statusText}`;
    throw new Error(`${url} can't be loaded: the server says ${status}`);
  }
  const total = lengthOf(response);
  const reader = response.body.getReader();
  let bytes = new Uint8Array(total ?? FIRST_BUFFER_BYTES);
  let loaded = 0;
  for (;;) {
    const { done, value } = await reader.read().catch(fail);
    if (done) break;
    const needed = loaded + value.length;
    if (needed > bytes.length) bytes = grown(bytes, Math.max(2 * bytes.length, needed));
    bytes.set(value, loaded);
    loaded = needed;
    onProgress?.(loaded, total);
    onBytes?.(bytes, loaded, total);
  }
  return bytes.subarray(0, loaded);
}

/** Bytes of a response, if the server says it. */
function lengthOf(response) {
  // The header of a compressed response has its compressed length.
  if (response.headers.get("content-encoding")) return undefined;
  const length = Number(response.headers.get("content-length"));
  return length > 0 ? length : undefined;
}

function grown(bytes, length) {
  const larger = new Uint8Array(length);
  larger.set(bytes);
  return larger;
}
