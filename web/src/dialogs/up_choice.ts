/** Which axis of a mesh points up: a picture of both to choose from. Where the mesh does not show it, what was chosen last. */
import type { UpAxis } from '../document/document';
import { make } from '../elements/dom';
import { drawThumbnail } from '../elements/thumbnail';
import type { Posture } from '../files/posture';
import { dialogWords } from '../language/dialogs';

const KEY = 'chebnet.up';

export class UpChoice {
  readonly element: HTMLElement;
  chosen: UpAxis;
  readonly #canvases: { canvas: HTMLCanvasElement; up: UpAxis }[] = [];
  readonly #posture: Posture;

  constructor(posture: Posture) {
    this.#posture = posture;
    this.chosen = posture.isClear ? posture.up : (lastChosen() ?? posture.up);
    this.element = make(
      'fieldset',
      { class: 'lengths up' },
      make('legend', {}, dialogWords.file.up),
      ...(['z', 'y'] as const).map((up) => this.#row(up)),
    );
  }

  /** Once it is in the page. */
  draw(): void {
    const { edges, positions } = this.#posture.sketch;
    for (const { canvas, up } of this.#canvases)
      drawThumbnail(canvas, { edges, positions: up === 'z' ? positions : raised(positions) });
  }

  #row(up: UpAxis): HTMLElement {
    const radio = make('input', { type: 'radio', name: 'file-up', value: up, checked: up === this.chosen });
    radio.addEventListener('change', () => {
      this.chosen = up;
      remember(up);
    });
    const canvas = make('canvas', { 'aria-hidden': 'true' });
    this.#canvases.push({ canvas, up });
    return make('label', {}, canvas, make('span', {}, radio, dialogWords.file.isUp(up)));
  }
}

/** With y up, turned about x. */
function raised(positions: Float32Array): Float32Array {
  return positions.map((_, i) => (i % 3 === 0 ? positions[i]! : i % 3 === 1 ? -positions[i + 1]! : positions[i - 1]!));
}

function lastChosen(): UpAxis | null {
  try {
    const up = localStorage.getItem(KEY);
    return up === 'y' || up === 'z' ? up : null;
  } catch {
    return null; // Storage is switched off.
  }
}

function remember(up: UpAxis): void {
  try {
    localStorage.setItem(KEY, up);
  } catch {
    // As above.
  }
}
