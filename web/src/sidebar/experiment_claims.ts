/** What the paper claims in a figure, each claim with its verdict and the numbers behind it. */
import { type Figure, textOf } from '../experiments/figures';
import { texts } from '../experiments/texts';
import { type Finding, findingOf, type Unit } from '../experiments/verdicts';
import { make } from '../elements/dom';
import { count, duration, lengthError, small } from '../language/numbers';

const PICTURES = import.meta.glob<string>('../experiments/*.svg', { query: '?url', import: 'default', eager: true });

/** The figure itself, where it is no net but a drawing that the native program has made. */
export function makePicture(figure: Figure): HTMLElement[] {
  const src = PICTURES[`../experiments/${figure.name}.svg`];
  return src === undefined ? [] : [make('img', { src, alt: textOf(figure.title) })];
}

export function makeClaims(figure: Figure): HTMLElement {
  const items = figure.claims.map(({ text, check }, i) => {
    const finding = findingOf(figure.name, i);
    const measured = finding ? describe(finding, check, figure) : [texts.unmeasured];
    return make('li', { 'data-verdict': finding?.verdict ?? 'none' }, textOf(text), make('small', {}, ...measured));
  });
  return make('ul', { class: 'claims', 'aria-label': texts.claims }, ...items);
}

function describe({ verdict, held, asked, values }: Finding, check: string, figure: Figure): (Node | string)[] {
  const said = [make('strong', {}, texts.verdicts[verdict]), texts.held(held, asked)];
  if (values.length === 0) return said;
  const names = namesOf(values, check, figure);
  const facts = values.map(({ value, unit }) =>
    value === null ? texts.noEnd : texts.units[unit](numberText(value, unit)),
  );
  const head = texts.measured(asked);
  if (names === null) return [...said, ` ${texts.facts(head, facts)}`];
  const rows = facts.map((fact, i) => make('tr', {}, make('th', { scope: 'row' }, names[i]!), make('td', {}, fact)));
  return [...said, make('table', {}, make('caption', {}, head), ...rows)];
}

/** What is measured in each; null: their units say it. */
function namesOf(values: Finding['values'], check: string, { variants }: Figure): readonly string[] | null {
  const measures = texts.measures[check as keyof typeof texts.measures];
  if (measures) return measures;
  const isOfOne = new Set(values.map(({ variant }) => variant)).size < 2;
  return isOfOne ? null : values.map(({ variant }) => textOf(variants[variant!]!.label));
}

function numberText(value: number, unit: Unit): string {
  switch (unit) {
    case 'iterations':
    case 'vertices':
    case 'edges':
      return count(Math.round(value));
    case 'ms':
      return duration(value);
    case 'dL':
      return lengthError(value);
    case 'times':
    case 'L':
      return count(Number(value.toPrecision(3)));
    case 'share':
      return count(Math.round(100 * value));
    case 'percent':
    case 'frames':
      return count(Math.round(value));
    case 'degrees':
      return value.toFixed(1);
    default:
      return small(value);
  }
}
