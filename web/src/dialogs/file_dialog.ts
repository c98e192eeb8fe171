/** The dialog of a file: progress of reading, then its contents and defects, and options for opening it. Escape or Cancel
 *  ends it at any time before the net is opened. */
import type { SurfaceReport } from '../../../wasm/chebnet';
import { READ_STEPS } from '../files/file_protocol';
import type { ReadStep } from '../files/file_protocol';
import { isMostlyTriangles } from '../files/file_report';
import type { FileReport } from '../files/file_report';
import type { FileChoice, FileDialogLike } from './file_opener';
import { dialogWords } from '../language/dialogs';
import { words } from '../language/language';
import { make, makeButton, setText } from '../elements/dom';
import { faceWords, largestDifference, lengthWords, percentWords, singularWords } from './file_words';
import { makeFactList, makeSurfaceFacts, prospectWords } from './surface_facts';
import { count } from '../language/numbers';
import { UpChoice } from './up_choice';
import './dialog.css';
import './file_dialog.css';

export class FileDialog implements FileDialogLike {
  readonly closed: Promise<null>;
  readonly #dialog: HTMLDialogElement;
  readonly #step = make('label', { for: 'file-progress' });
  readonly #progress = make('progress', { id: 'file-progress', max: READ_STEPS.length });
  readonly #progressRow = make('p', { class: 'progress', role: 'status' }, this.#step, this.#progress);
  readonly #cancel = makeButton(dialogWords.file.cancel, () => this.close());
  readonly #body = make('div', { class: 'body' }, this.#progressRow);
  readonly #buttons = make('div', { class: 'buttons' }, this.#cancel);
  #lengths: LengthChoice | null = null;
  #kind: KindChoice | null = null;
  #up: UpChoice | null = null;

