/** Frequent commands for the selected handles, over the view while there are any. */
import type { HandleData } from '../document/document';
import { type Choice, GIZMO_MODES, type GizmoMode, type LineName } from '../handles/commands';
import { unlocked } from '../handles/selection';
import { words } from '../language/language';
import { make, makeButton, makeIcon, setText } from '../elements/dom';
import { ICONS } from '../elements/icons';
import type { Panel, PanelEvents } from '../panels';
import './toolbar.css';

/** Most net lines offered: at a singular vertex more may begin. */
const MOST_LINES = 6;

export class SelectionBar implements Panel {
  readonly element: HTMLElement;
  readonly #count = make('span', { class: 'count' });
  readonly #modes: Map<GizmoMode, HTMLButtonElement>;
  readonly #modeGroup: HTMLElement;
  readonly #boundary: HTMLButtonElement;
  readonly #lines: HTMLButtonElement[];
  readonly #lock: HTMLButtonElement;
  readonly #remove: HTMLButtonElement;
  #selected: readonly HandleData[] = [];
  readonly #events: PanelEvents;

  constructor(events: PanelEvents) {
    this.#events = events;
    const { handles } = events;
    const mode = (each: GizmoMode) =>
      tool(ICONS[each], words.handles.modes[each], words.handles.modeHints[each], () => handles.setMode(each));
    this.#modes = new Map(GIZMO_MODES.map((each) => [each, mode(each)]));
    this.#modeGroup = make(
      'div',
      { class: 'modes', role: 'group', 'aria-label': words.handles.mode },
      ...this.#modes.values(),
    );
    this.#boundary = this.#lineButton(
      'boundary',
      ICONS.boundary,
      words.handles.boundaryLoop,
      words.handles.boundaryLoop,
    );
    this.#lines = Array.from({ length: MOST_LINES }, (_, i) =>
      this.#lineButton(
        i,
        i % 2 === 0 ? ICONS.along : ICONS.across,
        words.handles.netLine(i + 1),
        words.handles.netLineHint,
      ),
    );
    this.#lock = tool(ICONS.locked, words.handles.lock, words.handles.lock, () => this.#turnLock());
    this.#remove = tool(ICONS.bin, words.handles.removeSelected, words.handles.removeHint, () =>
      handles.remove(this.#vertices),
    );
    this.element = make(
      'div',
      { class: 'toolbar selection-bar', role: 'group', 'aria-label': words.handles.selection, hidden: true },
      this.#count,
      this.#modeGroup,
      this.#boundary,
      ...this.#lines,
      this.#lock,
      this.#remove,
    );
  }

  setHandles(handles: readonly HandleData[], { selection, mode, onBoundary, lines }: Choice): void {
    const chosen = new Set(selection);
    this.#selected = handles.filter(({ vertex }) => chosen.has(vertex));
    this.element.hidden = this.#selected.length === 0;
    if (this.element.hidden) return;
    setText(this.#count, String(this.#selected.length));
    this.#count.title = words.handles.selected(this.#selected.length);
    const moving = unlocked(selection, this.#selected).length;
    this.#modeGroup.hidden = moving < 2;
    for (const [each, button] of this.#modes) button.setAttribute('aria-pressed', String(each === mode));
    this.#boundary.hidden = !onBoundary;
    this.#lines.forEach((button, i) => (button.hidden = i >= lines));
    this.#lock.setAttribute('aria-pressed', String(moving === 0));
    this.#remove.disabled = moving === 0;
  }

  get #vertices(): number[] {
    return this.#selected.map(({ vertex }) => vertex);
  }

  #turnLock(): void {
    const allLocked = this.#selected.every(({ anchor }) => anchor);
    this.#events.handles.change(this.#vertices, { anchor: !allLocked });
  }

  /** Previews the vertices it would select while it is hovered or has the focus. */
  #lineButton(name: LineName, icon: string, label: string, hint: string): HTMLButtonElement {
    const button = tool(icon, label, hint, () => {
      this.#events.previewLine(null);
      this.#events.handles.takeLine(name);
    });
    for (const begin of ['pointerenter', 'focus']) button.addEventListener(begin, () => this.#events.previewLine(name));
    for (const end of ['pointerleave', 'blur']) button.addEventListener(end, () => this.#events.previewLine(null));
    return button;
  }
}

function tool(icon: string, label: string, hint: string, click: () => void): HTMLButtonElement {
  const button = makeButton(makeIcon(icon), click, { 'aria-label': label, title: hint });
  button.append(make('span', {}, label));
  return button;
}
