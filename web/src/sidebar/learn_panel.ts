/** The section of the lessons, which are loaded on demand. */
import { makeSection } from '../elements/dom';
import { words } from '../language/language';
import type { Panel, PanelEvents } from '../panels';
import { lazy } from '../lazy';
import type { FrameData, OpenedNet } from '../worker/protocol';
import type { Lessons } from './lessons';

const loadLessons = lazy(() => import('./lessons'));

export class LearnPanel implements Panel {
  readonly element = makeSection(words.sections.learn, false);
  readonly #events: PanelEvents;
  #lessons: Lessons | null = null;
  #net: OpenedNet | null = null;
  #frame: FrameData | null = null;
  #solving = false;
  /** The exponent of the last iteration that had one. */
  #p = 2;

  /** @param failed is called if they cannot be loaded. */
  constructor(events: PanelEvents, failed: (error: unknown) => void) {
    this.#events = events;
    this.element.addEventListener('toggle', () => this.element.open && this.#unfolded().catch(failed));
  }

  setNet(net: OpenedNet): void {
    this.#net = net;
  }

  onFrame(frame: FrameData): void {
    this.#frame = frame;
    this.#p = frame.trace.filter(({ p }) => p > 0).at(-1)?.p ?? this.#p;
  }

  setFrame(_frame: FrameData, _framesPerSecond: number, solving: boolean): void {
    this.#solving = solving;
    this.#update();
  }

  #update(): void {
    if (this.element.open && this.#net && this.#frame)
      this.#lessons?.update(this.#net, this.#frame, this.#p, this.#solving);
  }

  async #unfolded(): Promise<void> {
    const { Lessons } = await loadLessons();
    if (!this.#lessons) {
      this.#lessons = new Lessons(this.#events);
      this.element.append(...this.#lessons.content);
    }
    this.element.scrollIntoView({ block: 'start' });
    this.#update();
  }
}
