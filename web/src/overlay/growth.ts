/** Shows all of the net once longer edges have taken a part of it out of the picture; a detail that was being looked at stays. */
import type { ChebnetDocument } from '../document/document';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';

/** So many vertices, all over the net, tell whether it is in the picture. */
const MOST_LOOKED_AT = 500;

type Events = Pick<PanelEvents, 'frameAll' | 'isFramed' | 'screenPositions'>;

export class Growth implements Panel {
  readonly #events: Events;
  #vertexCount = 0;
  /** What edges were multiplied by when the net was last at rest; null: it is another net. */
  #scale: number | null = null;
  /** What they are to be multiplied by. */
  #wanted = 1;
  /** Whether all of it was in the picture before they began to grow; null: they are as long as they are to be. */
  #wasInPicture: boolean | null = null;

  /** @param element the picture. */
  constructor(
    readonly element: HTMLElement,
    events: Events,
  ) {
    this.#events = events;
  }

  setNet({ info }: OpenedNet): void {
    this.#vertexCount = info.vertices;
    this.#scale = null;
    this.#wasInPicture = null;
  }

  /** Comes before the frames that follow from it. */
  setDocument({ options }: ChebnetDocument): void {
    const wanted = Number(options['length_scale'] ?? 1);
    // A camera that is still on its way to the whole net will show it.
    if (wanted > this.#wanted) this.#wasInPicture ??= this.#events.isFramed() || this.#isInPicture();
    else if (wanted < this.#wanted) this.#wasInPicture = null;
    this.#wanted = wanted;
  }

  setFrame({ lengthScale }: FrameData, _framesPerSecond: number, solving: boolean): void {
    if (solving) return;
    const hasGrown = this.#scale !== null && lengthScale > this.#scale;
    this.#scale = lengthScale;
    // Numbers come late: this may still be the net of before.
    if (!hasGrown) return;
    if (this.#wasInPicture && !this.#isInPicture()) this.#events.frameAll('here');
    this.#wasInPicture = null;
  }

  #isInPicture(): boolean {
    const { left, right, top, bottom } = this.element.getBoundingClientRect();
    const step = Math.ceil(this.#vertexCount / MOST_LOOKED_AT);
    const vertices: number[] = [];
    for (let vertex = 0; vertex < this.#vertexCount; vertex += step) vertices.push(vertex);
    const places = this.#events.screenPositions(vertices);
    return places.every(({ x, y }) => x > left && x < right && y > top && y < bottom);
  }
}
