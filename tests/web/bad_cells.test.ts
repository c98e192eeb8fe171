/** Which cells are to blame. */
import { expect, test } from 'vitest';
import { badCells, crumpledCells, newFolds } from '../../web/src/overlay/bad_cells';
import { describe as describeNet } from '../../web/src/worker/opened_net';
import type { FrameData } from '../../web/src/worker/protocol';
import { load } from '../wasm/load';
import { grid } from './nets';

const core = await load();
const flat = grid(6, 5);
const net = describeNet(core.openMesh({ ...flat, positions: flat.restPositions }));
/** With one vertex moved. */
function frame(vertex: number, by: readonly number[], lengthScale = 1): FrameData {
  const positions = net.restPositions.map(
    (x, i) => lengthScale * (x + (Math.floor(i / 3) === vertex ? by[i % 3]! : 0)),
  );
  return { positions, lengthScale } as FrameData;
}
const around = (vertex: number) =>
  Array.from({ length: net.faceStart.length - 1 }, (_, face) => face).filter((face) =>
    net.faceVertices.subarray(net.faceStart[face], net.faceStart[face + 1]).includes(vertex),
  );

test('those around a vertex that was pulled out have edges that are off, whatever the lengths are scaled by', () => {
  for (const scale of [1, 1.5]) {
    const { off, sharp } = badCells(net, frame(14, [0, 0, 0.5], scale), 30);
    expect([...off].sort()).toEqual(around(14).sort());
    expect(sharp.size).toBe(0);
  }
});

test('a net as it should be has none', () => {
  const { off, sharp } = badCells(net, frame(14, [0, 0, 0]), 30);
  expect(off.size + sharp.size).toBe(0);
});

test('corners sharper than the limit are told, and those at it are not', () => {
  expect(badCells(net, frame(14, [0, 0, 0]), 90).sharp.size).toBe(0);
  expect(badCells(net, frame(14, [0, 0, 0]), 91).sharp.size).toBe(20);
});

test('cells beside an edge that is folded by more than 60° are crumpled, those bent by less are not', () => {
  expect(crumpledCells(net, frame(14, [0, 0, 0.4])).folded.size).toBe(0);
  const { folded } = crumpledCells(net, frame(14, [0, 0, 5]));
  expect(around(14).filter((face) => !folded.has(face))).toEqual([]);
});

test('edges fold anew where they fold by more than 60° beyond what they did: blocks do not as they come', () => {
  const [blocks, sheet] = ['jack:vertices=300', 'sheet:vertices=121'].map((recipe) => core.openRecipe(recipe));
  expect(newFolds(blocks!, blocks!.positions(), blocks!.positions())).toEqual([]);
  const flat = sheet!.positions();
  const folds = [0.5, 5].map((height) => {
    const raised = flat.map((x, i) => (i === 3 * 60 + 2 ? x + height * sheet!.info.edgeLength : x));
    return newFolds(sheet!, flat, raised).length;
  });
  // The four edges at the vertex; those around the cells there lie between an upright one and one that is flat.
  expect(folds).toEqual([0, 12]);
});
