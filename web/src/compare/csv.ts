/** A comparison as tables for other programs: numbers in full precision, one header line, comma separated. */
import type { TraceRow } from '../../../wasm/chebnet';
import type { SolverOptions } from '../document/document';
import type { Comparison, Run } from './run';

const DEGREES = 180 / Math.PI;

type Cell = string | number | null | undefined;

/** One line a run. */
export function tableCsv({ runs }: Comparison): string {
  const columns: Record<string, (run: Run) => Cell> = {
    run: ({ label }) => label,
    method: ({ scene }) => scene.method,
    initialisation: ({ scene }) => scene.initialisation,
    options: ({ scene }) => optionsText(scene.options),
    state: ({ state, frame }) => (state === 'ended' ? frame?.status : state),
    iterations: ({ frame }) => frame?.iterations,
    milliseconds: ({ frame }) => frame?.milliseconds,
    max_deviation: ({ frame }) => frame?.maxDeviation,
    bend: ({ measures }) => measures?.bend,
    smallest_angle_degrees: ({ measures }) => measures && measures.smallestAngle * DEGREES,
    handle_error: ({ measures }) => measures?.handleError,
    distance_from_first: ({ distance }) => distance,
  };
  return toCsv([Object.keys(columns), ...runs.map((run) => Object.values(columns).map((cell) => cell(run)))]);
}

/** One line an iteration, those of an initialisation up to 0; before them, without a stage, the start. */
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
  const rows = runs.flatMap((run): Cell[][] => {
    const { label, startDeviation, trace } = run;
    const first = (trace[0]?.iteration ?? 1) - 1;
    const start =
      startDeviation === null ? [] : [[label, first, 0, startDeviation, ...columns.slice(3).map(() => null)]];
    return [...start, ...trace.map((row) => [label, ...columns.map(([key]) => row[key])])];
  });
  return toCsv([['run', ...columns.map(([, name]) => name)], ...rows]);
}

function optionsText(options: SolverOptions): string {
  return Object.entries(options)
    .map(([name, value]) => `${name}=${value}`)
    .join(' ');
}

function toCsv(rows: Cell[][]): string {
  return rows.map((cells) => `${cells.map(quoted).join(',')}\n`).join('');
}

/** A comma or a quote would be taken for the end of the cell. */
function quoted(cell: Cell): string | number {
  return typeof cell === 'string' && /[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : (cell ?? '');
}
