/** What a comparison consists of, as plain data. */
import type { TraceRow } from '../../../wasm/chebnet';
import type { ChebnetDocument, HandleSeed, NetSource, SolverSettings } from '../document/document';
import type { FrameData, Measures } from '../worker/protocol';
import type { RunScene } from './run_solver';

/** Settings for a run of the present edit. */
export interface RunRequest extends SolverSettings {
  label: string;
  /** Another edit in its place, from rest. */
  edit?: { net: NetSource; handles: HandleSeed[] };
}

/** A net by what it is made of: undo opens it anew, as the same. */
export type NetOrigin = Pick<ChebnetDocument, 'net' | 'numbering'>;

/** A run to be made. */
export interface RunPlan {
  /** Its name in curves and table. */
  readonly label: string;
  /** Which of the styles of curves it takes. */
  readonly style: number;
  readonly scene: RunScene;
  /** dL below which it has converged. */
  readonly threshold: number;
  /** The one that was open when the run was asked for: only there its result can be shown. null: it is of another net. */
  readonly net: NetOrigin | null;
}

/** `ended`: the solver came to an end of its own, good or bad; `frame.status` says which. */
type RunState = 'waiting' | 'running' | 'ended' | 'failed' | 'cancelled';

export interface Run extends RunPlan {
  state: RunState;
  /** Largest dL before the first iteration; null until then. */
  startDeviation: number | null;
  trace: TraceRow[];
  /** The newest; null until the net is open. */
  frame: FrameData | null;
  /** Of the last frame; null until the run has ended. */
  measures: Measures | null;
  /** How far its vertices are from those of the first run: root mean square, in mean edge lengths. null until both have
   *  ended, and if their nets are not the same. */
  distance: number | null;
  /** Why it failed. */
  fault: string | null;
}

export interface Comparison {
  readonly runs: readonly Run[];
  running: boolean;
}

/** Where every method starts: at rest with the handles at their targets, or where the net stands. */
export type StartingPoint = 'rest' | 'present';

export interface ComparisonRequest {
  methods: string[];
  start: StartingPoint;
}

export function newRun(plan: RunPlan): Run {
  return {
    ...plan,
    state: 'waiting',
    startDeviation: null,
    trace: [],
    frame: null,
    measures: null,
    distance: null,
    fault: null,
  };
}

/** Whether its net can be shown in the place of the one that is open. */
export function canShow(run: Run, open: NetOrigin | null): boolean {
  return run.frame !== null && isOf(run, open);
}

export function isOf({ net }: RunPlan, open: NetOrigin | null): boolean {
  return net !== null && open !== null && net.net === open.net && net.numbering === open.numbering;
}

/** How many iterations the initialisation made before those of the method. */
export function startLength({ trace }: Pick<Run, 'trace'>): number {
  return trace.filter(({ iteration }) => iteration <= 0).length;
}
