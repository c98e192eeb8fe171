/** The paper's figures as experiments: their description is sound, every edit and variant opens in the real core, and links of
 *  older versions lead to what has taken their place. */
import { describe, expect, test } from 'vitest';
import { editScene } from '../../web/src/experiments/edits';
import { EDITS, FIGURES, findFigure, isOfNet, type Text } from '../../web/src/experiments/figures';
import { experimentLink, experimentScene, isExperimentLink } from '../../web/src/experiments/links';
import { variationsOf } from '../../web/src/experiments/variations';
import type { Scene } from '../../web/src/document/document';
import type { FrameData, Request, Response } from '../../web/src/worker/protocol';
import { Server } from '../../web/src/worker/server';
import { load } from '../wasm/load';
import { wholeCoreOf } from './whole_core_of';

/** All links that versions before the figures made: how many variants each experiment had. */
const FORMER = {
  exponent: 5,
  'adaptive-exponent': 2,
  'fewer-variables': 2,
  'long-edges': 2,
  majorizers: 3,
  energies: 4,
  initialisations: 3,
  arap: 2,
  'local-global': 2,
  'first-order': 3,
  drag: 1,
  'many-handles': 1,
  size: 2,
  'singular-vertices': 1,
  'general-meshes': 1,
};
const FORMER_LINKS = Object.entries(FORMER).flatMap(([name, count]) =>
  Array.from({ length: count }, (_, i) => experimentLink(name, 0, i)),
);

const core = await load();
const methods = core.methods().map(({ name }) => name);
const options = core.options().map(({ name }) => name);
const starts = core.initialisations().map(({ name }) => name);
const LINKS = FIGURES.flatMap(({ name, edits, variants }) =>
  edits.flatMap((_, edit) =>
    variants.map((_, variant) => ({ figure: name, link: experimentLink(name, edit, variant) })),
  ),
);

/** Opens a scene as the worker does. */
function open(scene: Omit<Scene, 'view'>): FrameData {
  const said: Response[] = [];
  const host = {
    post: (response: Response) => said.push(response),
    soon: () => {},
    now: () => 0,
    wholeCore: () => Promise.resolve(wholeCoreOf(core)),
  };
  new Server(core, host).handle({ id: 1, type: 'open', scene } satisfies Request);
  const opened = said.find((each) => each.type === 'opened');
  if (opened) return opened.frame;
  throw new Error(JSON.stringify(said));
}

describe('the description', () => {
  const inBoth = (text: Text) => typeof text === 'string' || (text.en.trim() !== '' && /\p{Script=Han}/u.test(text.zh));

  test('gives each figure a name of its own, and each of its variants', () => {
    const haveOwn = (all: readonly { name: string }[]) => new Set(all.map(({ name }) => name)).size === all.length;
    expect(haveOwn(FIGURES)).toBe(true);
    expect(FIGURES.filter(({ variants }) => !haveOwn(variants))).toEqual([]);
  });

  test.each(FIGURES)('of $name is said in both languages', ({ title, look, claims, variants }) => {
    expect([title, look].every(inBoth)).toBe(true);
    expect(claims.map(({ text }) => text).filter((text) => typeof text === 'string' || !inBoth(text))).toEqual([]);
    expect(variants.map(({ label }) => label).filter((label) => !inBoth(label))).toEqual([]);
  });

  test.each(FIGURES)(
    'of $name names checks, edits, methods and options that there are',
    ({ edits, claims, variants }) => {
      expect(claims.length).toBeGreaterThan(0);
      for (const { check } of claims) expect(check).toMatch(/^[a-z]\w+$/);
      expect(edits.length).toBeGreaterThan(0);
      expect(Object.keys(EDITS)).toEqual(
        expect.arrayContaining([...edits, ...variants.flatMap(({ edit }) => edit ?? [])]),
      );
      expect(methods).toEqual(expect.arrayContaining(variants.map(({ method }) => method)));
      expect(starts).toEqual(
        expect.arrayContaining(variants.map(({ initialisation = 'naive' }) => initialisation.split(':')[0])),
      );
      expect(options).toEqual(
        expect.arrayContaining(variants.flatMap((variant) => Object.keys(variant.options ?? {}))),
      );
      expect(new Set(variants.map(({ label }) => JSON.stringify(label))).size).toBe(variants.length);
    },
  );

  test('leaves no edit unused', () => {
    const used = FIGURES.flatMap(({ edits, variants }) => [...edits, ...variants.flatMap(({ edit }) => edit ?? [])]);
    expect(Object.keys(EDITS).filter((edit) => !used.includes(edit))).toEqual([]);
  });

  test('has one place for every experiment of before', () => {
    const former = FIGURES.flatMap(({ was = {}, variants }) =>
      Object.entries(was).map(([name, places]) => ({ name, places, variants })),
    );
    expect(former.map(({ name }) => name).sort()).toEqual(Object.keys(FORMER).sort());
    for (const { name, places, variants } of former) {
      expect(places).toHaveLength(FORMER[name as keyof typeof FORMER]);
      for (const place of places) expect(variants[place]).toBeDefined();
    }
  });
});

