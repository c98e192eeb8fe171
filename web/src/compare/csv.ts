/** A comparison as tables for other programs: numbers whole, one header line, comma separated. */
import type { TraceRow } from '../../../wasm/chebnet';
import type { Comparison, Run } from './run';

const DEGREES = 180 / Math.PI;

type Cell = string | number | null | undefined;

/** One line a method. */
export function tableCsv({ runs }: Comparison): string {
  const header = ['method', 'state', 'iterations', 'milliseconds', 'max_deviation', 'bend', 'smallest_angle_degrees', 'handle_error'];
  const row = ({ method, state, frame, measures }: Run): Cell[] => [
    method,
    state === 'ended' ? frame?.status : state,
    frame?.iterations,
    frame?.milliseconds,
    frame?.maxDeviation,
    measures?.bend,
    measures && measures.smallestAngle * DEGREES,
    measures?.handleError,
  ];
  return toCsv([header, ...runs.map(row)]);
}

/** One line an iteration; iteration 0 is the start. */
export function tracesCsv({ runs }: Comparison): string {
  const columns = Object.entries({
    iteration: 'iteration',
    totalMs: 'milliseconds',
    maxDeviation: 'max_deviation',
    stage: 'stage',
    p: 'p',
    energy: 'energy',
    gradientNorm: 'gradient_norm',
    step: 'step',
    freeVertices: 'free_vertices',
    assemblyMs: 'assembly_ms',
    factorisationMs: 'factorisation_ms',
    lineSearchMs: 'line_search_ms',
  } satisfies Record<keyof TraceRow, string>) as [keyof TraceRow, string][];
  const rows = runs.flatMap(({ method, startDeviation, trace }): Cell[][] => [
    ...(startDeviation === null ? [] : [[method, 0, 0, startDeviation, ...columns.slice(3).map(() => null)]]),
    ...trace.map((row) => [method, ...columns.map(([key]) => row[key])]),
  ]);
  return toCsv([['method', ...columns.map(([, name]) => name)], ...rows]);
}

function toCsv(rows: Cell[][]): string {
  return rows.map((cells) => `${cells.map((cell) => cell ?? '').join(',')}\n`).join('');
}
