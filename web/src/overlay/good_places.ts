/** Which places in the history of a net have a good shape, as far as they have been seen. */
import { type HistoryView, numberOf } from '../document/undo';

type Places = Pick<HistoryView, 'present' | 'forgotten'>;

export class GoodPlaces {
  /** The numbers of those whose shapes are known to be wrong. */
  readonly #wrong = new Set<number>();

  /** Of the present one. */
  note(history: Places, isGood: boolean): void {
    if (isGood) this.#wrong.delete(numberOf(history));
    else this.#wrong.add(numberOf(history));
  }

  /** The last one before the present; undefined: there is none. */
  lastBefore(history: Places): number | undefined {
    let place = history.present - 1;
    while (this.#wrong.has(numberOf(history, place))) --place;
    return place < 0 ? undefined : place;
  }

  /** Another net is open. */
  clear(): void {
    this.#wrong.clear();
  }
}
