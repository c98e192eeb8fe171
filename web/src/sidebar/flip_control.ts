/** Pushes a net that has buckled through between its handles; says so when it comes back, for want of another equilibrium. */
import type { ChebnetDocument, HandleData } from '../document/document';
import { METHOD_AT_REST } from '../document/defaults';
import { longestMove } from '../document/longest_move';
import { make, makeButton, setText } from '../elements/dom';
import { panelWords } from '../language/panels';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';

/** In edge lengths: a net that has moved no farther has come back. */
const NEAR = 0.05;

export class FlipControl implements Panel {
  readonly element = make('div', { class: 'flip' });
  readonly #button: HTMLButtonElement;
  readonly #outcome = make('p', { class: 'quiet', role: 'status' });
  #net: OpenedNet | null = null;
  #positions: Float64Array | null = null;
  /** Where the net was when it was pushed through; null: its end is known, or was not asked for. */
  #from: Float64Array | null = null;

  constructor(events: PanelEvents) {
    this.#button = makeButton(
      panelWords.flip.label,
      () => {
        this.#from = this.#positions?.slice() ?? null;
        setText(this.#outcome, '');
        events.flip();
      },
      { title: panelWords.flip.hint },
    );
    this.element.append(this.#button, this.#outcome);
  }

  setNet(net: OpenedNet): void {
    this.#net = net;
    this.#from = null;
    setText(this.#outcome, '');
  }

  setDocument({ method }: ChebnetDocument): void {
    this.element.hidden = method !== METHOD_AT_REST;
  }

  setHandles(handles: readonly HandleData[]): void {
    this.#button.disabled = !handles.some(({ weight }) => weight === undefined);
  }

  setFrame(frame: FrameData, _framesPerSecond: number, solving: boolean): void {
    const from = this.#from;
    this.#positions = frame.positions;
    if (solving || from === null || this.#net === null) return;
    this.#from = null;
    const move = longestMove(from, frame.positions) / this.#net.info.meanLength;
    setText(this.#outcome, move < NEAR ? panelWords.flip.back : '');
  }
}
