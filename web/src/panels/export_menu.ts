/** What the net can be saved as. */
import { EXPORT_KINDS } from '../files/export';
import type { FileKind } from '../files/export';
import { words } from '../language/language';
import { Menu } from './menu';

const LOOK = {
  id: 'export-menu',
  icon: 'M8 2.5v8M4.8 7.5 8 10.7l3.2-3.2M2.5 13.5h11',
  ...words.toolbar.save,
  title: words.file.saveAs,
};

export function createExportMenu(save: (kind: FileKind) => void): Menu {
  return new Menu(
    LOOK,
    EXPORT_KINDS.map(({ kind }) => ({ title: kind.toUpperCase(), hint: words.file.kinds[kind], choose: () => save(kind) })),
  );
}
