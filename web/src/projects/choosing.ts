/** "My projects…": the dialog over what the browser keeps. Loaded on demand. */
import { type ProjectParts, ProjectsDialog } from '../dialogs/projects_dialog';
import { LONGEST_PROJECT_NAME } from '../document/document';
import { copyProject, deleteProject, listProjects, PICTURE, renameProject } from './collection';

export function chooseProject(root: HTMLElement, parts: Pick<ProjectParts, 'present' | 'open' | 'keepPresent'>): void {
  new ProjectsDialog(root, {
    ...parts,
    list: listProjects,
    picture: PICTURE,
    longestName: LONGEST_PROJECT_NAME,
    rename: renameProject,
    copy: copyProject,
    delete: deleteProject,
  });
}
