/** Texts for the contents of a file. */
import type { FileReport } from '../files/file_report';
import { dialogWords } from '../language/dialogs';
import { count, lengthDigits } from '../language/numbers';

/** E.g. "961: 900 quads, 61 triangles", the most frequent first. */
export function faceWords({ faces, facesByArity }: Pick<FileReport, 'faces' | 'facesByArity'>): string {
  const kinds = Object.entries(facesByArity)
    .sort(([, a], [, b]) => b - a)
    .map(([arity, number]) => dialogWords.file.polygons(Number(arity), number, count(number)));
  return kinds.length === 1 ? (kinds[0] ?? '') : dialogWords.file.faces(count(faces), kinds);
}

/** E.g. "4 of valence 3, 1 of valence 5". */
export function singularWords(singularVertices: Record<string, number>): string {
  const kinds = Object.entries(singularVertices).map(([valence, number]) =>
    dialogWords.file.singular(valence, count(number)),
  );
  return kinds.length > 0 ? dialogWords.file.list(kinds) : dialogWords.file.none;
}

/** Of the length of an edge from the mean, as a fraction of the mean. */
export function largestDifference({
  shortestLength,
  meanLength,
  longestLength,
}: Pick<FileReport, 'shortestLength' | 'meanLength' | 'longestLength'>): number {
  return Math.max(meanLength - shortestLength, longestLength - meanLength) / meanLength;
}

/** As people read it, large ones with separators, which a field does not take. */
export function lengthWords(length: number): string {
  const rounded = Number(lengthDigits(length));
  return rounded < 1000 ? String(rounded) : count(rounded);
}

/** A fraction with two digits as a percentage. */
export function percentWords(fraction: number): string {
  const percent = 100 * fraction;
  if (percent === 0) return '0 %';
  return percent < 0.001
    ? dialogWords.file.below('0.001 %')
    : `${Number(percent.toPrecision(percent < 100 ? 2 : 3))} %`;
}
