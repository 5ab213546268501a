// The WebAssembly module: it is loaded once a page. After a panic it is broken for good.
import init, { CanvasSurface, panicked } from "./effigy_core.js";

const NO_WEBGPU =
  "This browser has no WebGPU. Chrome and Edge from 113 on have it, Safari from 26, " +
  "and Firefox from 141 on Windows, from 145 on Macs.";

let loading;
let panic;

/** There is no WebGPU, or no device for it. */
export class Unsupported extends Error {
  constructor(reason = NO_WEBGPU) {
    super(reason);
    this.name = "Unsupported";
  }
}

/** Whether this browser has WebGPU. */
export const isSupported = () => "gpu" in navigator;

/** Loads the module. After a failure it can be called again. */
export function loadModule() {
  const url = new URL("effigy_core_bg.wasm", import.meta.url);
  loading ??= init({ module_or_path: url }).catch((error) => {
    loading = undefined;
    throw new Error(`effigy_core_bg.wasm can't be loaded: ${error.message}`, { cause: error });
  });
  return loading;
}

/** Whether an error is a panic of the module. */
export const isPanic = (error) => error instanceof WebAssembly.RuntimeError;

/** Turns an error of the module into one for the page. A panic breaks the module for good. */
export function pageError(error) {
  if (!isPanic(error)) return error;
  panic ??= new Error(
    `Effigy has failed, and draws nothing more until this page is loaded again: ${reason(error)}`,
    { cause: error },
  );
  return panic;
}

function reason(error) {
  try {
    return panicked() ?? error.message;
  } catch {
    // After a panic even this call may fail.
    return error.message;
  }
}

/** The error that broke the module, if it is broken. */
export const moduleFailure = () => panic;

/** Opens a device for a canvas. Throws Unsupported if the browser has none. */
export async function openSurface(canvas) {
  try {
    return await CanvasSurface.open(canvas);
  } catch (error) {
    throw isPanic(error) ? pageError(error) : new Unsupported(error.message);
  }
}
