/** The paper, figure by figure: what figures.json says, for the page, the native program and links alike. */
import type { NetSource, SolverSettings, Vec3 } from '../document/document';
import type { FieldName } from '../fields/fields';
import type { Language } from '../language/choice';
import { language } from '../language/language';
import file from './figures.json';

/** The same in every language, or one for each. */
export type Text = string | { [Each in Language]: string };

/** A net with handles: one rests where it is, as an anchor, unless it is said where it goes. */
export interface Edit {
  /** `mesh`: a file in meshes/. */
  net: { recipe: string } | { mesh: string };
  /** Of a recipe, as many as it makes: near to those it asks for. */
  vertices?: number;
  handles: (number | [vertex: number, ...target: Vec3])[];
}

export interface Variant extends Partial<SolverSettings> {
  /** Key by which checks find it. */
  name: string;
  label: Text;
  method: string;
  /** By name, in place of the figure's. */
  edit?: string;
  /** One of our own methods, not in the paper. */
  ours?: true;
  /** What comes of it is a surface, over which a new net is made. */
  remeshes?: true;
}

export interface Claim {
  /** How the program tells whether it holds. */
  check: string;
  text: Text;
}

export interface Figure {
  name: string;
  /** Of Li et al. 2022; null: what section 4 says without one. */
  figure: number | null;
  title: Text;
  /** What to look for. */
  look: Text;
  /** By name; the page opens with the first. */
  edits: string[];
  variants: Variant[];
  claims: Claim[];
  /** What showed this in older versions: for each of its variants the place of the one that took over. */
  was?: { [name: string]: number[] };
  /** Colours to open with. */
  field?: FieldName;
  /** Opens at rest, for a hand to drag. */
  rest?: true;
}

const { edits, figures } = file as unknown as { edits: { [name: string]: Edit }; figures: Figure[] };

export const EDITS: Readonly<typeof edits> = edits;
export const FIGURES: readonly Figure[] = figures;

/** By its name, or by one of older versions. */
export function findFigure(name: string | null | undefined): Figure | undefined {
  if (name === null || name === undefined) return undefined;
  return FIGURES.find((each) => each.name === name) ?? FIGURES.find(({ was }) => was && Object.hasOwn(was, name));
}

/** In the visitor's language. */
export function textOf(text: Text): string {
  return typeof text === 'string' ? text : text[language];
}

export function settingsOf({ method, initialisation = 'naive', options = {} }: Variant): SolverSettings {
  return { method, initialisation, options };
}

/** Whether an edit is of this net. */
export function isOfNet(edit: string, net: NetSource): boolean {
  const own = EDITS[edit]?.net;
  if (own === undefined) return false;
  return 'recipe' in own
    ? 'recipe' in net && net.recipe === own.recipe
    : 'name' in net && net.name === fileNameOf(own.mesh);
}

export function fileNameOf(mesh: string): string {
  return `${mesh}.obj`;
}
