/** Shows all of the net once longer edges have taken a part of it out of the picture. */
import type { Panel, PanelEvents } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';

/** So many vertices, all over the net, tell whether it is in the picture. */
const MOST_LOOKED_AT = 500;

export class Growth implements Panel {
  readonly #events: Pick<PanelEvents, 'frameAll' | 'screenPosition'>;
  #vertexCount = 0;
  /** What edges were multiplied by when the net was last at rest; null: it is another net. */
  #scale: number | null = null;

  /** @param element the picture. */
  constructor(
    readonly element: HTMLElement,
    events: Pick<PanelEvents, 'frameAll' | 'screenPosition'>,
  ) {
    this.#events = events;
  }

  setNet({ info }: OpenedNet): void {
    this.#vertexCount = info.vertices;
    this.#scale = null;
  }

  setFrame({ lengthScale }: FrameData, _framesPerSecond: number, solving: boolean): void {
    if (solving) return;
    const before = this.#scale;
    this.#scale = lengthScale;
    if (before !== null && lengthScale > before && !this.#isInPicture()) this.#events.frameAll('here');
  }

  #isInPicture(): boolean {
    const { left, right, top, bottom } = this.element.getBoundingClientRect();
    const step = Math.ceil(this.#vertexCount / MOST_LOOKED_AT);
    for (let vertex = 0; vertex < this.#vertexCount; vertex += step) {
      const { x, y } = this.#events.screenPosition(vertex);
      if (!(x > left && x < right && y > top && y < bottom)) return false;
    }
    return true;
  }
}
