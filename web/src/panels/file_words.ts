/** What a file holds, in words. */
import type { FileReport } from '../files/file_report';
import type { Stage } from '../files/file_protocol';
import { count } from './words';

const STAGE: Record<Stage, string> = {
  loading: 'Loading the file',
  reading: 'Reading the mesh',
  checking: 'Looking for defects',
  measuring: 'Measuring the edges',
  opening: 'Opening the net',
};

export function fileStageWords(stage: Stage): string {
  return STAGE[stage];
}

const POLYGONS: Record<string, [one: string, many: string]> = {
  3: ['triangle', 'triangles'],
  4: ['quad', 'quads'],
  5: ['pentagon', 'pentagons'],
  6: ['hexagon', 'hexagons'],
};

/** E.g. "961: 900 quads, 61 triangles", the most frequent first. */
export function faceWords({ faces, facesByArity }: Pick<FileReport, 'faces' | 'facesByArity'>): string {
  const kinds = Object.entries(facesByArity)
    .sort(([, a], [, b]) => b - a)
    .map(([arity, number]) => {
      const [one, many] = POLYGONS[arity] ?? [`${arity}-gon`, `${arity}-gons`];
      return `${count(number)} ${number === 1 ? one : many}`;
    });
  return kinds.length === 1 ? (kinds[0] ?? '') : `${count(faces)}: ${kinds.join(', ')}`;
}

/** E.g. "4 of valence 3, 1 of valence 5". */
export function singularWords(singularVertices: Record<string, number>): string {
  const kinds = Object.entries(singularVertices).map(([valence, number]) => `${count(number)} of valence ${valence}`);
  return kinds.length > 0 ? kinds.join(', ') : 'none';
}

/** Five digits: an edge of a finished net is off its length by a thousandth at most. */
export function lengthWords(length: number): string {
  return String(Number(length.toPrecision(5)));
}

/** A fraction with two digits as a percentage. */
export function percentWords(fraction: number): string {
  const percent = 100 * fraction;
  if (percent === 0) return '0 %';
  return percent < 0.001 ? 'below 0.001 %' : `${Number(percent.toPrecision(percent < 100 ? 2 : 3))} %`;
}
