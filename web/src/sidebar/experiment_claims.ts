/** What the paper claims in a figure, each claim with its verdict and the numbers behind it. */
import { type Figure, textOf } from '../experiments/figures';
import { texts } from '../experiments/texts';
import { type Finding, findingOf, type Unit } from '../experiments/verdicts';
import { make } from '../elements/dom';
import { count, milliseconds, NOTHING, small } from '../language/numbers';

const PICTURES = import.meta.glob<string>('../experiments/*.svg', { query: '?url', import: 'default', eager: true });

/** The figure itself, where it is no net but a drawing that the native program has made. */
export function makePicture(figure: Figure): HTMLElement[] {
  const src = PICTURES[`../experiments/${figure.name}.svg`];
  return src === undefined ? [] : [make('img', { src, alt: textOf(figure.title) })];
}

export function makeClaims(figure: Figure): HTMLElement {
  const items = figure.claims.map(({ text }, i) => {
    const finding = findingOf(figure.name, i);
    const measured = finding ? describe(finding, figure) : [texts.unmeasured];
    return make('li', { 'data-verdict': finding?.verdict ?? 'none' }, textOf(text), make('small', {}, ...measured));
  });
  return make('ul', { class: 'claims', 'aria-label': texts.claims }, ...items);
}

function describe({ verdict, held, asked, values }: Finding, figure: Figure): (Node | string)[] {
  const facts = [texts.held(held, asked), ...valueTexts(values, figure)];
  return [make('strong', {}, texts.verdicts[verdict]), ...facts.map((each) => ` · ${each}`)];
}

/** By variant, unless all are of one. */
function valueTexts(values: Finding['values'], { variants }: Figure): string[] {
  const isOfOne = new Set(values.map(({ variant }) => variant)).size < 2;
  return values.map(({ variant, value, unit }) => {
    const text = value === null ? NOTHING : texts.units[unit](numberText(value, unit));
    return isOfOne || variant === undefined ? text : texts.value(textOf(variants[variant]!.label), text);
  });
}

function numberText(value: number, unit: Unit): string {
  switch (unit) {
    case 'iterations':
    case 'vertices':
      return count(Math.round(value));
    case 'ms':
      return milliseconds(value);
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
