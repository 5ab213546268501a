// Pictures of a canvas that are waited for.
export class Shots {
  #waiting = [];

  get wanted() { return this.#waiting.length > 0; }

  next() { return new Promise((resolve, reject) => this.#waiting.push({ resolve, reject })); }

  /** The canvas has just been drawn. */
  take(canvas) {
    const shots = this.#waiting.splice(0), missing = new Error("the browser made no picture of the canvas");
    canvas.toBlob((blob) => shots.forEach(({ resolve, reject }) => (blob ? resolve(blob) : reject(missing))));
  }

  /** It will not be. */
  refuse(error) { this.#waiting.splice(0).forEach(({ reject }) => reject(error)); }
}
