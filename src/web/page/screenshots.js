// Screenshots that pages are waiting for.

export class Screenshots {
  #waiting = [];

  get areWanted() {
    return this.#waiting.length > 0;
  }

  /** A promise of the next frame as a PNG. */
  request() {
    return new Promise((resolve, reject) => this.#waiting.push({ resolve, reject }));
  }

  /** A frame was just drawn on the canvas: encodes it for everyone who waits. */
  take(canvas) {
    const waiting = this.#waiting.splice(0);
    canvas.toBlob((blob) => {
      for (const { resolve, reject } of waiting) {
        if (blob) resolve(blob);
        else reject(new Error("the browser could not encode the canvas"));
      }
    });
  }

  /** No frame will come. */
  reject(error) {
    for (const { reject } of this.#waiting.splice(0)) reject(error);
  }
}
