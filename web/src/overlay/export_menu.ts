/** What the net can be saved as, and how. */
import type { FileKind, SaveWish } from '../export/kinds';
import { filmType } from '../export/recording';
import { words } from '../language/language';
import { make } from '../elements/dom';
import { Menu } from '../elements/menu';
import type { MenuItem } from '../elements/menu';
import type { PanelEvents } from '../panels';

const LOOK = {
  id: 'export-menu',
  icon: 'M8 2.5v8M4.8 7.5 8 10.7l3.2-3.2M2.5 13.5h11',
  ...words.toolbar.save,
  title: words.save.as,
};
const MESHES: readonly FileKind[] = ['obj', '3dm', 'ply', 'off', 'stl', 'glb'];
const MAGNIFICATIONS = [1, 2, 4];
const EDGE_MM = { usual: 10, smallest: 1, largest: 1000 };

export function createExportMenu({ save, record }: PanelEvents): Menu {
  const { usual, smallest, largest } = EDGE_MM;
  const edge = make('input', {
    type: 'number',
    value: usual,
    min: smallest,
    max: largest,
    step: 'any',
    'aria-label': words.save.edgeLength,
  });
  const sizes = MAGNIFICATIONS.map((factor) => make('option', { value: factor }, `${factor}×`));
  const size = make('select', { 'aria-label': words.save.magnification }, ...sizes);

  const wish = (kind: FileKind): SaveWish => {
    edge.valueAsNumber = Math.min(largest, Math.max(smallest, edge.valueAsNumber || usual));
    return { kind, edgeMm: edge.valueAsNumber, magnification: Number(size.value) };
  };
  const item = (kind: FileKind, ...beside: HTMLElement[]): MenuItem => {
    return { title: kind.toUpperCase(), hint: words.save.hints[kind], choose: () => save(wish(kind)), beside };
  };
  return new Menu(LOOK, [
    { title: words.save.meshes, items: MESHES.map((kind) => item(kind)) },
    { title: words.save.making, items: [item('svg', edge, make('span', {}, 'mm')), item('csv')] },
    { title: words.save.pictures, items: [item('png', size), recordItem(record)] },
  ]);
}

function recordItem(record: () => void): MenuItem {
  const { kind: title, hint, impossible } = words.recording;
  return filmType() === null
    ? { title, hint: impossible, choose: record, disabled: true }
    : { title, hint, choose: record };
}
