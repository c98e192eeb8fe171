/** Every experiment opens in the real core and does what its document says. */
import { describe, expect, test } from 'vitest';
import { experimentLink, experimentScene, isExperimentLink } from '../../web/src/experiments/experiment';
import { EXPERIMENTS } from '../../web/src/experiments/list';
import type { FrameData, Request, Response } from '../../web/src/worker/protocol';
import { Session } from '../../web/src/worker/session';
import { load } from '../wasm/load';

const FIGURES = [4, 5, 7, 8, 9, 10, 12, 13, 14, 15, 16, 17, 18, 20, 21];

const core = await load();
const methods = core.methods().map(({ name }) => name);
const LINKS = EXPERIMENTS.flatMap(({ name, variants = [] }) =>
  Array.from({ length: variants.length + 1 }, (_, variant) => experimentLink(name, variant)),
);

/** Opens the scene of a link as the worker does, and solves it if asked to. */
function open(link: string, solve: boolean): { vertices: number; frame: FrameData } {
  const said: Response[] = [];
  const tasks: (() => void)[] = [];
  const host = { post: (response: Response) => said.push(response), soon: (task: () => void) => tasks.push(task), now: () => 0, wholeCore: () => Promise.resolve(core) };
  const session = new Session(core, host);
  const ask = (request: Request) => session.handle(request);
  ask({ id: 1, type: 'open', scene: experimentScene(link) });
  if (solve) ask({ id: 2, type: 'solve' });
  for (let task = tasks.shift(); task; task = tasks.shift()) task();
  const opened = said.find((each) => each.type === 'opened');
  const settled = said.filter((each) => each.type === 'settled').at(-1);
  if (!opened || !settled) throw new Error(JSON.stringify(said.find((each) => each.type === 'error')));
  return { vertices: opened.net.info.vertices, frame: solve ? settled.frame : opened.frame };
}

test('there is one for each figure, with a name of its own', () => {
  expect(EXPERIMENTS.map(({ figure }) => figure)).toEqual(FIGURES);
  expect(new Set(EXPERIMENTS.map(({ name }) => name)).size).toBe(FIGURES.length);
});

test.each(EXPERIMENTS)('$name says in a few sentences what to look for, and names methods that exist', (experiment) => {
  expect(experiment.text.match(/[.:;?](\s|$)/g)?.length).toBeGreaterThanOrEqual(2);
  expect(experiment.text.length).toBeLessThan(300);
  expect(methods).toEqual(expect.arrayContaining(experiment.compare));
});

test.each(LINKS)('%s opens a net of some thousand vertices, its handles within reach', (link) => {
  const { vertices, frame } = open(link, false);
  expect(vertices).toBeGreaterThan(900);
  expect(vertices).toBeLessThan(4200);
  expect(frame.unreachable).toEqual([]);
  // Only the one to be dragged is solved already.
  expect(frame.status).toBe(link === experimentLink('drag') ? 'converged' : 'running');
});

test.each(EXPERIMENTS.filter(({ converges }) => converges))('$name converges', ({ name }) => {
  expect(open(experimentLink(name), true).frame.status).toBe('converged');
});

describe('a link', () => {
  test('is told from other links', () => {
    expect(LINKS.every(isExperimentLink)).toBe(true);
    expect(isExperimentLink('#v1=abc')).toBe(false);
  });
  test.each(['#experiment=', '#experiment=nonsense', '#experiment=drag&variant=1', '#experiment=exponent&variant=-1'])(
    '%s is refused',
    (link) => expect(() => experimentScene(link)).toThrow(/experiment/),
  );
  test('carries the settings of a variant', () => {
    const scene = experimentScene(experimentLink('first-order', 1));
    expect(scene).toMatchObject({ method: 'lbfgs', options: { max_iterations: 1000 }, experiment: 'first-order' });
  });
});
