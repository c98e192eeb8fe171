/** What a surface is like, in numbers, and what can be expected of a net on it. */
import type { SurfaceReport } from '../../../wasm/chebnet';
import { make } from '../elements/dom';
import { dialogWords } from '../language/dialogs';
import { count } from '../language/numbers';
import { lengthWords } from './file_words';

/** In a sentence, before anything is tried. Of one that is to be covered as a whole there is nothing to say if it hangs together. */
export function prospectWords(
  { prospect, triedCoverage, components, boundaryLoops, genus }: SurfaceReport,
  kind: 'piece' | 'whole' = 'piece',
): string {
  const words = dialogWords.drape;
  if (components > 1) return words.pieces[kind](components);
  if (kind === 'whole') return '';
  const isRing = 2 * genus + boundaryLoops === 2;
  const covered = `${(100 * triedCoverage).toFixed(0)}\u00a0%`;
  return words.prospects[prospect === 'too_curved' && isRing ? 'ring' : prospect](covered);
}

export function makeSurfaceFacts(report: SurfaceReport): HTMLElement {
  const { triangles, components, boundaryLoops, genus, area, smoothedCurvature } = report;
  const terms = dialogWords.file.facts;
  return makeFactList([
    [terms.triangles, count(triangles)],
    [terms.pieces, count(components)],
    [terms.boundaryLoops, count(boundaryLoops)],
    [terms.genus, count(genus)],
    [terms.area, lengthWords(area)],
    [terms.curvature, terms.bothSigns(inPi(smoothedCurvature.positive), inPi(-smoothedCurvature.negative))],
    [terms.noise, inPi(noiseOf(report))],
  ]);
}

/** What curvature of both signs smoothing takes away, since it cancels: of a scan often most of it. */
function noiseOf({ curvature, smoothedCurvature }: SurfaceReport): number {
  const sum = ({ positive, negative }: SurfaceReport['curvature']): number => positive - negative;
  return Math.max(0, sum(curvature) - sum(smoothedCurvature));
}

function inPi(radians: number): string {
  return `${(radians / Math.PI).toFixed(1)}\u00a0π`;
}

export function makeFactList(facts: readonly (readonly [string, string])[]): HTMLElement {
  return make(
    'dl',
    { class: 'facts' },
    ...facts.map(([term, value]) => make('div', {}, make('dt', {}, term), make('dd', {}, value))),
  );
}
