// The module that draws: loaded once for a page, and what is said when it can't be or is no more.
import init, { Screen, panicked } from "./effigy_core.js";

let ready, broken;

/** What is thrown where there is no WebGPU. */
export class Unsupported extends Error {
  constructor(why = "This browser has no WebGPU. Chrome and Edge from 113 on have it, Safari from 26, and Firefox from 141 on Windows, from 145 on Macs.") {
    super(why);
    this.name = "Unsupported";
  }
}

/** Whether this browser can draw at all. */
export const isSupported = () => "gpu" in navigator;

/** Loads the module; after a failure it can be tried again. */
export function loaded() {
  return (ready ??= init({ module_or_path: new URL("effigy_core_bg.wasm", import.meta.url) }).catch((error) => {
    ready = undefined;
    throw new Error(`effigy_core_bg.wasm can't be loaded: ${error.message}`, { cause: error });
  }));
}

/** What a page is told of an error of the module's. After a panic nothing in it works any more. */
export function told(error) {
  if (!(error instanceof WebAssembly.RuntimeError)) return error;
  let why = error.message;
  try { why = panicked() ?? why; } catch { /* It can't even say why. */ }
  return (broken ??= new Error(`Effigy broke, and draws nothing more before this page is loaded again: ${why}`, { cause: error }));
}

/** Why nothing works any more, if so. */
export const isBroken = () => broken;

/** A device for a canvas, or Unsupported. */
export async function firstScreen(canvas) {
  try {
    return await Screen.open(canvas);
  } catch (error) {
    throw error instanceof WebAssembly.RuntimeError ? told(error) : new Unsupported(error.message);
  }
}
