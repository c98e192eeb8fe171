/** Progress and results of equalising. */
import type { EqualizeReport } from '../../../wasm/chebnet';
import { dialogWords } from '../language/dialogs';
import { words } from '../language/language';
import { make, setText } from '../elements/dom';
import { lengthWords, percentWords } from './file_words';
import { count, milliseconds, small } from '../language/numbers';

const TEXT = dialogWords.equalize;
/** Below it all edges count as equal; k_equal_deviation of core/edit/equalize.h. */
const EQUAL = 1e-9;

export class EqualizeResults {
  readonly element = make('div', { class: 'results' });
  readonly #progressWords = make('label', { for: 'equalize-progress' });
  readonly #progress = make('progress', { id: 'equalize-progress', max: 1 });
  readonly #progressRow = make('p', { class: 'progress' }, this.#progressWords, this.#progress);
  // In the page from the start: screen readers announce changes of what is there.
  readonly #end = make('div', { role: 'status' });
  #start = NaN;

  constructor() {
    this.element.append(this.#progressRow, this.#end);
    this.clear();
  }

  clear(): void {
    this.#progressRow.hidden = true;
    this.#end.replaceChildren();
  }

  begin(): void {
    this.clear();
    this.#start = NaN;
    this.#progress.removeAttribute('value');
    setText(this.#progressWords, TEXT.starting);
    this.#progressRow.hidden = false;
  }

  /** The bar counts the decades that the largest deviation has gone down; it never goes back. */
  renderProgress({ iterations, maxDeviation }: EqualizeReport): void {
    if (Number.isNaN(this.#start)) this.#start = maxDeviation;
    const done = Math.log(this.#start / maxDeviation) / Math.log(this.#start / EQUAL);
    this.#progress.value = Math.min(1, Math.max(this.#progress.position, done, 0));
    setText(this.#progressWords, TEXT.progress(count(iterations), small(maxDeviation)));
  }

  /** @param asked for by the user. */
  renderEnd(report: EqualizeReport, meanBefore: number, asked: EqualizeReport['method']): void {
    this.clear();
    const equal = isEqual(report);
    const verdict = equal ? TEXT.converged(lengthWords(report.length)) : refusal(report);
    this.#end.append(make('p', { class: equal ? 'verdict' : 'refusal' }, verdict), makeFacts(report, meanBefore));
    if (equal && report.method !== asked) this.#end.append(make('p', {}, TEXT.lengthsAlone));
    else if (report.status === 'exact')
      this.#end.append(make('p', {}, TEXT.beyondLimit(count(report.quadsBeyondLimit))));
    // A smaller change would not be seen.
    if (equal && report.fittingLength > 1.01 * report.length)
      this.#end.append(make('p', {}, TEXT.shrunk(lengthWords(report.fittingLength))));
  }

  /** Beside the verdict, in sight: its sharp folds, and the way out. */
  renderFolds(wayOut: HTMLElement): void {
    this.#end.firstElementChild?.after(make('p', {}, TEXT.crumpled), make('p', {}, wayOut));
  }

  renderFault(sentence: string): void {
    this.clear();
    this.#end.append(make('p', { class: 'refusal' }, TEXT.fault(words.core.sentence(sentence))));
  }
}

function makeFacts(report: EqualizeReport, meanBefore: number): HTMLElement {
  const { before, after, length } = report;
  const range = ({ shortest, longest }: typeof before, mean: number): string =>
    TEXT.range(lengthWords(shortest * mean), lengthWords(longest * mean));
  const facts: [string, string][] = [
    [TEXT.iterations, TEXT.iterationsIn(count(report.iterations), milliseconds(report.milliseconds))],
    [TEXT.deviation, small(report.maxDeviation)],
    [TEXT.edgesBefore, range(before, meanBefore)],
    ...(isEqual(report) ? [] : [[TEXT.edgesNow, range(after, length)] satisfies [string, string]]),
    [TEXT.spreadBefore, percentWords(before.standardDeviation)],
    ...(report.distance === null
      ? []
      : ([
          [TEXT.meanDistance, TEXT.edgeLengths(small(report.distance.mean))],
          [TEXT.largestDistance, TEXT.edgeLengths(small(report.distance.largest))],
        ] satisfies [string, string][])),
    [TEXT.smallestAngle, TEXT.degrees(small((report.smallestAngle * 180) / Math.PI))],
    [TEXT.folds, TEXT.foldsOf(count(report.folds), count(report.foldsBefore))],
    [TEXT.meanMove, TEXT.edgeLengths(small(report.meanMove))],
    [TEXT.maxMove, TEXT.edgeLengths(small(report.maxMove))],
  ];
  return make(
    'dl',
    { class: 'facts' },
    ...facts.map(([term, value]) => make('div', {}, make('dt', {}, term), make('dd', {}, value))),
  );
}

/** Whether all edges have one length, whatever its corners are. */
export function isEqual({ status }: EqualizeReport): boolean {
  return status === 'converged' || status === 'exact';
}

/** The likely reason why no such net was found. */
function refusal({ status, unreachablePairs: [pair], worstEdges: [edge], length, iterations }: EqualizeReport): string {
  if (status === 'unreachable' && pair) {
    return TEXT.unreachable(pair.vertexA, pair.vertexB, lengthWords(pair.distance), lengthWords(pair.reach));
  }
  const why =
    status === 'max_iterations'
      ? TEXT.tooMany(count(iterations))
      : status === 'non_finite'
        ? TEXT.overflow
        : TEXT.stalled;
  const worst = edge ? TEXT.worstEdge(edge.vertexA, edge.vertexB, lengthWords(edge.length), lengthWords(length)) : '';
  return words.core.sentences([why, worst, TEXT.unchanged]);
}