  constructor(root: HTMLElement, name: string) {
    const heading = make('h2', { id: 'file-title' }, name);
    this.#dialog = make('dialog', { class: 'file', 'aria-labelledby': heading.id }, heading, this.#body, this.#buttons);
    this.closed = new Promise((resolve) => this.#dialog.addEventListener('close', () => resolve(null)));
    this.#dialog.addEventListener('close', () => this.#dialog.remove());
    this.setStep('loading');
    root.append(this.#dialog);
    this.#dialog.showModal();
  }

  setStep(step: ReadStep): void {
    setText(this.#step, dialogWords.file.steps[step]);
    this.#progress.value = READ_STEPS.indexOf(step);
  }

  ask(report: FileReport): Promise<FileChoice> {
    return new Promise((choose) => {
      if (!report.isChebyshev) this.#lengths ??= new LengthChoice(report);
      const lengths = this.#lengths;
      if (report.surface !== null) this.#kind ??= new KindChoice(report, report.surface);
      const kind = this.#kind;
      const up = (this.#up ??= new UpChoice(report.posture));
      const facts = make('div');
      this.#body.replaceChildren(...(kind ? [kind.element] : []), facts);
      if (report.findings.length > 0) this.#body.append(makeDefects(report));
      if (lengths) this.#body.append(lengths.element);
      this.#body.append(up.element);
      up.draw();
      const chosen = (): FileChoice['restLengths'] => (kind?.isSurface ? 'draped' : (lengths?.chosen ?? 'automatic'));
      const open = (repaired: boolean): void => choose({ repaired, restLengths: chosen(), upAxis: up.chosen });
      const [first, ...others] = openButtons(report, open);
      this.#buttons.replaceChildren(first, ...others, this.#cancel);
      const changed = (): void => {
        facts.replaceChildren(kind?.surface ? makeSurfaceFacts(kind.surface) : makeFacts(report));
        if (lengths) lengths.element.hidden = kind?.isSurface ?? false;
        setOpenWords(report, [first, ...others], chosen());
      };
      for (const choice of [lengths, kind]) if (choice) choice.changed = changed;
      changed();
      first.focus();
    });
  }

  close(): void {
    this.#dialog.close();
  }
}

function makeFacts(report: FileReport): HTMLElement {
  const { vertices, edges, boundaryLoops, components, singularVertices } = report;
  const terms = dialogWords.file.facts;
  return makeFactList([
    [terms.vertices, count(vertices)],
    [terms.edges, count(edges)],
    [terms.faces, faceWords(report)],
    [terms.pieces, count(components)],
    [terms.boundaryLoops, count(boundaryLoops)],
    [terms.singularVertices, singularWords(singularVertices)],
    [terms.shortest, lengthWords(report.shortestLength)],
    [terms.mean, lengthWords(report.meanLength)],
    [terms.longest, lengthWords(report.longestLength)],
    [terms.deviation, percentWords(largestDifference(report))],
  ]);
}

function makeDefects({ findings, refusal }: FileReport): HTMLElement {
  const rows = findings.map((finding) => {
    const name = dialogWords.file.defect(dialogWords.defect(finding.defect), count(finding.count));
    return make('li', {}, make('strong', {}, name), make('span', {}, dialogWords.finding(finding)));
  });
  return make(
    'section',
    { class: 'defects', 'aria-labelledby': 'file-defects' },
    make('h3', { id: 'file-defects' }, dialogWords.file.defects),
    make('p', {}, dialogWords.file.defectsHint),
    make('ul', {}, ...rows),
    ...(refusal === null
      ? []
      : [
          make(
            'p',
            {},
            dialogWords.file.refused(words.core.failure(refusal.code, dialogWords.file.reason(refusal.message))),
          ),
        ]),
  );
}

/** The first button is the default. */
function openButtons(
  { findings, refusal }: FileReport,
  open: (repaired: boolean) => void,
): [HTMLElement, ...HTMLElement[]] {
  const primary = { class: 'primary' };
  if (findings.length === 0) return [makeButton(dialogWords.file.open, () => open(false), primary)];
  const repair = makeButton(dialogWords.file.repair, () => open(true), primary);
  return refusal === null ? [repair, makeButton(dialogWords.file.asItIs, () => open(false))] : [repair];
}

function setOpenWords({ findings }: FileReport, buttons: HTMLElement[], chosen: FileChoice['restLengths']): void {
  const { file, equalize } = dialogWords;
  const [sound, ...broken] =
    chosen === 'draped'
      ? [file.drape, file.repairAndDrape, file.drapeAsItIs]
      : chosen === 'equalized'
        ? [equalize.open, equalize.repairAndOpen, equalize.openAsItIs]
        : [file.open, file.repair, file.asItIs];
  buttons.forEach((button, i) => setText(button, (findings.length === 0 ? [sound] : broken)[i] ?? ''));
}

/** Whether the mesh is a net, or a surface to make one on. */
class KindChoice {
  readonly element: HTMLElement;
  isSurface: boolean;
  changed: () => void = () => {};

  readonly #surface: SurfaceReport | null;

  /** Null: it is a net. */
  get surface(): SurfaceReport | null {
    return this.isSurface ? this.#surface : null;
  }

  constructor(report: FileReport, surface: NonNullable<FileReport['surface']>) {
    const { kind, net, surface: asSurface } = dialogWords.file;
    const isOne = !('code' in surface);
    this.#surface = isOne ? surface : null;
    this.isSurface = isOne && isMostlyTriangles(report);
    const hint = isOne ? prospectWords(surface) : asSurface.notOne(words.core.failure(surface.code, surface.message));
    this.element = make(
      'fieldset',
      { class: 'lengths kind' },
      make('legend', {}, kind),
      this.#row(false, net.text, net.hint, true),
      this.#row(true, asSurface.text, hint, isOne),
    );
  }

  #row(isSurface: boolean, text: string, hint: string, enabled: boolean): HTMLElement {
    const checked = isSurface === this.isSurface;
    const radio = make('input', { type: 'radio', name: 'file-kind', checked, disabled: !enabled });
    radio.addEventListener('change', () => {
      this.isSurface = isSurface;
      this.changed();
    });
    return make('label', {}, radio, make('span', {}, text, make('small', {}, hint)));
  }
}

const LENGTH_CHOICES: readonly {
  value: FileChoice['restLengths'];
  text: (report: FileReport) => string;
  hint: string;
}[] = [
  { value: 'own', text: () => dialogWords.file.own.text, hint: dialogWords.file.own.hint },
  {
    value: 'equal',
    text: ({ meanLength }) => dialogWords.file.equal.text(lengthWords(meanLength)),
    hint: dialogWords.file.equal.hint,
  },
  { value: 'equalized', text: () => dialogWords.equalize.choice, hint: dialogWords.equalize.choiceHint },
];

/** The choice of rest lengths for edges of different length. */
class LengthChoice {
  readonly element: HTMLElement;
  chosen: FileChoice['restLengths'] = 'own';
  changed: () => void = () => {};

  constructor(report: FileReport) {
    const legend = dialogWords.file.lengths(percentWords(largestDifference(report)));
    const rows = LENGTH_CHOICES.map(({ value, text, hint }) => {
      const radio = make('input', { type: 'radio', name: 'file-lengths', value, checked: value === this.chosen });
      radio.addEventListener('change', () => {
        this.chosen = value;
        this.changed();
      });
      return make('label', {}, radio, make('span', {}, text(report), make('small', {}, hint)));
    });
    this.element = make('fieldset', { class: 'lengths' }, make('legend', {}, legend), ...rows);
  }
}
