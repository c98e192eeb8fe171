/** A notice over the view that it is being recorded, and for how long. */
import { LONGEST } from '../export/recording';
import { panelWords } from '../language/panels';
import { make, makeButton, setText } from '../elements/dom';
import { leave } from '../elements/leave';
import './recording_notice.css';

export class RecordingNotice {
  readonly #time = make('span', { class: 'time' });
  readonly #stop: HTMLButtonElement;
  readonly #element: HTMLElement;

  constructor(root: HTMLElement, stop: () => void) {
    this.#stop = makeButton(panelWords.recording.stop, stop);
    this.#element = make(
      'div',
      { class: 'recording', role: 'group', 'aria-label': panelWords.recording.title },
      make('i', { class: 'dot' }),
      this.#time,
      this.#stop,
    );
    this.setSeconds(0);
    root.append(this.#element);
    this.focus();
  }

  /** Leads to its end. */
  focus(): void {
    this.#stop.focus();
  }

  setSeconds(seconds: number): void {
    setText(this.#time, `${clock(seconds)} / ${clock(LONGEST)}`);
  }

  remove(): void {
    leave(this.#element);
    this.#element.remove();
  }
}

function clock(seconds: number): string {
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`;
}
