/** Experiments as links: `#experiment=NAME`, with `&edit=N` and `&variant=N` for others than the first, counted from 0. They
 *  open unsolved, so that the solve can be watched. */
import { DEFAULT_VIEW } from '../document/defaults';
import type { Scene } from '../document/document';
import { editScene } from './edits';
import { type Figure, findFigure, settingsOf, textOf } from './figures';
import { texts } from './texts';
import { Failure } from '../failure';

const LINK = '#experiment=';

export function isExperimentLink(hash: string): boolean {
  return hash.startsWith(LINK);
}

export function experimentLink(name: string, edit = 0, variant = 0): string {
  return LINK + name + (edit > 0 ? `&edit=${edit}` : '') + (variant > 0 ? `&variant=${variant}` : '');
}

/** What a link opens, as its note is headed; null: there is no such experiment. */
export function experimentTitle(hash: string): string | null {
  const figure = findFigure(new URLSearchParams(hash.slice(1)).get('experiment'));
  return figure === undefined ? null : texts.heading(texts.figure(figure.figure), textOf(figure.title));
}

/** The scene of a link. Throws a Failure. */
export async function experimentScene(hash: string): Promise<Scene> {
  const query = new URLSearchParams(hash.slice(1));
  const name = query.get('experiment');
  const figure = findFigure(name);
  if (name === null || figure === undefined) throw refusal(texts.unknown);
  const variant = figure.variants[placeOf(figure, name, numberIn(query, 'variant'))];
  if (variant === undefined) throw refusal(texts.noVariant(textOf(figure.title)));
  const edit = figure.edits[numberIn(query, 'edit')];
  if (edit === undefined) throw refusal(texts.noEdit(textOf(figure.title)));
  const methods = [...new Set(figure.variants.map(({ method }) => method))];
  return {
    ...(await editScene(variant.edit ?? edit, figure.rest)),
    ...settingsOf(variant),
    view: { ...DEFAULT_VIEW, field: figure.field ?? DEFAULT_VIEW.field },
    positions: null,
    settled: true,
    experiment: figure.name,
    ...(methods.length > 1 ? { compare: methods } : {}),
  };
}

function numberIn(query: URLSearchParams, name: string): number {
  return Number(query.get(name) ?? 0);
}

/** The present index of a link's variant: those of older versions have moved. */
function placeOf(figure: Figure, name: string, variant: number): number {
  return name === figure.name ? variant : (figure.was?.[name]?.[variant] ?? NaN);
}

function refusal(sentence: string): Failure {
  return new Failure('foreign_link', sentence);
}
