/** The dialog of a file: progress of reading, then its contents and defects, and options for opening it. Escape or Cancel
 *  ends it at any time before the net is opened. */
import { READ_STEPS } from '../files/file_protocol';
import type { ReadStep } from '../files/file_protocol';
import type { FileReport } from '../files/file_report';
import type { FileChoice, FileDialogLike } from './file_opener';
import { dialogWords } from '../language/dialogs';
import { words } from '../language/language';
import { make, makeButton, setText } from '../elements/dom';
import { faceWords, largestDifference, lengthWords, percentWords, singularWords } from './file_words';
import { count } from '../language/numbers';
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
      this.#body.replaceChildren(makeFacts(report));
      if (report.findings.length > 0) this.#body.append(makeDefects(report));
      if (lengths) this.#body.append(lengths.element);
      const open = (repaired: boolean): void => choose({ repaired, restLengths: lengths?.chosen ?? 'automatic' });
      const [first, ...others] = openButtons(report, open);
      this.#buttons.replaceChildren(first, ...others, this.#cancel);
      if (lengths) lengths.changed = () => setOpenWords(report, [first, ...others], lengths.chosen === 'equalized');
      lengths?.changed();
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
  const facts: [string, string][] = [
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
  ];
  return make(
    'dl',
    { class: 'facts' },
    ...facts.map(([term, value]) => make('div', {}, make('dt', {}, term), make('dd', {}, value))),
  );
}

function makeDefects({ findings, refusal }: FileReport): HTMLElement {
  const rows = findings.map((finding) => {
    const name = dialogWords.file.defect(words.core.name(finding.defect), count(finding.count));
    return make('li', {}, make('strong', {}, name), make('span', {}, words.core.finding(finding)));
  });
  return make(
    'section',
    { class: 'defects', 'aria-labelledby': 'file-defects' },
    make('h3', { id: 'file-defects' }, dialogWords.file.defects),
    make('p', {}, dialogWords.file.defectsHint),
    make('ul', {}, ...rows),
    ...(refusal === null
      ? []
      : [make('p', {}, dialogWords.file.refused(words.core.failure(refusal.code, refusal.message)))]),
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

function setOpenWords({ findings }: FileReport, buttons: HTMLElement[], equalize: boolean): void {
  const { open, repairAndOpen, openAsItIs } = dialogWords.equalize;
  const sound = [equalize ? open : dialogWords.file.open];
  const broken = equalize ? [repairAndOpen, openAsItIs] : [dialogWords.file.repair, dialogWords.file.asItIs];
  buttons.forEach((button, i) => setText(button, (findings.length === 0 ? sound : broken)[i] ?? ''));
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
