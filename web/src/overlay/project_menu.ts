/** The project as a whole: new, open, save, what was kept before, and what is made of it. */
import { words } from '../language/language';
import { Menu } from '../elements/menu';
import type { PanelEvents } from '../panels';

/** @param exports opens the menu of what the net can be exported as. */
export function createProjectMenu(events: PanelEvents, exports: () => void): Menu {
  const { newNet, open, save, mine, restore, export: exported, share, ...look } = words.projects.menu;
  const icon = 'M2.5 12.5v-9h4l1.5 2h5.5v7z';
  return new Menu({ id: 'project-menu', icon, ...look }, [
    { ...newNet, choose: events.newNet },
    { ...open, choose: events.pickFile },
    { ...save, choose: events.saveProject },
    { ...mine, choose: events.chooseProject },
    { ...restore, choose: events.restoreLast },
    { ...exported, choose: exports },
    { ...share, choose: events.share },
  ]);
}
