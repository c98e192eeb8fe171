/** Figure 3 without a page: what the worker finds out of edits and new nets, and what it says on its way. */
import { expect, test } from 'vitest';
import { EDITS, FIGURES, settingsOf } from '../../web/src/experiments/figures';
import { tryNewNets } from '../../web/src/experiments/new_net';
import type { NewNetRequest, NewNetResponse, TriedEdit } from '../../web/src/experiments/new_net_protocol';
import { hasNewNet } from '../../web/src/sidebar/new_net_trial';
import { load } from '../wasm/load';

const core = await load();
const BODY = 'rabbit:vertices=500';

/** The ears bent a little, with the feet held. */
function request(): NewNetRequest {
  const editor = core.openRecipe(BODY);
  const { restPositions, suggestedHandles } = editor;
  editor.dispose();
  const target = (vertex: number): [number, number, number] => [
    restPositions[3 * vertex]! + 0.5,
    restPositions[3 * vertex + 1]!,
    restPositions[3 * vertex + 2]!,
  ];
  const handles = [...suggestedHandles].map((vertex, i, { length }) => ({
    vertex,
    target: i + 1 < length ? null : target(vertex),
    anchor: true,
  }));
  return {
    edits: [{ net: { recipe: BODY }, handles }],
    ways: [{ method: 'projection', initialisation: 'naive', options: {} }],
    deforming: { method: 'arap', initialisation: 'naive', options: {} },
  };
}

function responsesTo(asked: NewNetRequest): NewNetResponse[] {
  const responses: NewNetResponse[] = [];
  tryNewNets(core, asked, (response) => responses.push(response));
  return responses;
}

test('an edit keeps the singular vertices, a new net has its own; both are measured from the deformed surface', {
  timeout: 60_000,
}, () => {
  const responses = responsesTo(request());
  expect(responses.at(-1)).toEqual({ type: 'ended' });
  const [{ edited, made }] = responses.flatMap((each) => (each.type === 'tried' ? [each.tried] : [])) as [TriedEdit];
  const before = core.openRecipe(BODY);
  const singular = Object.values(before.info.singularVertices).reduce((sum, each) => sum + each, 0);
  before.dispose();
  if (typeof made === 'string') return expect.fail(made);
  expect(edited).toHaveLength(1);
  expect(edited[0]!.singularVertices).toBe(singular);
  expect(made.singularVertices).toBeGreaterThanOrEqual(8);
  expect(made.singularVertices).not.toBe(singular);
  for (const { distance } of [...edited, made]) {
    expect(distance).toBeGreaterThan(0);
    expect(distance).toBeLessThan(0.3);
  }

  const done = responses.flatMap((each) => (each.type === 'progress' ? [each] : []));
  expect(done[0]).toEqual({ type: 'progress', edit: 0, makes: false, done: 0 });
  expect(done.filter(({ makes }) => makes).length).toBeGreaterThan(5);
  for (const { done: part } of done) expect(part).toBeLessThanOrEqual(1);
  expect(done.at(-1)!.done).toBeGreaterThan(0.9);
});

test('what the core refuses is passed on', () => {
  const wrong = { ...request(), ways: [{ method: 'magic', initialisation: 'naive', options: {} }] };
  expect(responsesTo(wrong).at(-1)).toMatchObject({ type: 'error', code: 'bad_option' });
});

test('figure 3 is tried on three closed bodies', () => {
  const [figure, ...others] = FIGURES.filter(hasNewNet);
  expect(others).toEqual([]);
  expect(figure).toMatchObject({ figure: 3 });
  expect(figure!.edits).toHaveLength(3);
  for (const name of figure!.edits) {
    const { net } = EDITS[name]!;
    if (!('recipe' in net)) return expect.fail(name);
    const editor = core.openRecipe(net.recipe);
    expect(editor.info.boundaryLoops).toBe(0);
    editor.dispose();
  }
  expect(figure!.variants.filter(({ remeshes }) => remeshes).map((each) => settingsOf(each).method)).toEqual(['arap']);
});
