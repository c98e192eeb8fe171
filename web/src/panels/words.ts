/** Numbers and states as people read them. */
import type { Status, TraceRow } from '../../../wasm/chebnet';
import type { Run } from '../compare/run';

const STATUS: Record<Status, string> = {
  running: 'Solving',
  converged: 'Every edge keeps its length',
  stalled: 'Stuck: no better shape nearby',
  max_iterations: 'Stopped at the iteration limit',
  unreachable: 'Out of reach: holding the best shape',
  non_finite: 'Numbers overflowed: undo or reset',
};

export function statusWords(status: Status, solving: boolean, iterations: number): string {
  if (status !== 'running' || solving) return STATUS[status];
  return iterations > 0 ? 'Stopped before the end' : 'Not solved yet';
}

/** Which stage an iteration belongs to and what is done there. */
export function stageWords({ stage, p, freeVertices }: TraceRow): string {
  const exponent = p > 0 ? `, exponent p = ${p}` : '';
  return `Stage ${stage}${exponent}, ${count(freeVertices)} vertices move`;
}

const RUN_STATUS: Record<Status, string> = {
  running: 'Stopped',
  converged: 'Converged',
  stalled: 'Stalled',
  max_iterations: 'Iteration limit',
  unreachable: 'Out of reach',
  non_finite: 'Overflow',
};

/** How a run of a comparison stands, short enough for a table. */
export function runWords({ state, frame, fault }: Run): string {
  if (state === 'ended' && frame) return RUN_STATUS[frame.status];
  return fault ?? { waiting: 'Waiting', running: 'Running…', ended: '', failed: 'Failed', cancelled: 'Cancelled' }[state];
}

/** Below this a deviation is the rounding of the computer, not of the net. */
export const ROUNDING = 1e-16;

/** A small number with two digits, e.g. 4.2e-7. */
export function small(value: number): string {
  if (value === 0) return '0';
  if (value < ROUNDING) return '< 1e-16';
  if (!Number.isFinite(value)) return '∞';
  return value >= 0.01 && value < 1000 ? String(Number(value.toPrecision(2))) : value.toExponential(1);
}

/** Stands for a number that there is not. */
export const NOTHING = '–';

export function count(value: number): string {
  return value.toLocaleString('en-US');
}

/** Three digits, and no more decimals than a clock in a browser is good for. */
export function milliseconds(value: number): string {
  return value < 99.95 ? value.toFixed(1) : value.toFixed(0);
}

/** A coordinate, to a ten-thousandth of an edge. */
export function coordinate(value: number, edgeLength: number): string {
  const decimals = Math.min(12, Math.max(0, 4 - Math.floor(Math.log10(edgeLength))));
  return String(Number(value.toFixed(decimals)));
}

/** `switch_deviation` → `Switch deviation`; but `p_end` → `p end`, for p is a letter of the paper. */
export function title(name: string): string {
  const words = name.replaceAll('_', ' ');
  if (words.charAt(1) === ' ') return words;
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** Names of the core that are more than their words. */
const METHODS: Record<string, string> = {
  li2022: 'Li et al. 2022',
  projected_newton: 'Projected Newton',
  gauss_newton: 'Gauss–Newton',
  dp4: 'D^p, p = 4',
  dp8: 'D^p, p = 8',
  arap: 'ARAP',
  local_global: 'Local–global',
  lbfgs: 'L-BFGS',
};

/** A method or an initialisation as people call it. */
export function methodTitle(name: string): string {
  return METHODS[name] ?? title(name);
}
