/** A net that came with nearly closed quads has been opened: how many, how far it moved, and the way back. */
import { METHOD_AT_REST } from '../document/defaults';
import type { ChebnetDocument } from '../document/document';
import { longestMove } from '../document/longest_move';
import { make, makeButton, setText } from '../elements/dom';
import { showLine } from '../elements/leave';
import { panelWords } from '../language/panels';
import { sharpQuads } from '../net/sharp_quads';
import type { Tables } from '../net/tables';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { CornerLimit } from './corner_limit';
import './stuck_notice.css';

/** In edge lengths: shorter moves are not seen. */
const SEEN_MOVE = 0.01;

export class SharpNotice implements Panel {
  readonly element = make('div', { class: 'sharp-notice', role: 'status' });
  readonly #words = make('span');
  readonly #line: HTMLElement;
  readonly #limit = new CornerLimit();
  #document: ChebnetDocument | null = null;
  #net: OpenedNet | null = null;
  /** Whether the net has just been opened, and its first solve has not ended. */
  #isNew = false;

  constructor(events: PanelEvents) {
    const leave = makeButton(panelWords.sharp.leave, () => {
      this.#hide();
      events.reset({ ...this.#document!.options, shear_limit: 0 });
    });
    const accept = makeButton(panelWords.sharp.accept, () => this.#hide());
    this.#line = make(
      'div',
      { class: 'message' },
      make('div', {}, this.#words, make('div', { class: 'buttons' }, accept, leave)),
    );
  }

  setTables(tables: Tables): void {
    this.#limit.setTables(tables);
  }

  setDocument(document: ChebnetDocument): void {
    this.#document = document;
  }

  setNet(net: OpenedNet): void {
    this.#net = net;
    this.#isNew = true;
    this.#hide();
  }

  setFrame(frame: FrameData, _framesPerSecond: number, solving: boolean): void {
    if (solving || !this.#isNew || this.#net === null || this.#document?.method !== METHOD_AT_REST) return;
    this.#isNew = false;
    const { info, restPositions } = this.#net;
    const move = longestMove(restPositions, frame.positions) / info.meanLength;
    if (move < SEEN_MOVE || !this.#areAtRest(frame.handles)) return;
    const count = sharpQuads(this.#net, restPositions, this.#limit.of(this.#document)).size;
    if (count === 0) return;
    setText(this.#words, panelWords.sharp.opened(count, move.toFixed(2)));
    showLine(this.element, this.#line, true);
  }

  /** Otherwise the net moved because it was edited. */
  #areAtRest(handles: FrameData['handles']): boolean {
    const rest = this.#net!.restPositions;
    return handles.every(({ vertex, target }) => target.every((x, i) => x === rest[3 * vertex + i]));
  }

  #hide(): void {
    showLine(this.element, this.#line, false);
  }
}
