/** The project as a whole: new, open, save, and what was kept before. */
import { words } from '../language/language';
import { Menu } from '../elements/menu';
import type { PanelEvents } from '../panels';

export function createProjectMenu({ newNet, pickFile, saveProject, chooseProject, restoreLast }: PanelEvents): Menu {
  const { newNet: fresh, open, save, mine, restore, ...look } = words.projects.menu;
  const icon = 'M2.5 12.5v-9h4l1.5 2h5.5v7z';
  return new Menu({ id: 'project-menu', icon, ...look }, [
    { ...fresh, choose: newNet },
    { ...open, choose: pickFile },
    { ...save, choose: saveProject },
    { ...mine, choose: chooseProject },
    { ...restore, choose: restoreLast },
  ]);
}
