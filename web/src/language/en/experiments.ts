interface NewNetVerdict {
  slower: string;
  kept: string[];
  made: string[];
  edited: string;
  near: string;
}

/** The experiments, apart from what figures.json says of each. */
export const experiments = {
  label: 'Experiment',
  about:
    'The paper’s claims, tried on nets of our own. Verdicts were measured natively; their numbers are those of the first edit.',
  paper:
    'Li, Guo, Wang, Chai, Liu, Fu: Interactive Editing of Discrete Chebyshev Nets. Computer Graphics Forum 41(2), 2022.',
  /** null: what section 4 says without one. */
  figure: (figure: number | null) => (figure === null ? 'Section 4' : `Figure ${figure}`),
  heading: (figure: string, title: string) => `${figure}: ${title}`,
  claims: 'What the paper claims, and what we measured',
  verdicts: { holds: 'Holds', differs: 'Differs', 'does not hold': 'Does not hold' },
  unmeasured: 'Not measured',
  held: (held: number, asked: number) => {
    if (asked === 1) return `: it was ${held === 1 ? '' : 'not '}so in what was tried.`;
    return `: it was so in ${held === asked ? `all ${asked}` : `${held || 'none'} of the ${asked}`} edits.`;
  },
  /** Of several edits; what heads the numbers of the first, in a sentence or a table. */
  measured: (asked: number) => (asked === 1 ? 'Measured' : 'In the first edit'),
  facts: (head: string, facts: string[]) => `${head}: ${facts.join(', ')}.`,
  /** What each number is, where neither its unit nor a variant says so. */
  measures: {
    three_stages: ['Stage 1', 'Stage 2'],
    steeper_near_one: ['Steeper than the power at r = 0.9', 'Steeper than the power at r = 1.1'],
  },
  noEnd: 'no end within the limit',
  /** Numbers come as text; `share` and `percent` in percent. */
  units: {
    iterations: (value: string) => `${value} iterations`,
    ms: (value: string) => value,
    times: (value: string) => `${value} times`,
    dL: (value: string) => `edges off by at most ${value}`,
    L: (value: string) => `${value} edge lengths`,
    edges: (value: string) => `${value} edges`,
    degrees: (value: string) => `${value}°`,
    vertices: (value: string) => `${value} vertices`,
    percent: (value: string) => `${value} %`,
    share: (value: string) => `${value} %`,
    frames: (value: string) => `${value} frames a second`,
    none: (value: string) => value.trim(),
  },
  runAll: 'Run all',
  runAllHint: 'Runs all variants from rest, and shows curves and numbers',
  newNet: {
    label: 'An edit and a new net',
    about:
      'On all three bodies: the net is edited; then its surface alone is deformed, and a new net made over that. It takes up to a minute, in the background.',
    start: 'Make new nets',
    stop: 'Stop',
    starting: 'Starting',
    editing: (body: string) => `${body}: editing`,
    making: (body: string) => `${body}: making a new net`,
    way: 'Way',
    anew: 'A new net',
    time: 'Time',
    singular: 'Singular vertices',
    distance: 'Distance, L',
    range: (least: string, most: string) => `${least} to ${most}`,
    /** `slower` times than the fastest edit; `kept` and `made`: singular vertices of each net. */
    verdict: ({ slower, kept, made, edited, near }: NewNetVerdict) =>
      `A new net took ${slower} times as long as the faster edit. An edit leaves all singular vertices where they were put (${kept.join(', ')}); the new nets have ${made.join(', ')}, where the surface asks for them. Their mean distance from the deformed surface is ${near} L, that of the edited nets ${edited} L.`,
  },
  edits: 'Edits',
  edit: (shape: string, vertices: string) => `${shape.charAt(0).toUpperCase()}${shape.slice(1)} ${vertices}`.trim(),
  meshes: { hexagons: 'Hexagons', mixed: 'Squares and triangles', triangles: 'Triangles' },
  variants: 'Variants',
  ours: 'ours',
  oursHint: 'Not in the paper',
  unknown: 'This link names an experiment that there is not.',
  noVariant: (title: string) => `The experiment "${title}" has no such variant.`,
  noEdit: (title: string) => `The experiment "${title}" has no such edit.`,
};
