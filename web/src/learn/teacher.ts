/** Demonstrates lessons on the open net. Any input of the user but to a lesson ends them, and net and colours are as they
 *  were. */
import type { App } from '../app/app';
import type { HandleData, Vec3, ViewState } from '../document/document';
import { learnWords } from '../language/learn';
import { type Lesson, TAUGHT_METHOD } from '../panels';

/** How far a handle is pulled, in edge lengths: a little to be seen, more to give the solver something to do. */
const LITTLE = 3;
const MUCH = 6;
const PULL_MS = 1800;
/** The part of the way that one picture is worth at most: where pictures are rare the net is seen to move all the same. */
const MOST_OF_PULL = 0.05;
/** Pause between two steps, in milliseconds. */
const STEP_MS = 160;
/** Most iterations; its stages take far fewer. */
const MOST_STEPS = 60;

export class Teacher {
  readonly #app: App;
  #lesson = new AbortController();
  /** Whether a handle is ahead of the net: lessons about the solver go on from there. */
  #ahead: 'no' | 'going' | 'there' = 'no';
  /** Those from before the lesson that changes them. */
  #colours: Pick<ViewState, 'field' | 'colourMap'> | null = null;

  constructor(app: App) {
    this.#app = app;
    // In the capture phase: before the view handles the event.
    for (const touch of ['pointerdown', 'keydown'])
      addEventListener(touch, (event) => isOfLessons(event) || this.#endFor(event), { capture: true });
    // Another net is to take the place of the one that is taught on.
    app.on('opening', () => this.#end());
  }

  async show(lesson: Lesson): Promise<void> {
    this.#lesson.abort();
    this.#lesson = new AbortController();
    const { signal } = this.#lesson;
    if (lesson !== 'stages' || this.#ahead === 'going') this.#letGo();
    this.#takeColoursBack();
    if (lesson === 'deviation') return this.#colour();
    const handle = this.#app.opening?.document.handles.filter(({ anchor, hidden }) => !anchor && !hidden).at(-1);
    if (handle === undefined) return this.#app.say(learnWords.noHandle);
    if (lesson === 'net') await this.#pull(handle, signal);
    else if (lesson === 'energy') await this.#stepAhead(handle, signal);
    else await this.#stage(handle, signal);
  }

  /** Turned or dragged, the net shows more of its colours. */
  #endFor({ target }: Event): void {
    this.#end(target instanceof HTMLCanvasElement);
  }

  #end(keepsColours = false): void {
    this.#lesson.abort();
    this.#letGo();
    if (!keepsColours) this.#takeColoursBack();
  }

  #colour(): void {
    const { field, colourMap } = this.#app.opening!.document.view;
    this.#colours = { field, colourMap };
    this.#app.setView({ field: 'deviation', colourMap: 'log' });
  }

  #takeColoursBack(): void {
    if (this.#colours) this.#app.setView(this.#colours);
    this.#colours = null;
  }

  /** The net is as it was before the handle went ahead: shape, handles and method. */
  #letGo(): void {
    if (this.#ahead === 'no') return;
    this.#ahead = 'no';
    this.#app.handles.endDrag(true);
  }

  /** There and back again; nothing is left of it. */
  async #pull({ vertex, target }: HandleData, signal: AbortSignal): Promise<void> {
    const { handles } = this.#app;
    const aim = this.#inwards(target, LITTLE);
    handles.beginDrag();
    signal.addEventListener('abort', () => handles.endDrag(true));
    let before = performance.now();
    let share = 0;
    while (share < 1 && !signal.aborted) {
      const now = performance.now();
      share = Math.min(1, share + Math.min(MOST_OF_PULL, (now - before) / PULL_MS));
      before = now;
      handles.drag([{ vertex, target: mix(target, aim, Math.sin(Math.PI * share) ** 2) }]);
      await new Promise(requestAnimationFrame);
    }
    if (!signal.aborted) this.#lesson.abort();
  }

  /** The handle far ahead of the net, which has made one step after it. */
  async #stepAhead({ vertex, target }: HandleData, signal: AbortSignal): Promise<void> {
    this.#letGo();
    this.#ahead = 'going';
    this.#app.handles.beginDrag();
    await this.#setMethod(TAUGHT_METHOD);
    if (signal.aborted) return;
    this.#ahead = 'there';
    // The step is requested before the solver starts by itself.
    this.#app.handles.drag([{ vertex, target: this.#inwards(target, MUCH) }]);
    await this.#app.step();
    await this.#app.settled();
  }

  /** Step by step to the next stage, or to the end. */
  async #stage(handle: HandleData, signal: AbortSignal): Promise<void> {
    if (this.#ahead === 'no') await this.#stepAhead(handle, signal);
    const stage = this.#frame()?.stage;
    for (let steps = 0; steps < MOST_STEPS && !signal.aborted; ++steps) {
      if (this.#frame()?.status !== 'running' || this.#frame()?.stage !== stage) break;
      await new Promise((resolve) => setTimeout(resolve, STEP_MS));
      if (signal.aborted) return;
      await this.#app.step();
      await this.#app.settled();
    }
    if (signal.aborted || this.#frame()?.status === 'running') return;
    this.#letGo();
    this.#app.say(learnWords.stagesDone);
  }

  #frame() {
    return this.#app.opening?.frame;
  }

  #setMethod(method: string): Promise<void> {
    const { initialisation, options } = this.#app.opening!.document;
    return this.#app.setOptions({ method, initialisation, options });
  }

  /** From a point towards the middle of the net, where nothing is out of reach. */
  #inwards(point: Vec3, edges: number): Vec3 {
    const { info, restPositions } = this.#app.opening!.net;
    const middle = point.map((_, axis) => mean(restPositions, axis));
    const away = Math.hypot(...point.map((x, axis) => middle[axis]! - x));
    return mix(point, middle, Math.min(0.4, (edges * info.meanLength) / (away || 1)));
  }
}

/** Their own buttons, and the way from one to another. */
function isOfLessons(event: Event): boolean {
  const isTab = event instanceof KeyboardEvent && event.key === 'Tab';
  return isTab || (event.target instanceof Element && event.target.closest('.lesson') !== null);
}

function mix(from: Vec3, to: readonly number[], share: number): Vec3 {
  const along = (axis: 0 | 1 | 2): number => from[axis] + share * (to[axis]! - from[axis]);
  return [along(0), along(1), along(2)];
}

function mean(positions: Float64Array, axis: number): number {
  let sum = 0;
  for (let i = axis; i < positions.length; i += 3) sum += positions[i]!;
  return (3 * sum) / positions.length;
}
