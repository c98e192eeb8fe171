/** A net being equalised: options at the side, the net in a view of its own; afterwards a slider blends between
 *  before and after. Escape or Cancel ends it at any time. */
import type { EqualizeReport, Mesh } from '../../../wasm/chebnet';
import { between, meanLength, stillFrame } from '../equalize/before_after';
import type { Shape } from '../equalize/before_after';
import type { EqualizeEnd, EqualizeNews } from '../equalize/equalize_protocol';
import { Equalizing } from '../equalize/equalizing';
import type { EqualizeWorkerLike } from '../equalize/equalizing';
import type { Equalized, Subject } from '../equalize/subject';
import { guideTitle } from '../document/changes';
import { textOf } from '../document/naming';
import { MOST_VERTICES_AT_REST } from '../document/defaults';
import type { ViewState } from '../document/document';
import type { EqualizerEnd, EqualizerLike } from './file_opener';
import { dialogWords } from '../language/dialogs';
import { LOOKING_ONLY } from '../view/view';
import type { View, ViewEvents } from '../view/view';
import { make, makeButton, setText } from '../elements/dom';
import { EqualizeForm } from './equalize_form';
import { EqualizeResults, isEqual } from './equalize_results';
import { small } from '../language/numbers';
import { messageOf } from '../failure';
import './dialog.css';
import './pictured.css';
import './equalize_dialog.css';

const TEXT = dialogWords.equalize;
/** Of all edges. */
const MANY_FOLDS = 0.005;

interface EqualizeDialogParts {
  spawnWorker(): EqualizeWorkerLike;
  createView(container: HTMLElement, events: ViewEvents): View;
  upAxis: ViewState['upAxis'];
}

