// Whether anybody can see a canvas, and when its size or the screen's pixels change.
export class Watched {
  #tell; #sizes; #views; #ratio; #within = true;
  #onVisible = () => this.#tell(true);
  #onRatio = () => { this.#followRatio(); this.#tell(false); };

  /** `tell` is called after each change, and told whether it was one of being seen. */
  constructor(canvas, tell) {
    this.#tell = tell;
    this.#sizes = new ResizeObserver(() => tell(false));
    this.#sizes.observe(canvas);
    this.#views = new IntersectionObserver((entries) => { this.#within = entries.at(-1).isIntersecting; tell(true); });
    this.#views.observe(canvas);
    this.#followRatio();
    document.addEventListener("visibilitychange", this.#onVisible);
  }

  get seen() { return this.#within && !document.hidden; }

  // A query is of one ratio: after a change it takes another.
  #followRatio() {
    this.#ratio?.removeEventListener("change", this.#onRatio);
    this.#ratio = matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    this.#ratio.addEventListener("change", this.#onRatio);
  }

  stop() {
    this.#sizes.disconnect();
    this.#views.disconnect();
    this.#ratio.removeEventListener("change", this.#onRatio);
    document.removeEventListener("visibilitychange", this.#onVisible);
  }
}
