/** Waits for a pause in which odd jobs disturb nobody: thumbnails must never get in the way of a drag. */

const QUIET_MS = 400;

export class Idle {
  #last = 0;

  /** Something is going on. */
  touch(): void {
    this.#last = performance.now();
  }

  async quiet(): Promise<void> {
    for (let left = this.#left(); left > 0; left = this.#left()) await new Promise((done) => setTimeout(done, left));
  }

  #left(): number {
    return this.#last + QUIET_MS - performance.now();
  }
}
