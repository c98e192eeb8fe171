/** Which places in the history of a net have a good shape, as far as they have been seen. */
import type { ChangeName } from '../document/naming';
import { type HistoryView, numberOf } from '../document/undo';

type Places = Pick<HistoryView, 'names' | 'present' | 'forgotten' | 'inGesture'>;

export class GoodPlaces {
  /** The numbers of those whose shapes are known to be wrong, and what led to them: once that is undone, what is done instead
   *  has the same number. */
  readonly #wrong = new Map<number, ChangeName>();

  /** Of the present one. What a hand holds has no place yet. */
  note(history: Places, isGood: boolean): void {
    if (history.inGesture) return;
    if (isGood) this.#wrong.delete(numberOf(history));
    else this.#wrong.set(numberOf(history), history.names[history.present]!);
  }

  /** The last one before the present; undefined: there is none. */
  lastBefore(history: Places): number | undefined {
    const { names, present } = history;
    let place = present - 1;
    while (place >= 0 && this.#wrong.get(numberOf(history, place)) === names[place]) --place;
    return place < 0 ? undefined : place;
  }

  /** Another net is open. */
  clear(): void {
    this.#wrong.clear();
  }
}