export class EqualizeDialog implements EqualizerLike {
  readonly result: Promise<EqualizerEnd>;
  readonly #before: Shape;
  #after: Shape | null = null;
  readonly #dialog: HTMLDialogElement;
  readonly #view: View;
  readonly #form: EqualizeForm;
  readonly #results = new EqualizeResults();
  readonly #slider = make('input', { type: 'range', min: 0, max: 1, step: 0.01, 'aria-label': TEXT.between });
  readonly #farEnd = make('span');
  readonly #sliderRow = make('div', { class: 'between' }, make('span', {}, TEXT.original), this.#slider, this.#farEnd);
  readonly #caption = make('p', { class: 'quiet' });
  readonly #start = makeButton(TEXT.start, () => void this.#run(), { class: 'primary' });
  readonly #stop = makeButton(TEXT.stop, () => this.#giveUp());
  readonly #take = makeButton(TEXT.take, () => this.#finish(this.#equalized), { class: 'primary' });
  readonly #buttons = make(
    'div',
    { class: 'buttons' },
    this.#start,
    this.#stop,
    this.#take,
    makeButton(TEXT.cancel, () => this.close()),
  );
  #equalizing: Equalizing | null = null;
  /** Null until its edges have become equal. */
  #equalized: Equalized | null = null;
  #finish!: (end: EqualizerEnd) => void;
  readonly #subject: Subject;
  readonly #parts: EqualizeDialogParts;

  constructor(root: HTMLElement, subject: Subject, parts: EqualizeDialogParts) {
    this.#subject = subject;
    this.#parts = parts;
    const { net, positions, name, handles, guide } = subject;
    this.#before = { positions, length: meanLength(positions, net) };
    // Larger nets take minutes to come near a surface.
    const isNear = positions.length / 3 <= MOST_VERTICES_AT_REST;
    const surface = guide ? textOf(guideTitle(guide)) : null;
    this.#form = new EqualizeForm(this.#before.length, handles.length, isNear, surface, () => this.#forget());
    const picture = make('div', { class: 'picture' });
    const heading = make('h2', { id: 'equalize-title' }, TEXT.title(name));
    const figure = make('figure', {}, picture, make('figcaption', {}, this.#sliderRow, this.#caption));
    const side = make(
      'div',
      { class: 'side' },
      make('p', {}, TEXT.introduction),
      this.#form.element,
      this.#results.element,
    );
    this.#dialog = make(
      'dialog',
      { class: 'file pictured equalize', 'aria-labelledby': heading.id },
      heading,
      make('div', { class: 'body' }, figure, side),
      this.#buttons,
    );
    this.#slider.addEventListener('input', () => this.#drawBetween());
    root.append(this.#dialog);
    this.#dialog.showModal();
    this.#view = this.#openView(picture);
    this.result = this.#untilFinished();
    this.#forget();
    // The dialog gave it to the slider between before and after, which is hidden now.
    this.#start.focus();
  }

  close(): void {
    this.#finish(null);
  }

  async #untilFinished(): Promise<EqualizerEnd> {
    const end = await new Promise<EqualizerEnd>((resolve) => {
      this.#finish = resolve;
      this.#dialog.addEventListener('close', () => resolve(null));
    });
    this.#equalizing?.close();
    this.#view.dispose();
    this.#dialog.close();
    this.#dialog.remove();
    return end;
  }

  #openView(picture: HTMLElement): View {
    const view = this.#parts.createView(picture, LOOKING_ONLY);
    const { upAxis } = this.#parts;
    view.setAppearance({ field: 'deviation', colourMap: 'log', showFaces: true, ...(upAxis && { upAxis }) });
    view.setNet(this.#subject.net, stillFrame(this.#before, this.#subject.net), { camera: null });
    return view;
  }

  // --------------------------------------------------------------------------------------------------------- equalising

  async #run(): Promise<void> {
    const options = this.#form.read(this.#subject.handles);
    if (options === null) return;
    this.#equalizing = new Equalizing(() => this.#parts.spawnWorker());
    this.#results.begin();
    this.#arrange('running');
    this.#stop.focus();
    try {
      const mesh = this.#meshAt(this.#subject.positions);
      const guide = this.#form.usesGuide ? this.#subject.guide : undefined;
      const end = await this.#equalizing.run({ mesh, options, guide }, (news) => this.#onProgress(news));
      this.#onEnd(end, typeof options.length === 'number' && !options.handles?.length && !guide);
    } catch (error) {
      this.#results.renderFault(messageOf(error));
      this.#arrange('waiting');
      this.#start.focus();
    }
  }

  #meshAt(positions: Float64Array): Mesh {
    const { faceStart, faceVertices } = this.#subject.net;
    return { positions, faceStart, faceVertices };
  }

  #giveUp(): void {
    this.#equalizing?.close();
    this.#forget();
    this.#start.focus();
  }

  /** Back to the original, to be equalised. */
  #forget(): void {
    this.#equalizing = null;
    this.#after = null;
    this.#equalized = null;
    this.#results.clear();
    this.#slider.value = '0';
    this.#arrange('waiting');
    this.#drawBetween();
  }

  #onProgress({ report, positions }: EqualizeNews): void {
    this.#results.renderProgress(report);
    this.#draw({ positions, length: report.length });
  }

  #onEnd({ report, positions, surfacePositions }: EqualizeEnd, isResized: boolean): void {
    this.#after = { positions, length: report.length };
    const surface = surfacePositions && this.#meshAt(surfacePositions);
    this.#equalized = isEqual(report) ? { mesh: this.#meshAt(positions), surface, isResized } : null;
    this.#results.renderEnd(report, this.#before.length, this.#form.method);
    if (isEqual(report) && this.#isCrumpled(report))
      this.#results.renderFolds(makeButton(TEXT.newNet, () => this.#finish('newNet')));
    this.#form.renderFittingLength(report);
    setText(this.#farEnd, this.#equalized === null ? TEXT.attempt : TEXT.equalised);
    this.#arrange('ended');
    this.#slider.value = '1';
    this.#drawBetween();
    (this.#equalized === null ? this.#slider : this.#take).focus();
  }

  /** Whether it folds sharply where its mesh did not, and that is a surface on which another net can be made. */
  #isCrumpled({ folds, foldsBefore, distance }: EqualizeReport): boolean {
    const edges = this.#subject.net.edges.length / 2;
    return distance !== null && folds - foldsBefore > MANY_FOLDS * edges;
  }

  // ------------------------------------------------------------------------------------------------------------ drawing

  #arrange(state: 'waiting' | 'running' | 'ended'): void {
    this.#form.setBusy(state === 'running');
    this.#start.hidden = state !== 'waiting';
    this.#stop.hidden = state !== 'running';
    this.#take.hidden = this.#equalized === null;
    this.#sliderRow.hidden = state !== 'ended';
  }

  #drawBetween(): void {
    const share = Number(this.#slider.value);
    this.#slider.setAttribute(
      'aria-valuetext',
      share === 0 ? TEXT.original : TEXT.share(Math.round(100 * share), this.#farEnd.textContent ?? ''),
    );
    this.#draw(between(this.#before, this.#after ?? this.#before, share));
  }

  #draw(shape: Shape): void {
    const frame = stillFrame(shape, this.#subject.net);
    this.#view.setFrame(frame);
    setText(this.#caption, TEXT.shown(small(frame.maxDeviation)));
  }
}
