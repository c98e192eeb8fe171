/** A Vite plugin for the pictures of the gallery. They are made while building, by the core itself: each visit is spared the
 *  solves of a dozen nets, in the very seconds in which its own net is taken hold of. */
import { readFileSync } from 'node:fs';
import type { Plugin } from 'vite';
import { edgeLayers, LAYERS, project } from './src/elements/thumbnail.ts';
import type { Wireframe } from './src/elements/thumbnail.ts';
import { formatRecipe, parseRecipe } from './src/sidebar/recipe.ts';
import type { Chebnet, ShapeInfo } from '../wasm/chebnet';

const MODULE = 'virtual:gallery_pictures';
const FACADE = new URL('../wasm/chebnet.js', import.meta.url);
const BINARY = new URL('../build/wasm/chebnet_core.wasm', import.meta.url);

/** Size of the nets. */
const VERTICES = 300;
/** In which they are fitted, about that of a tile. */
const [WIDTH, HEIGHT] = [72, 54] as const;
/** Steps of the drawing's coordinates in a pixel of that. */
const STEPS = 3;

/** `virtual:gallery_pictures`: drawings of the shapes, see src/virtual.d.ts. */
export function galleryPictures(): Plugin {
  return {
    name: 'gallery-pictures',
    resolveId: (id) => (id === MODULE ? `\0${MODULE}` : null),
    load: async (id) => (id === `\0${MODULE}` ? drawAll(await loadCore()) : null),
  };
}

async function loadCore(): Promise<Chebnet> {
  // By its address: as part of this configuration it would be needed wherever that is read.
  const { loadChebnet } = (await import(FACADE.href)) as typeof import('../wasm/chebnet');
  return loadChebnet({ wasmBinary: readFileSync(BINARY) });
}

function drawAll(core: Chebnet): string {
  const pictures = Object.fromEntries(core.shapes().map((shape) => [shape.name, draw(smallNet(core, shape))]));
  return [
    `export const PICTURES = ${JSON.stringify(pictures)};`,
    `export const VIEW_BOX = '0 0 ${WIDTH * STEPS} ${HEIGHT * STEPS}';`,
  ].join('\n');
}

function smallNet(core: Chebnet, shape: ShapeInfo): Wireframe {
  const recipe = parseRecipe(shape.offered);
  recipe.values['vertices'] = VERTICES;
  const editor = core.openRecipe(formatRecipe(recipe, shape));
  const { edges, restPositions } = editor;
  editor.dispose();
  return { edges, positions: Float32Array.from(restPositions) };
}

/** The path of each layer. */
function draw(net: Wireframe): string[] {
  const places = Array.from(project(net, WIDTH, HEIGHT), (coordinate) => Math.round(coordinate * STEPS));
  const layers = edgeLayers(net);
  return LAYERS.map((_, layer) => {
    const edges = [...layers.keys()].filter((edge) => layers[edge] === layer);
    const ends = edges.map((edge) => [net.edges[2 * edge]!, net.edges[2 * edge + 1]!] as const);
    return trails(ends)
      .map((trail) => pathThrough(trail.map((vertex) => [places[2 * vertex]!, places[2 * vertex + 1]!] as const)))
      .join('');
  });
}

/** Lines along edges, each of which is drawn once; a few long ones are less to load than many short ones. */
function trails(edges: (readonly [number, number])[]): number[][] {
  const neighbours = new Map<number, Set<number>>();
  const join = (a: number, b: number) => neighbours.set(a, (neighbours.get(a) ?? new Set()).add(b));
  for (const [a, b] of edges) {
    join(a, b);
    join(b, a);
  }
  // Where an odd number of edges meet, a line has to end.
  const odd = (vertex: number) => neighbours.get(vertex)!.size % 2;
  const starts = [...neighbours.keys()].sort((a, b) => odd(b) - odd(a));
  return starts.flatMap((start) => {
    const lines: number[][] = [];
    while (neighbours.get(start)!.size > 0) lines.push(walk(start, neighbours));
    return lines;
  });
}

/** As far as there is an edge, each of which it takes away. */
function walk(start: number, neighbours: Map<number, Set<number>>): number[] {
  const line = [start];
  for (let at = start; ; ) {
    const [next] = neighbours.get(at)!;
    if (next === undefined) return line;
    neighbours.get(at)!.delete(next);
    neighbours.get(next)!.delete(at);
    line.push(next);
    at = next;
  }
}

/** In steps from point to point, as SVG has them, without the spaces that a sign replaces. */
function pathThrough(points: (readonly [number, number])[]): string {
  const [[x, y] = [0, 0], ...rest] = points;
  let before = [x, y] as const;
  const steps = rest.flatMap((point) => {
    const step = [point[0] - before[0], point[1] - before[1]];
    before = point;
    return step;
  });
  return `M${x} ${y}l${steps.join(' ').replaceAll(' -', '-')}`;
}
