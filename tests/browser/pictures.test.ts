/** Ten nets somebody would hang on a wall, each exact: the second picture of the README. */
import { beforeAll, expect, test } from 'vitest';
import type { RemeshOptions } from '../../wasm/chebnet';
import type { ScriptDrape } from '../../web/src/surface_script';
import { NETS_PICTURE, type Visit, visits } from './page';

type Point = [number, number, number];
interface Mesh {
  vertices: Point[];
  faces: number[][];
}

/** What is left of the page beside title, tools and panels. */
const FREE = { x: 60, y: 60, width: 860, height: 710 };
const [COLUMNS, WIDTH, HEIGHT] = [5, 344, 284];
const TURN = 2 * Math.PI;

/** A surface over the unit square, whose sides may be joined. */
function patch(m: number, n: number, [joinU, joinV]: [boolean, boolean], at: (u: number, v: number) => Point): Mesh {
  const [rows, columns] = [joinU ? m : m + 1, joinV ? n : n + 1];
  const vertices = Array.from({ length: rows * columns }, (_, k) => at(Math.floor(k / columns) / m, (k % columns) / n));
  const vertex = (i: number, j: number): number => (i % rows) * columns + (j % columns);
  const faces = Array.from({ length: m * n }, (_, k) => {
    const [i, j] = [Math.floor(k / n), k % n];
    return [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
  });
  return { vertices, faces };
}

function ring(radius: number, angle: number, height: number): Point {
  return [radius * Math.cos(angle), radius * Math.sin(angle), height];
}

const torus = patch(96, 40, [true, true], (u, v) =>
  ring(3 + 1.2 * Math.cos(TURN * v), TURN * u, 1.2 * Math.sin(TURN * v)),
);

const catenoid = patch(96, 40, [true, false], (u, v) => ring(Math.cosh(2.4 * v - 1.2), TURN * u, 2.4 * v - 1.2));

const monkeySaddle = patch(60, 60, [false, false], (u, v) => {
  const [x, y] = [2 * u - 1, 2 * v - 1];
  return [x, y, 0.35 * (x ** 3 - 3 * x * y ** 2)];
});

const sum = (a: Point, b: Point, factor = 1): Point => a.map((x, i) => x + factor * b[i]!) as Point;
const dot = (a: Point, b: Point): number => a.reduce((all, x, i) => all + x * b[i]!, 0);
const unit = (a: Point): Point => a.map((x) => x / Math.sqrt(dot(a, a))) as Point;
const cross = (a: Point, b: Point): Point =>
  [0, 1, 2].map((i) => a[(i + 1) % 3]! * b[(i + 2) % 3]! - a[(i + 2) % 3]! * b[(i + 1) % 3]!) as Point;

/** A tube along a trefoil. */
const knot = patch(180, 24, [true, true], (u, v) => {
  const curve = (t: number): Point => [
    Math.sin(t) + 2 * Math.sin(2 * t),
    Math.cos(t) - 2 * Math.cos(2 * t),
    -Math.sin(3 * t),
  ];
  const [before, at, after] = [curve(TURN * u - 1e-3), curve(TURN * u), curve(TURN * u + 1e-3)];
  const along = unit(sum(after, before, -1));
  const bent = sum(sum(after, before), at, -2);
  const normal = unit(sum(bent, along, -dot(bent, along)));
  return sum(sum(at, normal, 0.42 * Math.cos(TURN * v)), cross(along, normal), 0.42 * Math.sin(TURN * v));
});

/** Round twice, rising. */
const ramp = patch(240, 24, [false, false], (u, v) => ring(1 + 1.1 * v, 2 * TURN * u, 2.6 * u));

type Laid = { drape: ScriptDrape } | { remesh: RemeshOptions };
/** One from the gallery, or on a surface. */
type Picture = { recipe: string } | ({ surface: Mesh | { own: string } } & Laid);

const NETS: readonly Picture[] = [
  { recipe: 'canopy:vertices=1500' },
  { recipe: 'vase' },
  { surface: knot, remesh: { cells: 2600 } },
  { surface: { own: 'shell' }, drape: { cells: 1400, border: 'cut' } },
  { surface: catenoid, remesh: { cells: 1400 } },
  { surface: ramp, drape: { cells: 1600, border: 'cut' } },
  { surface: torus, remesh: { cells: 1600 } },
  { surface: { own: 'torso' }, remesh: { cells: 1500 } },
  { surface: { own: 'hemisphere' }, drape: { border: 'cut' } },
  { surface: monkeySaddle, remesh: { cells: 1300 } },
];

const site = visits();
let visit: Visit;
beforeAll(async () => {
  if (process.env['CHEBNET_SCREENSHOT']) visit = await site.arrive();
});

test.runIf(process.env['CHEBNET_SCREENSHOT'])('ten nets', async () => {
  const { page, script } = visit;
  const pictures: Buffer[] = [];
  for (const net of NETS) {
    if ('recipe' in net) await script.open(net);
    else
      expect(
        await page.evaluate(async (made) => {
          if ('remesh' in made) return (await window.chebnet.remesh(made.surface, made.remesh)).singularVertices;
          await window.chebnet.drape(made.surface, made.drape);
          return [];
        }, net),
      ).toEqual([]);
    await script.settled();
    const { maxDeviation } = await script.stats();
    expect(maxDeviation).toBeLessThan(1e-9);
    await page.waitForTimeout(500);
    await page.evaluate(hideAllButTheNet);
    pictures.push(await page.screenshot({ clip: FREE }));
  }
  const size = { width: COLUMNS * WIDTH, height: (NETS.length / COLUMNS) * HEIGHT };
  const sheet = await page.context().browser()!.newPage({ viewport: size });
  const images = pictures.map(
    (picture) => `<img width=${WIDTH} height=${HEIGHT} src="data:image/png;base64,${picture.toString('base64')}">`,
  );
  await sheet.setContent(`<body style="margin: 0; line-height: 0">${images.join('')}`);
  await sheet.screenshot({ path: NETS_PICTURE, quality: 88 });
});

function hideAllButTheNet(): void {
  const canvas = document.querySelector('canvas')!;
  for (const element of document.querySelectorAll<HTMLElement | SVGElement>('body *'))
    if (!element.contains(canvas)) element.style.visibility = 'hidden';
}
