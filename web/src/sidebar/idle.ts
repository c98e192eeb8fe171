/** Waits until the page is idle: drawing thumbnails must not slow down a drag. */

const QUIET_MS = 400;

export class Idle {
  #last = 0;

  /** Called at any activity. */
  touch(): void {
    this.#last = performance.now();
  }

  async quiet(): Promise<void> {
    for (let left = this.#left(); left > 0; left = this.#left()) await sleep(left);
  }

  #left(): number {
    return this.#last + QUIET_MS - performance.now();
  }
}

export function sleep(milliseconds: number): Promise<void> {
  return new Promise((done) => setTimeout(done, milliseconds));
}
