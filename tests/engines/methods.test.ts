/** Handles, methods, plots, comparisons and experiments, in each engine. */
import { beforeEach, expect, test, vi } from 'vitest';
import { largestDeviation } from '../browser/geometry';
import { load } from '../wasm/load';
import type { Visitor } from './visitor';
import { PATIENCE, visitors } from './visitor';

const SHAPE = 'vault:vertices=300';

const chebnet = await load();
const reference = chebnet.openRecipe(SHAPE);
const { edges, restPositions, suggestedHandles } = reference;
const { meanLength } = reference.info;
const dragged = suggestedHandles.at(-1)!;

const { arrive } = visitors();
let visitor: Visitor;
beforeEach(async () => {
  visitor = await arrive();
});

/** Colours of a canvas of the page, counted. */
const coloursOf = (selector: string) =>
  visitor.run((each) => {
    const canvas = document.querySelector<HTMLCanvasElement>(each);
    const data = canvas?.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
    return new Set(new Uint32Array(Uint8ClampedArray.from(data).buffer)).size;
  }, selector);

test('a solve is plotted', async () => {
  await visitor.openNet({ recipe: SHAPE });
  await visitor.drag(dragged, [-40, -30]);
  await vi.waitUntil(async () => (await coloursOf('.plot canvas')) > 10, PATIENCE);
});
