// Observes whether a canvas can be seen, its size, and the screen's pixel ratio.

/**
 * Observes how many of the screen's pixels a canvas covers: a query for the pixel ratio alone
 * misses a change now and then. Safari can't, and needs the query.
 */
function observeDevicePixels(observer, canvas) {
  try {
    observer.observe(canvas, { box: "device-pixel-content-box" });
  } catch {
    observer.observe(canvas);
  }
}

export class Visibility {
  #onVisibility;
  #onSize;
  #resizeObserver;
  #intersectionObserver;
  #ratioQuery;
  #isInViewport = true;
  #onRatio = () => {
    this.#followRatio();
    this.#onSize();
  };

  /** `onVisibility` and `onSize` are called after a change of either kind. */
  constructor(canvas, { onVisibility, onSize }) {
    this.#onVisibility = onVisibility;
    this.#onSize = onSize;
    this.#resizeObserver = new ResizeObserver(() => onSize());
    observeDevicePixels(this.#resizeObserver, canvas);
    this.#intersectionObserver = new IntersectionObserver((entries) => {
      this.#isInViewport = entries.at(-1).isIntersecting;
      onVisibility();
    });
    this.#intersectionObserver.observe(canvas);
    this.#followRatio();
    document.addEventListener("visibilitychange", onVisibility);
  }

  get isVisible() {
    return this.#isInViewport && !document.hidden;
  }

  /** A query is for one ratio: after a change another one is needed. */
  #followRatio() {
    this.#ratioQuery?.removeEventListener("change", this.#onRatio);
    this.#ratioQuery = matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    this.#ratioQuery.addEventListener("change", this.#onRatio);
  }

  stop() {
    this.#resizeObserver.disconnect();
    this.#intersectionObserver.disconnect();
    this.#ratioQuery.removeEventListener("change", this.#onRatio);
    document.removeEventListener("visibilitychange", this.#onVisibility);
  }
}
