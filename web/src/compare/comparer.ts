/** Runs methods one after another on the same scene, and tells how far they are. */
import type { WorkerLike } from '../worker/client';
import type { FrameData } from '../worker/protocol';
import { Bench } from './bench';
import type { BenchScene } from './bench';
import { newRun } from './run';
import type { Comparison, Run } from './run';

/** Each method is first run for so long, again and again if it is fast, and that is thrown away: engines compile what they
 *  run, and the first method would pay for all. */
const WARM_UP_MS = 400;

export class Comparer {
  readonly #spawn: () => WorkerLike;
  readonly #changed: (comparison: Comparison) => void;
  #bench: Bench | null = null;
  #comparison: Comparison | null = null;

  /** `changed` is called often; what it is given goes on changing. */
  constructor(spawn: () => WorkerLike, changed: (comparison: Comparison) => void) {
    this.#spawn = spawn;
    this.#changed = changed;
  }

  /** Ends the comparison before, if it still runs. Never fails: a method that does says so in its run. */
  async start(scene: BenchScene, threshold: number, methods: readonly string[]): Promise<void> {
    this.cancel();
    const comparison: Comparison = { runs: methods.map(newRun), threshold, running: true };
    this.#comparison = comparison;
    for (const run of comparison.runs) {
      if (!comparison.running) return;
      await this.#run(comparison, run, { ...scene, method: run.method, settled: false });
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

  async #run(comparison: Comparison, run: Run, scene: BenchScene): Promise<void> {
    run.state = 'running';
    this.#changed(comparison);
    try {
      await this.#solve(comparison, run, scene);
      run.state = 'ended';
    } catch (error) {
      if (!comparison.running) return;
      run.state = 'failed';
      run.fault = error instanceof Error ? error.message : String(error);
      this.#disposeBench();
    }
    this.#changed(comparison);
  }

  async #solve(comparison: Comparison, run: Run, scene: BenchScene): Promise<void> {
    const bench = (this.#bench ??= new Bench(this.#spawn));
    await bench.solve(scene, () => {}, 0); // what the method is still to load is not counted as warming up
    const end = performance.now() + WARM_UP_MS;
    while (performance.now() < end) await bench.solve(scene, () => {}, end - performance.now());
    await bench.solve(scene, (frame) => {
      note(run, frame);
      this.#changed(comparison);
    });
    run.measures = await bench.measure();
  }

  #end(comparison: Comparison): void {
    comparison.running = false;
    this.#disposeBench();
    this.#changed(comparison);
  }

  #disposeBench(): void {
    this.#bench?.dispose();
    this.#bench = null;
  }
}

function note(run: Run, frame: FrameData): void {
  run.startDeviation ??= frame.maxDeviation;
  run.trace.push(...frame.trace);
  run.frame = frame;
}
