/** Where a net was cut: sides of its border that lie at one place while the net is at rest. */
import type { VertexLists } from '../../../wasm/chebnet';
import type { Vec3 } from '../document/document';
import { pointOf } from '../document/point_of';
import { listsOf } from '../handles/lines';
import { squareBetween } from '../handles/surface_points';

/** The vertices along both sides, from the same end. */
export type Seam = readonly [readonly number[], readonly number[]];

/** At one place: nearer than this, in mean edge lengths. Cuts leave them within 1e-9. */
const NEAR = 1e-3;

interface Side {
  loop: number;
  at: number;
  from: number;
  to: number;
}

/** Every two sides that follow each other on both borders are of one seam.
 *  @param loops of the border, each closed. */
export function seamsOf(loops: VertexLists, restPositions: Float64Array, meanLength: number): Seam[] {
  const borders = listsOf(loops).map((loop, index) => sidesOf(loop, index));
  const partners = partnersOf(borders.flat(), restPositions, NEAR * meanLength);
  const done = new Set<Side>();
  const seams: Seam[] = [];
  for (const border of borders)
    for (const side of border) {
      const partner = partners.get(side);
      if (partner === undefined || done.has(side)) continue;
      const [first] = runFrom(side, -1, borders, partners).slice(-1);
      const run = runFrom(first!, 1, borders, partners);
      for (const each of run) done.add(each).add(partners.get(each)!);
      seams.push(seamOf(run, partners, restPositions));
    }
  return seams;
}

function sidesOf(loop: Int32Array, index: number): Side[] {
  return Array.from(loop, (from, at) => ({ loop: index, at, from, to: loop[(at + 1) % loop.length]! }));
}

/** Of each side the other one at its place, if there is just one. */
function partnersOf(sides: readonly Side[], positions: Float64Array, near: number): Map<Side, Side> {
  const buckets = new Map<string, Side[]>();
  for (const side of sides)
    for (const key of keysOf(middleOf(side, positions), near)) {
      const bucket = buckets.get(key);
      if (bucket) bucket.push(side);
      else buckets.set(key, [side]);
    }
  const partners = new Map<Side, Side>();
  for (const side of sides) {
    const middle = middleOf(side, positions);
    const found = new Set(keysOf(middle, near).flatMap((key) => buckets.get(key)!));
    const others = [...found].filter(
      (other) =>
        other !== side && squareBetween(middleOf(other, positions), middle) < near ** 2 && isAlong(side, other),
    );
    if (others.length === 1) partners.set(side, others[0]!);
  }
  return partners;

  function isAlong(a: Side, b: Side): boolean {
    const apart = (v: number, w: number) => squareBetween(pointOf(positions, v), pointOf(positions, w));
    return Math.min(apart(a.from, b.from), apart(a.from, b.to)) < near ** 2;
  }
}

/** The side and those that follow it, forwards or backwards, as long as their partners follow each other, too. */
function runFrom(first: Side, step: 1 | -1, borders: readonly Side[][], partners: Map<Side, Side>): Side[] {
  const run = new Set([first]);
  for (let side = first; ; ) {
    const border = borders[side.loop]!;
    const next = border[(side.at + step + border.length) % border.length]!;
    const [beside, beyond] = [partners.get(side)!, partners.get(next)];
    // At its end a slit turns round into its own other side.
    if (beyond === undefined || run.has(next) || run.has(beyond)) return [...run];
    const length = borders[beside.loop]!.length;
    const gone = (beyond.at - beside.at + length) % length;
    if (beyond.loop !== beside.loop || (gone !== 1 && gone !== length - 1)) return [...run];
    run.add(next);
    side = next;
  }
}

function seamOf(run: readonly Side[], partners: Map<Side, Side>, positions: Float64Array): Seam {
  const one = [run[0]!.from, ...run.map(({ to }) => to)];
  const others = run.map((side) => partners.get(side)!);
  const nearer = (v: number, { from, to }: Side): number =>
    squareBetween(pointOf(positions, from), pointOf(positions, v)) <
    squareBetween(pointOf(positions, to), pointOf(positions, v))
      ? from
      : to;
  return [one, [nearer(one[0]!, others[0]!), ...others.map((other, i) => nearer(one[i + 1]!, other))]];
}

function middleOf({ from, to }: Side, positions: Float64Array): Vec3 {
  const [a, b] = [pointOf(positions, from), pointOf(positions, to)];
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
}

/** The boxes of a grid within reach of a point: one, unless it lies near their borders. */
function keysOf(point: Vec3, near: number): string[] {
  const size = 100 * near;
  const along = (x: number) => [...new Set([Math.floor((x - near) / size), Math.floor((x + near) / size)])];
  return along(point[0]).flatMap((i) => along(point[1]).flatMap((j) => along(point[2]).map((k) => `${i} ${j} ${k}`)));
}
