/** What can be expected of a net on a surface, and how the one that is shown lies. */
import type { DrapeReport, SurfaceReport } from '../../../wasm/chebnet';
import type { DrapedNet, PhaseTimes, RemeshedNet } from '../drape/drape_protocol';
import { make, setText } from '../elements/dom';
import { dialogWords } from '../language/dialogs';
import { count, milliseconds, small } from '../language/numbers';
import { lengthWords, percentWords } from './file_words';
import { makeSurfaceFacts, prospectWords } from './surface_facts';

const UNKNOWN = '–';
const TEXT = dialogWords.drape;
const DEGREES = 180 / Math.PI;
/** Delay before it is said that a net is being made: most are there at once. */
const PATIENCE_MS = 600;
/** Part of the surface: a net that covers less is not what its prospect promised. */
const COVERS = 0.97;
/** Of the edges, as many as cells twice: a net with more folds looks crumpled. */
const FOLDED = 0.005;

/** Where no vertex could be set. */
function refusedWords({ locked, met }: DrapedNet): string {
  return locked + met > 0 ? TEXT.refusals(count(locked), count(met)) : TEXT.none;
}

function singularWords({ singularVertices }: RemeshedNet): string {
  if (singularVertices.length === 0) return TEXT.none;
  const total = singularVertices.reduce((sum, each) => sum + each.count, 0);
  return TEXT.singularOf(count(total), singularVertices.map((each) => `${each.count} × ${each.valence}`).join(', '));
}

/** Where the surface has edges, a net that follows them is not crumpled. */
function foldWords({ folds, crumpled }: DrapeReport): string {
  if (folds === 0) return TEXT.none;
  return crumpled === folds ? count(folds) : TEXT.foldsOf(count(folds), crumpled > 0 ? count(crumpled) : TEXT.none);
}

/** The total first, then those that took time enough to be read. */
function timeWords(times: PhaseTimes): string {
  const total = Object.values(times).reduce((sum, each) => sum + each, 0);
  const phases = Object.keys(TEXT.times) as (keyof PhaseTimes)[];
  const parts = phases.flatMap((phase) => {
    const time = times[phase] ?? 0;
    return time < 0.05 ? [] : [`${TEXT.times[phase]} ${milliseconds(time)}`];
  });
  return TEXT.timeOf(milliseconds(total), parts);
}

export class DrapeResults {
  // In the page from the start: screen readers announce changes of what is there.
  readonly #prospect = make('p', { class: 'prospect', role: 'status' });
  readonly #numbers = make('details', { class: 'numbers', hidden: true });
  readonly #fault = make('p', { class: 'refusal', role: 'alert', hidden: true });
  readonly #facts = make('dl', { class: 'facts' });
  readonly #making = make('p', { class: 'quiet', role: 'status' });
  readonly element = make('div', { class: 'results' }, this.#fault, this.#facts, this.#making);
  #surface: SurfaceReport | null = null;
  #kind: 'piece' | 'whole' = 'piece';
  #net: DrapedNet | RemeshedNet | null = null;
  /** The one that the facts are of. */
  #measured: DrapedNet | RemeshedNet | null = null;
  /** Another net is being made. */
  #isExpecting = false;
  /** The net is of other settings than are chosen now. */
  #isOutdated = false;
  #againstFolds = '';
  #patience: ReturnType<typeof setTimeout> | undefined;

  get prospect(): HTMLElement {
    return this.#prospect;
  }

  /** Of the surface. */
  get numbers(): HTMLElement {
    return this.#numbers;
  }

  /** Null: it is being opened. */
  setSurface(report: SurfaceReport | null): void {
    this.#surface = report;
    this.#numbers.hidden = report === null;
    if (report !== null) this.#numbers.replaceChildren(make('summary', {}, TEXT.numbers), makeSurfaceFacts(report));
    this.removeNet();
  }

  /** Another kind of net is wanted. */
  setKind(kind: 'piece' | 'whole'): void {
    this.#kind = kind;
    this.removeNet();
  }

  #sayProspect(addition = ''): void {
    const prospect = this.#surface === null ? TEXT.opening : prospectWords(this.#surface, this.#kind);
    const sentences = [prospect, addition].filter((each) => each !== '').join(' ');
    setText(this.#prospect, sentences);
    this.#prospect.hidden = sentences === '';
  }

  /** Of one piece, beside a net: where it covers less than was promised, what to do about it. Of the whole surface
   *  where it is crumpled or leaves some bare. */
  #reviseProspect(net: DrapedNet | RemeshedNet, report: DrapeReport): void {
    if ('singularVertices' in net) return this.#sayProspect(this.#warningOf(net, report));
    const { prospect = '', components = 0 } = this.#surface ?? {};
    const promised = components === 1 && ['one_piece', 'tight'].includes(prospect);
    this.#sayProspect(promised && report.coverage < COVERS ? TEXT.coversLess : '');
  }

  #warningOf(made: RemeshedNet, report: DrapeReport): string {
    const limbs = made.leftOff.length;
    return [limbs > 0 ? TEXT.leftOff(limbs) : '', this.#flawOf(made, report)].filter((each) => each !== '').join(' ');
  }

