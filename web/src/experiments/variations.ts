/** All variants of a figure, to be run one after another. */
import type { RunRequest } from '../compare/run';
import type { Scene } from '../document/document';
import { editScene } from './edits';
import { type Figure, isOfNet, settingsOf, textOf, type Variant } from './figures';

/** On the edit that is open, as far as a variant is not for a net of its own. */
export function variationsOf(figure: Figure, { net }: Pick<Scene, 'net'>): Promise<RunRequest[]> {
  // What is open may be the net of a single variant.
  const usual = figure.variants.some(({ edit }) => edit !== undefined && isOfNet(edit, net))
    ? figure.edits[0]
    : undefined;
  const requestOf = async (variant: Variant): Promise<RunRequest> => {
    const edit = variant.edit ?? usual;
    const isOpen = edit === undefined || isOfNet(edit, net);
    return { label: textOf(variant.label), ...settingsOf(variant), ...(isOpen ? {} : { edit: await editScene(edit) }) };
  };
  return Promise.all(figure.variants.map(requestOf));
}
