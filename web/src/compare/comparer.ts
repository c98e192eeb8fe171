/** Runs one scene after another and reports progress. */
import type { WorkerLike } from '../worker/client';
import type { FrameData } from '../worker/protocol';
import { RunSolver } from './run_solver';
import { newRun } from './run';
import type { Comparison, Run, RunPlan } from './run';
import { messageOf } from '../failure';

/** Milliseconds of warm-up for each scene, repeated if it is fast, whose results are discarded: engines compile code as it
 *  runs, and the first run would pay for all. */
const WARM_UP_MS = 400;

export class Comparer {
  readonly #spawn: () => WorkerLike;
  readonly #changed: (comparison: Comparison) => void;
  #solver: RunSolver | null = null;
  #comparison: Comparison | null = null;

  /** `changed` is called often, with an object that is changed in place. */
  constructor(spawn: () => WorkerLike, changed: (comparison: Comparison) => void) {
    this.#spawn = spawn;
    this.#changed = changed;
  }

  /** Ends the previous comparison, if it still runs. Never rejects: a run that fails has a fault. */
  async start(plans: readonly RunPlan[]): Promise<void> {
    this.cancel();
    const comparison: Comparison = { runs: plans.map(newRun), running: true };
    this.#comparison = comparison;
    for (const run of comparison.runs) {
      if (!comparison.running) return;
      await this.#run(comparison, run);
    }
    if (comparison.running) this.#end(comparison);
  }

  cancel(): void {
    const comparison = this.#comparison;
    if (comparison === null || !comparison.running) return;
    for (const run of comparison.runs) {
      if (run.state === 'waiting' || run.state === 'running') run.state = 'cancelled';
    }
    this.#end(comparison);
  }

  async #run(comparison: Comparison, run: Run): Promise<void> {
    run.state = 'running';
    this.#changed(comparison);
    try {
      await this.#solve(comparison, run);
      run.state = 'ended';
    } catch (error) {
      if (!comparison.running) return;
      run.state = 'failed';
      run.fault = messageOf(error);
      this.#disposeSolver();
    }
    this.#changed(comparison);
  }

  async #solve(comparison: Comparison, run: Run): Promise<void> {
    const scene = { ...run.scene, settled: false };
    const solver = (this.#solver ??= new RunSolver(this.#spawn));
    await solver.solve(scene, () => {}, 0); // what the method is still to load is not counted as warming up
    const end = performance.now() + WARM_UP_MS;
    while (performance.now() < end) await solver.solve(scene, () => {}, end - performance.now());
    const { info } = await solver.solve(scene, (frame) => {
      note(run, frame);
      this.#changed(comparison);
    });
    run.measures = await solver.measure();
    run.distance = distanceBetween(run, comparison.runs[0]!, info.meanLength);
  }

  #end(comparison: Comparison): void {
    comparison.running = false;
    this.#disposeSolver();
    this.#changed(comparison);
  }

  #disposeSolver(): void {
    this.#solver?.dispose();
    this.#solver = null;
  }
}

function note(run: Run, frame: FrameData): void {
  run.startDeviation ??= frame.maxDeviation;
  run.trace.push(...frame.trace);
  run.frame = frame;
}

function distanceBetween(a: Run, b: Run, length: number): number | null {
  const [from, to] = [a.frame?.positions, b.frame?.positions];
  if (a.scene.net !== b.scene.net || from === undefined || to === undefined || b.measures === null) return null;
  const squares = from.reduce((sum, x, i) => sum + (x - to[i]!) ** 2, 0);
  return Math.sqrt(squares / (from.length / 3)) / length;
}
