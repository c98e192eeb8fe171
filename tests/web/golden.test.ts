/**
 * What a page of any day made opens for ever: links, projects and what the browser kept, in tests/data/golden, each into the
 * document beside it. A folder holds what one version of the format wrote, `v1-b84a125` as the page of that commit did.
 *
 * Golden files are never changed. What is new (a version, a field, a shape, a method) is added to golden_scenes.ts, where it
 * is not found by itself, and, from the page as it is then,
 *
 *     cd web && CHEBNET_GOLDEN=make npx vitest run --project web golden numbering
 *
 * makes the files that are missing.
 */
import { describe, expect, test } from 'vitest';
import type { HandleData, Scene, Vec3 } from '../../web/src/document/document';
import { parseProject, readProject } from '../../web/src/document/project';
import type { Project } from '../../web/src/document/project';
import { VERSION } from '../../web/src/document/versions';
import { Host } from '../../web/src/embed/host';
import { edgeLengths } from '../../web/src/net/edge_lengths';
import { sceneOf } from '../../web/src/projects/link';
import { createScripting } from '../../web/src/scripting';
import { largestDistance, load } from '../wasm/load';
import { goldens, isMaking, keptRecord, projectWithText, readData, withText } from './golden_files';
import type { ExpectedLink } from './golden_files';
import { makeGoldens, missingGoldens } from './golden_make';
import { openPage } from './page_without_pictures';

/** The folder of what is written today. */
const TODAY = `v${VERSION}`;
/** Rest positions are computed: another compiler may round them otherwise. */
const ROUNDING = 1e-12;
/** Of a net at rest no dL is above the threshold of its solve. */
const THRESHOLD = 1e-6;
/** A net that is solved again comes so near to where it rested, in units of nets whose edges have a length of about 1. */
const AT_REST = 1e-3;

const core = await load();
if (isMaking) await makeGoldens(core, TODAY);

describe('a link opens', () => {
  test.each(goldens('link'))('$name', async ({ text, expected }) => {
    const { document, deviations } = expected as ExpectedLink;
    const scene = await sceneOf(text);
    const { app, solve } = await openPage(core);
    await app.openScene(scene);
    // What the drag comes through may change with the solver; where it comes to rest does not.
    if (scene.replay) await solve();
    const { document: opened, net, frame } = app.opening!;

    // The first version did not say how a net is numbered.
    expect(withoutPlaces(withText(opened))).toEqual({ numbering: opened.numbering, ...withoutPlaces(document) });
    const shortest = edgeLengths(net.restPositions, net.edges).reduce((least, length) => Math.min(least, length));
    const rounding = scene.replay ? AT_REST : ROUNDING;
    expect(largestDistance(frame.positions, document.positions)).toBeLessThanOrEqual(
      scene.positions === null ? rounding : 1e-4 * shortest,
    );
    for (const [i, { target }] of document.handles.entries()) {
      if (seedOf(scene, i) !== null && !scene.replay) expect(opened.handles[i]!.target).toEqual(target);
      else
        expect(
          largestDistance(Float64Array.from(opened.handles[i]!.target), Float64Array.from(target)),
        ).toBeLessThanOrEqual(rounding);
    }
    expect(frame.fields.deviation).toHaveLength(deviations.length);
    for (const [e, dl] of deviations.entries())
      expect(Math.abs(frame.fields.deviation[e]! - dl)).toBeLessThanOrEqual(
        1e-5 * dl + (scene.replay ? THRESHOLD : ROUNDING),
      );
  });
});

/** A document but for positions and targets. */
function withoutPlaces<T extends { positions: unknown; handles: HandleData[] }>({
  positions: _,
  handles,
  ...rest
}: T): object {
  return { ...rest, handles: handles.map((handle) => ({ ...handle, target: null })) };
}

/** The target that a scene gives a handle; null: where it rests. */
function seedOf({ handles }: Scene, i: number): Vec3 | null {
  return handles === 'suggested' ? null : handles[i]!.target;
}

describe('a project opens, to the last bit', () => {
  test.each(goldens('chebnet.json'))('$name', ({ text, expected }) => opens(parseProject(text), expected as Project));
});

describe('what a browser kept opens, to the last bit', () => {
  test.each(goldens('kept.json'))('$name', ({ text, expected }) =>
    opens(readProject(keptRecord(text)), expected as Project),
  );
});

/** With every state of its history. */
async function opens(project: Project, expected: Project): Promise<void> {
  expect(projectWithText(project)).toEqual(expected);
  const { app, said } = await openPage(core);
  await app.openProject(project);
  const { present, view, entries } = app.project()!;
  expect({ present, view, names: entries.map(({ name }) => name) }).toEqual({
    ...expected,
    entries: undefined,
    names: expected.entries.map(({ name }) => name),
  });
  for (const [i, { state }] of expected.entries.entries()) {
    app.goTo(i);
    await new Promise((resolve) => setImmediate(resolve));
    const { view: _, ...opened } = app.opening!.document;
    // The first version did not say how a net is numbered, nor early ones how a solve ended.
    expect(withText(opened)).toEqual({ numbering: opened.numbering, ending: opened.ending, ...state });
  }
  expect(said).toEqual([]);
}

test('the calls of a host page do what they did', async () => {
  const { calls, document } = readData('calls.json') as { calls: unknown[]; document: object };
  const page = await openPage(core);
  const answers: unknown[] = [];
  const host = new Host(createScripting(page.app, Promise.resolve()), (answer) => answers.push(answer));
  for (const call of calls) {
    await host.receive(call);
    await page.solve();
  }
  expect(answers).toEqual([1, 'two', 3, 4, 5, 6, 7].map((id) => ({ chebnet: 1, id, result: undefined })));
  const { positions: _, settled: __, numbering: ___, ...opened } = page.app.opening!.document;
  expect(withText(opened)).toEqual(document);
});

/** Each with so many variants. What it shows may change: a link gives its name, no more. */
test.each(Object.entries(readData('experiments.json') as Record<string, number>))(
  'the experiment %s has its links',
  async (name, variants) => {
    const { app } = await openPage(core);
    for (const end of ['', ...Array.from({ length: variants }, (_, i) => `&variant=${i + 1}`)]) {
      await app.openScene(await sceneOf(`#experiment=${name}${end}`));
      expect(app.opening!.document.experiment).toEqual(expect.any(String));
    }
  },
);

test('no file is missing of what is written today; the first lines here say how one is made', () => {
  expect(missingGoldens(core, TODAY)).toEqual([]);
});
