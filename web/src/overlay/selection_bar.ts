/** Frequent commands for the selected handles, over the view while there are any. */
import type { Axes } from '../../../wasm/chebnet';
import { axesToSlide, type ChebnetDocument, type HandleData } from '../document/document';
import { type Choice, GIZMO_MODES, type GizmoMode, type LineName } from '../handles/commands';
import { unlocked } from '../handles/selection';
import { panelWords } from '../language/panels';
import { make, makeButton, makeIcon, setText } from '../elements/dom';
import { ICONS } from '../elements/icons';
import { setHidden } from '../elements/leave';
import { NumberField } from '../elements/number_field';
import { whilePointedAt } from '../elements/pointed_at';
import type { Panel, PanelEvents } from '../panels';
import type { OpenedNet } from '../worker/protocol';
import './toolbar.css';
import './selection_bar.css';

/** Most net lines offered: at a singular vertex more may begin. */
const MOST_LINES = 6;
const TEXT = panelWords.selection;

export class SelectionBar implements Panel {
  readonly element: HTMLElement;
  readonly #count = make('span', { class: 'count' });
  readonly #modes: Map<GizmoMode, HTMLButtonElement>;
  readonly #modeGroup: HTMLElement;
  readonly #boundary: HTMLButtonElement;
  readonly #lines: HTMLButtonElement[];
  readonly #radius = new NumberField({
    min: 1,
    step: 1,
    value: 3,
    required: true,
    'aria-label': TEXT.radius,
    title: TEXT.radius,
  });
  readonly #way: HTMLButtonElement;
  readonly #isolate: HTMLButtonElement;
  readonly #lock: HTMLButtonElement;
  readonly #slides: HTMLButtonElement;
  readonly #remove: HTMLButtonElement;
  #ground: Axes = 'xy';
  #selected: readonly HandleData[] = [];
  readonly #events: PanelEvents;

  constructor(events: PanelEvents) {
    this.#events = events;
    const { handles } = events;
    const mode = (each: GizmoMode) =>
      tool(ICONS[each], TEXT.modes[each], TEXT.modeHints[each], () => handles.setMode(each));
    this.#modes = new Map(GIZMO_MODES.map((each) => [each, mode(each)]));
    this.#modeGroup = make('div', { class: 'modes', role: 'group', 'aria-label': TEXT.mode }, ...this.#modes.values());
    this.#boundary = this.#lineButton('boundary', ICONS.boundary, TEXT.boundaryLoop, TEXT.boundaryLoop);
    this.#lines = Array.from({ length: MOST_LINES }, (_, i) =>
      this.#lineButton(i, i % 2 === 0 ? ICONS.along : ICONS.across, TEXT.netLine(i + 1), TEXT.netLineHint),
    );
    this.#way = this.#makeWay();
    this.#isolate = tool(ICONS.isolate, TEXT.isolate, TEXT.isolateHint, () =>
      handles.around((surroundings) => surroundings.isolate()),
    );
    this.#lock = tool(ICONS.locked, panelWords.handles.lock, panelWords.handles.lock, () => this.#turnLock());
    this.#slides = tool(ICONS.slides, TEXT.slides, TEXT.slidesHint, () => this.#turnSliding());
    this.#remove = tool(ICONS.bin, TEXT.remove, TEXT.removeHint, () => handles.remove(this.#vertices));
    this.element = make(
      'div',
      { class: 'toolbar selection-bar', role: 'group', 'aria-label': TEXT.label, hidden: true },
      this.#count,
      this.#modeGroup,
      this.#boundary,
      ...this.#lines,
      this.#way,
      ...this.#makePatch(),
      this.#isolate,
      this.#lock,
      this.#slides,
      this.#remove,
    );
  }

  setNet({ info }: OpenedNet): void {
    // No net is wider than that, measured from vertex to vertex.
    this.#radius.input.max = String(info.vertices);
  }

  setDocument({ view }: ChebnetDocument): void {
    this.#ground = axesToSlide(view.upAxis)[0]!;
  }

  setHandles(handles: readonly HandleData[], { selection, mode, onBoundary, lines, part }: Choice): void {
    const chosen = new Set(selection);
    this.#selected = handles.filter(({ vertex }) => chosen.has(vertex));
    if (this.#selected.length === 0) return this.#hide();
    this.element.hidden = false;
    const moving = unlocked(selection, this.#selected).length;
    setText(this.#count, TEXT.handles(this.#selected.length, this.#selected.length - moving));
    this.#count.title = TEXT.count(this.#selected.length);
    this.#modeGroup.hidden = moving < 2;
    for (const [each, button] of this.#modes) button.setAttribute('aria-pressed', String(each === mode));
    this.#boundary.hidden = !onBoundary;
    this.element.classList.toggle('several', selection.length > 1);
    this.#way.hidden = selection.length < 2;
    this.#lines.forEach((button, i) => (button.hidden = i >= lines));
    this.#isolate.setAttribute('aria-pressed', String(part !== undefined));
    this.#lock.setAttribute('aria-pressed', String(moving === 0));
    this.#slides.setAttribute('aria-pressed', String(this.#allSlide));
    this.#remove.disabled = moving === 0;
  }

  /** Buttons that go cannot be left, and what they preview would stay. */
  #hide(): void {
    if (!this.element.hidden) this.#events.preview([]);
    setHidden(this.element, true);
  }

  get #vertices(): number[] {
    return this.#selected.map(({ vertex }) => vertex);
  }

  get #allSlide(): boolean {
    return this.#selected.every(({ slides }) => slides === this.#ground);
  }

  #turnSliding(): void {
    this.#events.handles.change(this.#vertices, { slides: this.#allSlide ? undefined : this.#ground });
  }

  #turnLock(): void {
    const allLocked = this.#selected.every(({ anchor }) => anchor);
    this.#events.handles.change(this.#vertices, { anchor: !allLocked });
  }

  /** Previews the vertices it would select while it is hovered or has the focus. */
  #lineButton(name: LineName, icon: string, label: string, hint: string): HTMLButtonElement {
    const { handles, preview } = this.#events;
    const button = tool(icon, label, hint, () => {
      preview([]);
      handles.takeLine(name, label);
    });
    button.classList.add('of-line');
    whilePointedAt(
      button,
      () => preview(handles.line(name)),
      () => preview([]),
    );
    return button;
  }

  /** Likewise the vertices on the way through the selected handles. */
  #makeWay(): HTMLButtonElement {
    const { handles, preview } = this.#events;
    const button = tool(ICONS.way, TEXT.way, TEXT.wayHint, () =>
      handles.around((surroundings) => {
        preview([]);
        surroundings.takeWay();
      }),
    );
    whilePointedAt(
      button,
      () => handles.around((surroundings) => preview(surroundings.way())),
      () => handles.around(() => preview([])),
    );
    return button;
  }

  /** Likewise the vertices around the leading handle; its radius can be typed, and Enter takes them. */
  #makePatch(): HTMLElement[] {
    const { handles, preview } = this.#events;
    const show = () => handles.around((surroundings) => preview(surroundings.patch()));
    const hide = () => handles.around(() => preview([]));
    const take = () =>
      handles.around((surroundings) => {
        preview([]);
        surroundings.takePatch();
      });
    const button = tool(ICONS.patch, TEXT.patch, TEXT.patchHint, take);
    const radius = make('label', { class: 'radius' }, this.#radius.input, make('span', {}, TEXT.edges));
    for (const each of [button, radius]) whilePointedAt(each, show, hide);
    this.#radius.input.addEventListener('input', () => {
      const { value } = this.#radius;
      if (value === null) return;
      handles.around((surroundings) => (surroundings.radius = value));
      show();
    });
    this.#radius.input.addEventListener('keydown', ({ key }) => {
      if (key === 'Enter' && this.#radius.value !== null) take();
    });
    return [button, radius, this.#radius.note];
  }
}

function tool(icon: string, label: string, hint: string, click: () => void): HTMLButtonElement {
  const button = makeButton(makeIcon(icon), click, { 'aria-label': label, title: hint });
  button.append(make('span', {}, label));
  return button;
}