  #flawOf({ net, sharpQuads, leftOff }: RemeshedNet, { coverage, crumpled }: DrapeReport): string {
    if (crumpled > FOLDED * 2 * net.info.faces) return TEXT.crumpled(count(crumpled), this.#againstFolds);
    if (coverage < COVERS && leftOff.length === 0) return TEXT.leavesBare(percentWords(1 - coverage));
    return sharpQuads > 0 ? TEXT.sharp(count(sharpQuads)) : '';
  }

  /** A net is being made, which the facts are not of; setNet(), keepNet() or setFault() ends that. */
  expectNet(): void {
    this.#expect();
    this.#patience ??= setTimeout(() => setText(this.#making, TEXT.making), PATIENCE_MS);
  }

  #expectNone(): void {
    clearTimeout(this.#patience);
    this.#patience = undefined;
    setText(this.#making, '');
    this.#isExpecting = false;
    this.#showStanding();
  }

  #expect(): void {
    this.#isExpecting = true;
    this.#showStanding();
  }

  #showStanding(): void {
    this.#facts.classList.toggle('stale', this.#isExpecting || this.#isOutdated || this.#measured !== this.#net);
  }

  /** Likewise over the whole surface; how far it is, is said elsewhere. */
  expectWholeNet(): void {
    this.#expect();
    this.#fault.hidden = true;
  }

  /** None was made. */
  keepNet(): void {
    this.#expectNone();
  }

  /** Whether the facts are of other settings than are chosen now. */
  setOutdated(outdated: boolean): void {
    this.#isOutdated = outdated;
    setText(this.#making, outdated ? TEXT.outdated : '');
    this.#showStanding();
  }

  removeNet(): void {
    [this.#net, this.#measured, this.#isOutdated] = [null, null, false];
    this.#expectNone();
    this.#sayProspect();
    this.#facts.replaceChildren();
    this.#fault.hidden = true;
  }

  /** @param againstFolds of a net over the whole surface, what to do if it folds. */
  setNet(net: DrapedNet | RemeshedNet, againstFolds = ''): void {
    this.#net = net;
    this.#againstFolds = againstFolds;
    this.#fault.hidden = true;
    // The other rows stay until they are measured anew: they would flicker while the seed is dragged.
    this.#expectNone();
  }

  /** @param measuring time that took, milliseconds. */
  setReport(report: DrapeReport, measuring: number): void {
    if (this.#net === null) return;
    this.#measured = this.#net;
    this.#showStanding();
    this.#reviseProspect(this.#net, report);
    const { net } = this.#net;
    const { faces, vertices } = net.info;
    const cutEnds = 'cutEnds' in this.#net ? this.#net.cutEnds : 0;
    const inLengths = (distance: number): string => small(distance / report.length);
    const distance = (inUnits: number): string => TEXT.distance(inLengths(inUnits), small(inUnits));
    // A net of few cells may have none that no border has cut.
    const ofCells = (words: string): string => (report.wholeCells > 0 ? words : UNKNOWN);
    // The first three are in sight on a small screen, too.
    const rows: [string, string][] = [
      [TEXT.coverage, TEXT.toHalfAnEdge(percentWords(Number(report.coverage.toFixed(4))))],
      [TEXT.smallestAngle, ofCells(`${(report.smallestAngle * DEGREES).toFixed(0)}°`)],
      [TEXT.meanDistance, distance(report.meanDistance)],
      [TEXT.largestDistance, distance(report.largestDistance)],
      [TEXT.gaps, report.gaps > 0 ? count(report.gaps) : TEXT.none],
      [TEXT.openBorder, report.openBorder > 0 ? TEXT.lengths(inLengths(report.openBorder)) : TEXT.none],
      [TEXT.sheared, ofCells(percentWords(report.sheared))],
      [TEXT.muchSheared, ofCells(percentWords(report.muchSheared))],
      [TEXT.folds, foldWords(report)],
      'singularVertices' in this.#net
        ? [TEXT.singular, singularWords(this.#net)]
        : [TEXT.refused, refusedWords(this.#net)],
      ...('pieces' in this.#net && this.#net.pieces + this.#net.bare > 1
        ? [[TEXT.cuts.pieces, TEXT.cuts.piecesOf(this.#net.pieces, this.#net.bare)] as [string, string]]
        : []),
      [TEXT.size, TEXT.cellsAndVertices(count(faces), count(vertices))],
      [TEXT.length, lengthWords(report.length)],
      [TEXT.rods, TEXT.rodsOf(count(report.rods), lengthWords(report.rodLength))],
      ...(cutEnds > 0 ? [[TEXT.cutEnds, count(cutEnds)] as [string, string]] : []),
      [TEXT.deviation, small(report.maxDeviation)],
      [TEXT.time, timeWords({ ...this.#net.times, measure: measuring })],
    ];
    this.#facts.replaceChildren(
      ...rows.map(([term, value]) => make('div', {}, make('dt', {}, term), make('dd', {}, value))),
    );
  }

  setFault(sentence: string): void {
    this.keepNet();
    this.#fault.hidden = false;
    setText(this.#fault, sentence);
  }
}
