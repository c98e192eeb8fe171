/** Experiments after those of the paper, as scenes that a link opens: `#experiment=NAME` or, with other settings,
 *  `#experiment=NAME&variant=NUMBER`. They open unsolved, so that whoever looks can watch the solve. */
import { DEFAULT_INITIALISATION, DEFAULT_VIEW } from '../document/defaults';
import type { HandleSeed, NetSource, Scene, SolverSettings } from '../document/document';
import { LinkError } from '../document/link_error';
import { words } from '../language/language';
import { EXPERIMENTS } from './list';

export interface Edit {
  net: NetSource;
  handles: HandleSeed[];
}

/** Settings to set beside the experiment's own; what it leaves out stays as it is. */
export interface Variant extends Partial<SolverSettings> {
  label: string;
  edit?: Edit;
}

export interface Experiment {
  name: string;
  /** Of Li et al. 2022, by our reading. */
  figure: number;
  title: string;
  /** What to look for. */
  text: string;
  edit: Edit;
  settings?: Partial<SolverSettings>;
  variants?: Variant[];
  /** Methods to compare on this edit. */
  compare: string[];
  /** Whether the experiment's own settings end below the threshold. */
  converges: boolean;
}

const LINK = '#experiment=';

export function isExperimentLink(hash: string): boolean {
  return hash.startsWith(LINK);
}

/** @param variant counts from 1; 0 is the experiment itself. */
export function experimentLink(name: string, variant = 0): string {
  return LINK + name + (variant > 0 ? `&variant=${variant}` : '');
}

/** The scene of a link. Throws LinkError. */
export function experimentScene(hash: string): Scene {
  const query = new URLSearchParams(hash.slice(1));
  const experiment = findExperiment(query.get('experiment'));
  if (experiment === undefined) throw new LinkError('foreign_link', words.experiment.unknown);
  const number = Number(query.get('variant') ?? 0);
  const variant = number === 0 ? {} : experiment.variants?.[number - 1];
  if (variant === undefined) throw new LinkError('foreign_link', words.experiment.noVariant(experiment.title));
  return toScene(experiment, variant);
}

export function findExperiment(name: string | null | undefined): Experiment | undefined {
  return EXPERIMENTS.find((each) => each.name === name);
}

function toScene({ name, edit, settings, compare }: Experiment, variant: Partial<Variant>): Scene {
  const own = { method: 'li2022', initialisation: DEFAULT_INITIALISATION, ...settings };
  return {
    ...(variant.edit ?? edit),
    method: variant.method ?? own.method,
    initialisation: variant.initialisation ?? own.initialisation,
    options: { ...settings?.options, ...variant.options },
    view: DEFAULT_VIEW,
    positions: null,
    settled: true,
    experiment: name,
    compare,
  };
}
