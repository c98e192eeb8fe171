/** What the core says. It speaks English: its sentences stand as they are, its names are made readable. */
import type { Tables } from '../../net/tables';
import { readable } from './readable';

/** Methods and initialisations that are more than their words. */
const METHODS: Record<string, string> = {
  li2022: 'Li et al. 2022',
  projected_newton: 'Projected Newton',
  gauss_newton: 'Gauss–Newton',
  dp4: 'D^p, p = 4',
  dp8: 'D^p, p = 8',
  arap: 'ARAP',
  local_global: 'Local–global',
  lbfgs: 'L-BFGS',
};

/** Shapes whose button does not say their name. */
const SHAPES: Record<string, string> = { wave: 'waves' };

export const core = {
  /** With titles for people. */
  tables: (tables: Tables) => tables,
  /** A parameter of a shape. */
  parameter: (name: string) => readable(name),
  /** By their names, shapes that are called otherwise: within a sentence and, but for capitals, on their buttons. */
  shapes: () => SHAPES,
  /** A method or an initialisation. */
  method: (name: string) => METHODS[name] ?? readable(name),
  /** What went wrong. */
  failure: (_code: string, message: string) => message,
  /** As a sentence to be shown by itself. The name of a file stays as it is. */
  sentence: (text: string) => {
    const start = /^[a-z]+[ ,]/.test(text) ? text.charAt(0).toUpperCase() : text.charAt(0);
    return `${start}${text.slice(1)}${/[.!?]$/.test(text) ? '' : '.'}`;
  },
  /** One after the other; an empty one does not count. */
  sentences: (all: string[]) => all.filter((each) => each !== '').join(' '),
};
