// Where bytes come from, and which numbers are taken.

export const aborted = (why) => new DOMException(why, "AbortError");

/** A number within limits, or a RangeError that names it. */
export function within(what, value, least, most) {
  if (typeof value === "number" && value >= least && value <= most) return value;
  throw new RangeError(`${what} is ${value}, expected a number from ${least} to ${most}`);
}

async function download(url, onProgress, signal, onBytes) {
  const failed = (error) => {
    throw error.name === "AbortError" ? error : new Error(`${url} can't be loaded: ${error.message}`, { cause: error });
  };
  const response = await fetch(url, { signal }).catch(failed);
  if (!response.ok) throw new Error(`${url} can't be loaded: the server says ${response.status} ${response.statusText}`);
  const length = Number(response.headers.get("content-length"));
  // What is compressed on the way is longer than the header says.
  const total = length > 0 && !response.headers.get("content-encoding") ? length : undefined;
  const reader = response.body.getReader();
  let bytes = new Uint8Array(total ?? 1 << 20), loaded = 0;
  for (;;) {
    const { done, value } = await reader.read().catch(failed);
    if (done) break;
    if (loaded + value.length > bytes.length) {
      const more = new Uint8Array(Math.max(2 * bytes.length, loaded + value.length));
      more.set(bytes.subarray(0, loaded));
      bytes = more;
    }
    bytes.set(value, loaded);
    loaded += value.length;
    onProgress?.(loaded, total);
    onBytes?.(bytes, loaded, total);
  }
  return bytes.subarray(0, loaded);
}

/** The bytes of a URL, a Blob or some bytes. `onBytes` sees those of a URL as they come. */
export async function bytesOf(source, onProgress, signal, onBytes) {
  signal?.throwIfAborted();
  if (typeof source === "string" || source instanceof URL) return download(String(source), onProgress, signal, onBytes);
  if (source instanceof Blob) return new Uint8Array(await source.arrayBuffer());
  return source instanceof Uint8Array ? source : new Uint8Array(source);
}
