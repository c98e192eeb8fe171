/** Formulas within texts, as MathML: `{name}` in a text stands for the formula of that name. */

const MATH = 'http://www.w3.org/1998/Math/MathML';

const part = (tag: string, ...children: (Node | string)[]): Element => {
  const element = document.createElementNS(MATH, tag);
  element.append(...children);
  return element;
};
const name = (text: string): Element => part('mi', text);
const number = (text: string): Element => part('mn', text);
const sign = (text: string): Element => part('mo', text);
const power = (base: Element, ...exponent: Element[]): Element => part('msup', base, part('mrow', ...exponent));
const below = (exponent: string): Element[] => [
  name('dL'),
  sign('<'),
  power(number('10'), sign('−'), number(exponent)),
];

const FORMULAS: Record<string, () => Element[]> = {
  r: () => [name('r')],
  p: () => [name('p')],
  dL: () => [name('dL')],
  deviation: () => [
    ...[name('dL'), sign('='), name('r'), sign('+')],
    ...[part('mfrac', number('1'), name('r')), sign('−'), number('2')],
  ],
  energy: () => [power(name('r'), name('p')), sign('+'), power(name('r'), sign('−'), name('p'))],
  atRest: () => [name('r'), sign('='), number('1')],
  p2: () => [name('p'), sign('='), number('2')],
  p50: () => [name('p'), sign('='), number('50')],
  rough: () => below('2'),
  finer: () => below('4'),
  fine: () => below('6'),
};

export function withFormulas(text: string): (Node | string)[] {
  return text.split(/\{(\w+)\}/).map((piece, i) => (i % 2 === 0 ? piece : formula(piece)));
}

function formula(called: string): Element {
  const made = FORMULAS[called];
  if (made === undefined) throw new Error(`there is no formula "${called}"`);
  return part('math', ...made());
}
