/** What waits for its turn by its distance: a binary heap. */
export class NearestFirst {
  /** None is nearer than the one at half its place, rounded down; the first place is empty. */
  readonly #items: number[] = [-1];
  readonly #distances: number[] = [-Infinity];

  add(item: number, distance: number): void {
    let at = this.#items.length;
    for (; this.#distances[at >> 1]! > distance; at >>= 1) this.#move(at >> 1, at);
    this.#put(at, item, distance);
  }

  /** The nearest, which waits no longer; undefined: nothing does. */
  take(): { item: number; distance: number } | undefined {
    if (this.#items.length === 1) return undefined;
    const nearest = { item: this.#items[1]!, distance: this.#distances[1]! };
    const item = this.#items.pop()!;
    const distance = this.#distances.pop()!;
    if (this.#items.length > 1) this.#put(this.#sink(distance), item, distance);
    return nearest;
  }

  /** Moves up what is nearer than this, from the first place on; returns the place that gets free. */
  #sink(distance: number): number {
    let at = 1;
    for (;;) {
      const [left, right] = [this.#distances[2 * at] ?? Infinity, this.#distances[2 * at + 1] ?? Infinity];
      const next = left <= right ? 2 * at : 2 * at + 1;
      if (Math.min(left, right) >= distance) return at;
      this.#move(next, at);
      at = next;
    }
  }

  #move(from: number, to: number): void {
    this.#put(to, this.#items[from]!, this.#distances[from]!);
  }

  #put(at: number, item: number, distance: number): void {
    this.#items[at] = item;
    this.#distances[at] = distance;
  }
}
