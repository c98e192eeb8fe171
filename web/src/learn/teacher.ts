/** Demonstrates lessons on the open net. Any input of the user ends a lesson and restores the net. */
import type { App } from '../app/app';
import type { HandleData, Vec3 } from '../document/document';
import { learnWords } from '../language/learn';
import type { Lesson } from '../panels';

/** How far a handle is pulled, in edge lengths: a little to be seen, more to give the solver something to do. */
const LITTLE = 3;
const MUCH = 6;
const PULL_MS = 1800;
/** Pause between two steps, in milliseconds. */
const STEP_MS = 160;
/** The method with the stages that are taught. */
const TAUGHT = 'li2022';
/** Most iterations; its stages take far fewer. */
const MOST_STEPS = 60;

export class Teacher {
  readonly #app: App;
  #lesson = new AbortController();
  /** The method to return to after the lesson. */
  #usualMethod: string | null = null;
  #stepping = false;

  constructor(app: App) {
    this.#app = app;
    // In the capture phase: before the view handles the event.
    for (const touch of ['pointerdown', 'keydown'])
      addEventListener(touch, () => this.#lesson.abort(), { capture: true });
    app.on('settled', () => this.#lookAtEnd());
  }

  async show(lesson: Lesson): Promise<void> {
    this.#lesson.abort();
    this.#lesson = new AbortController();
    const { signal } = this.#lesson;
    if (lesson === 'deviation') return this.#app.setView({ field: 'deviation', colourMap: 'log' });
    const handle = this.#app.opening?.document.handles.filter(({ anchor, hidden }) => !anchor && !hidden).at(-1);
    if (handle === undefined) return this.#app.say(learnWords.noHandle);
    if (lesson === 'net') return this.#pull(handle, signal);
    this.#stepping = true;
    if (lesson === 'energy') await this.#stepAhead(handle);
    else await this.#stage(handle, signal);
    if (signal !== this.#lesson.signal) return; // the next has begun
    this.#stepping = false;
    this.#lookAtEnd();
  }

  /** There and back again; nothing is left of it. */
  async #pull({ vertex, target }: HandleData, signal: AbortSignal): Promise<void> {
    const { handles } = this.#app;
    const aim = this.#inwards(target, LITTLE);
    handles.beginDrag();
    signal.addEventListener('abort', () => handles.endDrag(true));
    const start = performance.now();
    let share = 0;
    while (share < 1 && !signal.aborted) {
      share = Math.min(1, (performance.now() - start) / PULL_MS);
      handles.drag([{ vertex, target: mix(target, aim, Math.sin(Math.PI * share) ** 2) }]);
      await new Promise(requestAnimationFrame);
    }
    if (!signal.aborted) this.#lesson.abort();
  }

  /** The handle far ahead of the net, which has made one step after it. */
  async #stepAhead({ vertex, target }: HandleData): Promise<void> {
    await this.#useTaughtMethod();
    // The step is requested before the solver starts by itself.
    const moved = this.#app.handles.move([{ vertex, target: this.#inwards(target, MUCH) }], 'lesson');
    await Promise.all([moved, this.#app.step()]);
    await this.#app.settled();
  }

  /** Step by step to the next stage, or to the end. */
  async #stage(handle: HandleData, signal: AbortSignal): Promise<void> {
    if (this.#usualMethod === null || this.#frame()?.status !== 'running') await this.#stepAhead(handle);
    const stage = this.#frame()?.stage;
    for (let steps = 0; steps < MOST_STEPS && !signal.aborted; ++steps) {
      if (this.#frame()?.status !== 'running' || this.#frame()?.stage !== stage) break;
      await new Promise((resolve) => setTimeout(resolve, STEP_MS));
      await this.#app.step();
      await this.#app.settled();
    }
  }

  #frame() {
    return this.#app.opening?.frame;
  }

  async #useTaughtMethod(): Promise<void> {
    const { method } = this.#app.opening!.document;
    if (method === TAUGHT) return;
    this.#usualMethod = method;
    await this.#setMethod(TAUGHT);
  }

  /** After the solve has ended, in the lesson or by the user, sets the usual method again. */
  #lookAtEnd(): void {
    if (this.#stepping || this.#usualMethod === null || this.#frame()?.status === 'running') return;
    void this.#setMethod(this.#usualMethod).catch((error: unknown) => this.#app.report(error));
    this.#usualMethod = null;
    this.#app.say(learnWords.stagesDone);
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

function mix(from: Vec3, to: readonly number[], share: number): Vec3 {
  const along = (axis: 0 | 1 | 2): number => from[axis] + share * (to[axis]! - from[axis]);
  return [along(0), along(1), along(2)];
}

function mean(positions: Float64Array, axis: number): number {
  let sum = 0;
  for (let i = axis; i < positions.length; i += 3) sum += positions[i]!;
  return (3 * sum) / positions.length;
}