test.each(LINKS)('$link opens a net with its handles within reach, unsolved', async ({ figure, link }) => {
  const scene = await experimentScene(link);
  const { unreachable, status, positions } = open(scene);
  expect(scene).toMatchObject({ experiment: figure, settled: true, positions: null });
  const edit = Object.keys(EDITS).find((each) => isOfNet(each, scene.net))!;
  if ('recipe' in scene.net) expect(EDITS[edit]!.vertices).toBe(positions.length / 3);
  if (figure !== 'failure') expect(unreachable).toEqual([]);
  if (findFigure(figure)?.rest) expect(status).toBe('converged');
  else expect(status).not.toBe('converged');
});

describe('a link', () => {
  test('is told from other links', () => {
    expect(LINKS.every(({ link }) => isExperimentLink(link))).toBe(true);
    expect(isExperimentLink('#v1=abc')).toBe(false);
  });

  test.each([
    '',
    'nonsense',
    'toString',
    'starts&variant=3',
    'starts&variant=-1',
    'starts&variant=0.5',
    'starts&edit=9',
    'drag&variant=1',
  ])('of #experiment=%s is refused', (name) =>
    expect(experimentScene(`#experiment=${name}`)).rejects.toThrow(/experiment/),
  );

  test('carries the settings of a variant and the edit', async () => {
    const { edits } = findFigure('starts')!;
    const { net } = EDITS[edits[1]!]!;
    const expected = { method: 'li2022', initialisation: 'arap:5', net, experiment: 'starts' };
    expect(await experimentScene(experimentLink('starts', 1, 1))).toMatchObject(expected);
  });

  test.each(FORMER_LINKS)('of before still opens: %s', async (link) => {
    const { experiment, method } = await experimentScene(link);
    expect(findFigure(experiment)?.variants.map((variant) => variant.method)).toContain(method);
  });

  test.each([
    ['exponent&variant=3', { options: { adaptive_p: false, p_end: 10 } }],
    ['majorizers', { experiment: 'long-edges', method: 'li2022' }],
    ['local-global', { method: 'local_global' }],
    ['local-global&variant=1', { method: 'li2022' }],
    ['initialisations&variant=2', { initialisation: 'local_global:5' }],
    ['energies&variant=1', { options: { direct_energy: true } }],
  ])('of before means what it meant: %s', async (name, expected) => {
    expect(await experimentScene(`#experiment=${name}`)).toMatchObject(expected);
  });
});

describe('all variants', () => {
  test('run on the edit that is open', async () => {
    const figure = findFigure('starts')!;
    const requests = await variationsOf(figure, await experimentScene(experimentLink('starts', 2, 1)));
    expect(requests.map(({ initialisation, edit }) => [initialisation, edit])).toEqual([
      ['naive', undefined],
      ['arap:5', undefined],
      ['local_global:5', undefined],
    ]);
  });

  test.each([0, 1, 2])(
    'with nets of their own run on those, but on the one that is open as it is open: %i',
    async (open) => {
      const figure = findFigure('resolutions')!;
      const names = figure.variants.map(({ edit }) => edit ?? figure.edits[0]!);
      const requests = await variationsOf(figure, await experimentScene(experimentLink('resolutions', 0, open)));
      expect(requests.map(({ edit }) => edit)).toEqual(
        await Promise.all(names.map((name, i) => (i === open ? undefined : editScene(name)))),
      );
    },
  );
});
