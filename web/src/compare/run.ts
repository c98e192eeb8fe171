/** What a comparison consists of, as plain data. */
import type { TraceRow } from '../../../wasm/chebnet';
import type { FrameData, Measures } from '../worker/protocol';

/** `ended`: the solver came to an end of its own, good or bad; `frame.status` says which. */
export type RunState = 'waiting' | 'running' | 'ended' | 'failed' | 'cancelled';

/** One method on the edit compared. */
export interface Run {
  readonly method: string;
  state: RunState;
  /** Largest dL before the first iteration; null until then. */
  startDeviation: number | null;
  trace: TraceRow[];
  /** The newest; null until the net is open. */
  frame: FrameData | null;
  /** Of the last frame; null until the run has ended. */
  measures: Measures | null;
  /** Why it failed. */
  fault: string | null;
}

export interface Comparison {
  readonly runs: readonly Run[];
  /** dL below which a run has converged. */
  readonly threshold: number;
  running: boolean;
}

/** Where every method starts: at rest with the handles at their targets, or where the net stands. */
export type StartingPoint = 'rest' | 'present';

export interface ComparisonWish {
  methods: string[];
  start: StartingPoint;
}

export function newRun(method: string): Run {
  return { method, state: 'waiting', startDeviation: null, trace: [], frame: null, measures: null, fault: null };
}
