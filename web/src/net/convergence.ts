/** What the plot shows: the latest solves. While a handle is dragged many short ones follow each other and the oldest are
 *  dropped; once nothing more comes, only the last one is left. */
import type { TraceRow } from '../../../wasm/chebnet';

/** With more iterations than this the oldest solves are dropped. */
const LONGEST = 72;
/** Below this, dL is rounding. */
const SMALLEST = 1e-16;

/** log₁₀ of a dL; null if it has none to show. */
export function decade(deviation: number): number | null {
  return Number.isFinite(deviation) ? Math.log10(Math.max(deviation, SMALLEST)) : null;
}

interface Solve {
  lastIteration: number;
  /** Milliseconds since the solve began. */
  milliseconds: number[];
  maxDeviations: number[];
  stages: string[];
}

/** The record over one axis. A null separates two solves. */
export interface Curve {
  x: number[];
  /** log₁₀ of max dL. */
  y: (number | null)[];
  /** Where stages begin. */
  stageStarts: { x: number; stage: string }[];
}

export class Convergence {
  #solves: Solve[] = [];
  #rested = false;

  /** @param nameOf what a stage is called. */
  add(rows: readonly TraceRow[], nameOf: (stage: number) => string): void {
    for (const { iteration, stage, maxDeviation, totalMs } of rows) {
      // Iterations of an initialisation are numbered up to 0.
      if (!(iteration > (this.#solves.at(-1)?.lastIteration ?? Infinity))) this.#beginSolve();
      const solve = this.#solves.at(-1)!;
      solve.lastIteration = iteration;
      solve.milliseconds.push(totalMs);
      solve.maxDeviations.push(maxDeviation);
      solve.stages.push(nameOf(stage));
    }
    while (this.#solves.length > 1 && this.#length > LONGEST) this.#solves.shift();
  }

  /** Nothing more comes for the time being. */
  rest(): void {
    this.#rested = true;
    this.#solves = this.#solves.slice(-1);
  }

  clear(): void {
    this.#solves = [];
    this.#rested = false;
  }

  curve(byTime: boolean): Curve {
    const curve: Curve = { x: [], y: [], stageStarts: [] };
    let start = 0;
    for (const { milliseconds, maxDeviations, stages } of this.#solves) {
      if (start > 0) push(curve, start, null);
      maxDeviations.forEach((deviation, i) => {
        const x = start + (byTime ? milliseconds[i]! : i + 1);
        if (stages[i] !== stages[i - 1]) curve.stageStarts.push({ x, stage: stages[i]! });
        push(curve, x, decade(deviation));
      });
      start = curve.x.at(-1) ?? 0;
    }
    return curve;
  }

  get #length(): number {
    return this.#solves.reduce((sum, { stages }) => sum + stages.length, 0);
  }

  #beginSolve(): void {
    if (this.#rested) this.clear();
    this.#solves.push({ lastIteration: -Infinity, milliseconds: [], maxDeviations: [], stages: [] });
  }
}

function push({ x, y }: Curve, at: number, value: number | null): void {
  x.push(at);
  y.push(value);
}
