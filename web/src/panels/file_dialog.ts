/** A file on its way in: how far its reading is, then what it holds, what is wrong with it, and how to open it. Escape or
 *  Cancel ends it at any time before the net is opened. */
import type { RestLengths } from '../../../wasm/chebnet';
import { STAGES } from '../files/file_protocol';
import type { Stage } from '../files/file_protocol';
import type { FileReport } from '../files/file_report';
import type { FileChoice, FileDialogLike } from '../files/import';
import { make, makeButton, setText } from './dom';
import { faceWords, fileStageWords, lengthWords, percentWords, singularWords } from './file_words';
import { count, title } from './words';

export class FileDialog implements FileDialogLike {
  readonly closed: Promise<null>;
  private readonly dialog: HTMLDialogElement;
  private readonly stage = make('label', { for: 'file-progress' });
  private readonly progress = make('progress', { id: 'file-progress', max: STAGES.length });
  private readonly progressRow = make('p', { class: 'progress', role: 'status' }, this.stage, this.progress);
  private readonly cancel = makeButton('Cancel', () => this.close());
  private readonly body = make('div', { class: 'body' }, this.progressRow);
  private readonly buttons = make('div', { class: 'buttons' }, this.cancel);

  constructor(root: HTMLElement, name: string) {
    const heading = make('h2', { id: 'file-title' }, name);
    this.dialog = make('dialog', { class: 'file', 'aria-labelledby': heading.id }, heading, this.body, this.buttons);
    this.closed = new Promise((resolve) => this.dialog.addEventListener('close', () => resolve(null)));
    // Keys are for the dialog alone while it is open.
    this.dialog.addEventListener('keydown', (event) => event.stopPropagation());
    this.dialog.addEventListener('close', () => this.dialog.remove());
    this.showStage('loading');
    root.append(this.dialog);
    this.dialog.showModal();
  }

  showStage(stage: Stage): void {
    setText(this.stage, fileStageWords(stage));
    this.progress.value = STAGES.indexOf(stage);
    if (stage !== 'opening') return;
    // Past the point where it could be called back.
    this.body.replaceChildren(this.progressRow);
    this.buttons.replaceChildren();
  }

  ask(report: FileReport): Promise<FileChoice> {
    return new Promise((choose) => {
      const lengths = report.isChebyshev ? null : new LengthChoice(report);
      this.body.replaceChildren(makeFacts(report));
      if (report.findings.length > 0) this.body.append(makeDefects(report));
      if (lengths) this.body.append(lengths.element);
      const open = (repaired: boolean): void => choose({ repaired, restLengths: lengths?.chosen ?? 'automatic' });
      const [first, ...others] = openButtons(report, open);
      this.buttons.replaceChildren(first, ...others, this.cancel);
      first.focus();
    });
  }

  close(): void {
    this.dialog.close();
  }
}

function makeFacts(report: FileReport): HTMLElement {
  const { vertices, edges, boundaryLoops, components, singularVertices, lengths } = report;
  const facts: [string, string][] = [
    ['Vertices', count(vertices)],
    ['Edges', count(edges)],
    ['Faces', faceWords(report)],
    ['Pieces', count(components)],
    ['Boundary loops', count(boundaryLoops)],
    ['Singular vertices', singularWords(singularVertices)],
    ['Shortest edge', lengthWords(lengths.smallest)],
    ['Mean length', lengthWords(lengths.mean)],
    ['Longest edge', lengthWords(lengths.largest)],
    ['Largest deviation from the mean', percentWords(lengths.largestDeviation)],
  ];
  return make('dl', { class: 'facts' }, ...facts.map(([term, value]) => make('div', {}, make('dt', {}, term), make('dd', {}, value))));
}

function makeDefects({ findings, refusal }: FileReport): HTMLElement {
  const rows = findings.map(({ defect, count: number, sentence }) =>
    make('li', {}, make('strong', {}, `${title(defect)}: ${count(number)}`), make('span', {}, sentence)),
  );
  return make(
    'section',
    { class: 'defects', 'aria-labelledby': 'file-defects' },
    make('h3', { id: 'file-defects' }, 'The mesh has defects'),
    make('p', {}, 'Repair would change this; the numbers above are those of the repaired mesh.'),
    make('ul', {}, ...rows),
    ...(refusal === null ? [] : [make('p', {}, `As it is it cannot be opened: ${refusal}.`)]),
  );
}

/** The first is what Enter does. */
function openButtons({ findings, refusal }: FileReport, open: (repaired: boolean) => void): [HTMLElement, ...HTMLElement[]] {
  const primary = { class: 'primary' };
  if (findings.length === 0) return [makeButton('Open', () => open(false), primary)];
  const repair = makeButton('Repair and open', () => open(true), primary);
  return refusal === null ? [repair, makeButton('Open as it is', () => open(false))] : [repair];
}

const LENGTH_CHOICES: readonly { value: RestLengths; text: (report: FileReport) => string; hint: string }[] = [
  { value: 'own', text: () => 'Keep each edge’s own length', hint: 'The shape stays as it is.' },
  {
    value: 'equal',
    text: ({ lengths }) => `One length, the mean (${lengthWords(lengths.mean)})`,
    hint: 'The shape changes until all edges have it, as far as they can.',
  },
];

/** Which length edges are to keep that differ in length. */
class LengthChoice {
  readonly element: HTMLElement;
  chosen: RestLengths = 'own';

  constructor(report: FileReport) {
    const legend = `Edge lengths differ by up to ${percentWords(report.lengths.largestDeviation)} from the mean`;
    const rows = LENGTH_CHOICES.map(({ value, text, hint }) => {
      const radio = make('input', { type: 'radio', name: 'file-lengths', value, checked: value === this.chosen });
      radio.addEventListener('change', () => (this.chosen = value));
      return make('label', {}, radio, make('span', {}, text(report), make('small', {}, hint)));
    });
    this.element = make('fieldset', { class: 'lengths' }, make('legend', {}, legend), ...rows);
  }
}
