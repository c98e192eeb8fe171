/** Where handles may be moved together. Each stays in balls around the other handles, whose radii are the distances along
 *  the net; all follow one translation, so the balls are limits of that translation. */
import type { Axes, Ball, Handle } from '../../../wasm/chebnet';
import type { Vec3 } from '../document/document';
import { AXES } from './transform';

/** The points whose distance from `centre` is at most `radius`: a ball, or where not all axes count, a cylinder or the space
 *  between two planes. */
export interface Limit {
  centre: Vec3;
  radius: number;
  /** 1 for an axis that counts, or 0. */
  counts: Vec3;
}

/** A dragged handle. The translation t takes it to `base` + `follows`·t, axis by axis. */
export interface InHand {
  vertex: number;
  base: Vec3;
  /** 1, or its share if it follows others; across a plane of symmetry negative for the mirror image, 0 for what lies on the plane; 0 also along axes on which it slides
   *  or to which the translation is not kept. */
  follows: Vec3;
  /** It follows those in hand by a share, as far as the net lets it: it does not hold them back. */
  isLed?: boolean;
}

const MOST_ROUNDS = 1000;
/** Iterations end when one moves the point by less than this fraction of a radius. */
const TOLERANCE = 1e-9;
/** What lies beyond a border by no more than this fraction of the radius is on it. */
const TOUCHES = 1e-9;
/** Distance from a border that counts as near, as a fraction of the radius. */
const NEAR = 0.05;
/** Most limits used: those nearest to the handles. */
const MOST_LIMITS = 1000;
/** Relative distance from a common translation beyond which a motion counts as a rotation or scaling. */
const TURNED = 1e-6;

/** The limits of a translation of these handles. `reaches`: the balls of each. */
export function limitsOf(inHand: readonly InHand[], reaches: readonly (readonly Ball[])[]): Limit[] {
  const others = new Map(inHand.map((each) => [each.vertex, each]));
  const limits = inHand.flatMap(({ base, follows }, i) =>
    (reaches[i] ?? []).flatMap(({ vertex, centre, radius }) => {
      const other = others.get(vertex) ?? { base: centre, follows: [0, 0, 0] as const };
      return limitOf(plus(base, other.base, -1), plus(follows, other.follows, -1), radius) ?? [];
    }),
  );
  return withoutNeedless(limits);
}

/** The translations t with |apart + moves·t| ≤ radius. Those of `moves` that are not 0 differ in sign only. null: it does not
 *  depend on t. */
function limitOf(apart: Vec3, moves: Vec3, radius: number): Limit | null {
  const rate = Math.max(...moves.map(Math.abs));
  const constant = Math.hypot(...apart.map((x, axis) => (moves[axis] === 0 ? x : 0)));
  if (rate === 0 || constant > (1 + TOUCHES) * radius) return null;
  return {
    centre: apart.map((x, axis) => (moves[axis] === 0 ? 0 : -x / moves[axis]!)) as Vec3,
    // One that it touches from the beginning stays a limit.
    radius: (radius * Math.sqrt(Math.max(1 - (constant / radius) ** 2, TOUCHES))) / rate,
    counts: moves.map((move) => (move === 0 ? 0 : 1)) as Vec3,
  };
}

/** The smallest first. A limit that contains a smaller one is redundant. */
function withoutNeedless(limits: readonly Limit[]): Limit[] {
  const needed: Limit[] = [];
  for (const limit of nearest(limits).sort((a, b) => a.radius - b.radius)) {
    const holds = ({ centre, radius, counts }: Limit): boolean =>
      limit.counts.every((each, axis) => each <= counts[axis]!) && distance(limit, centre) + radius <= limit.radius;
    if (!needed.some(holds)) needed.push(limit);
  }
  return needed;
}

function nearest(limits: readonly Limit[]): Limit[] {
  const slack = (limit: Limit): number => limit.radius - distance(limit, [0, 0, 0]);
  return limits.length > MOST_LIMITS
    ? [...limits].sort((a, b) => slack(a) - slack(b)).slice(0, MOST_LIMITS)
    : [...limits];
}

/** The point nearest to `asked` within all limits. Here rather than in the core: a pointer event cannot wait for the worker.
 *  Few of many limits are active: violated ones are added one after another, the worst first. */
export function nearestInAll(limits: readonly Limit[], asked: Vec3): Vec3 {
  const active: Limit[] = [];
  let point = asked;
  for (;;) {
    const worst = worstOf(limits, point);
    if (worst === null || active.includes(worst)) return point;
    active.push(worst);
    point = project(active, asked);
  }
}

function worstOf(limits: readonly Limit[], point: Vec3): Limit | null {
  let worst: Limit | null = null;
  let most = TOLERANCE;
  for (const limit of limits) {
    const excess = distance(limit, point) / limit.radius - 1;
    if (excess > most) [worst, most] = [limit, excess];
  }
  return worst;
}

/** By Dykstra's algorithm of alternating projections (Boyle & Dykstra 1986). Where the limits have hardly a point in common or
 *  none at all, it comes as close as many rounds bring it. */
function project(limits: readonly Limit[], asked: Vec3): Vec3 {
  let point = asked;
  const corrections = limits.map((): Vec3 => [0, 0, 0]);
  for (let round = 0; round < MOST_ROUNDS; round++) {
    let moved = 0;
    limits.forEach((limit, i) => {
      const corrected = plus(point, corrections[i]!, 1);
      const next = nearestIn(limit, corrected);
      corrections[i] = plus(corrected, next, -1);
      moved = Math.max(moved, Math.hypot(...plus(next, point, -1)) / limit.radius);
      point = next;
    });
    if (moved < TOLERANCE) break;
  }
  return point;
}

export function isNearBorder(limits: readonly Limit[], point: Vec3): boolean {
  return limits.some((limit) => distance(limit, point) > (1 - NEAR) * limit.radius);
}

/** The translation that takes handles there; null: they are turned or scaled. What was in hand and has no target has gone. */
export function translationTo(targets: readonly Handle[], inHand: readonly InHand[]): Vec3 | null {
  const asked = new Map(targets.map(({ vertex, target }) => [vertex, target]));
  const held = inHand.filter(({ vertex }) => asked.has(vertex));
  const translation = [0, 1, 2].map((axis) => {
    const leading = held.find(({ follows }) => follows[axis] !== 0);
    return leading ? (asked.get(leading.vertex)![axis]! - leading.base[axis]!) / leading.follows[axis]! : 0;
  }) as Vec3;
  const isThere = (each: InHand): boolean => {
    const off = plus(asked.get(each.vertex)!, translated(each, translation), -1).map((x, axis) =>
      each.follows[axis] === 0 ? 0 : x,
    );
    return Math.hypot(...off) <= TURNED * (Math.hypot(...translation) + TURNED * Math.hypot(...each.base));
  };
  return held.every(isThere) ? translation : null;
}

/** Such a handle where only these coordinates of the translation count. */
export function keptTo(axes: Axes, { follows, ...handle }: InHand): InHand {
  return { ...handle, follows: follows.map((each, axis) => (axes.includes(AXES[axis]!) ? each : 0)) as Vec3 };
}

export function translated({ base, follows }: InHand, translation: Vec3): Vec3 {
  return base.map((x, axis) => x + follows[axis]! * translation[axis]!) as Vec3;
}

/** From the centre of a limit, as it counts. */
function distance({ centre, counts }: Limit, [x, y, z]: Vec3): number {
  return Math.hypot(counts[0] * (x - centre[0]), counts[1] * (y - centre[1]), counts[2] * (z - centre[2]));
}

function nearestIn(limit: Limit, point: Vec3): Vec3 {
  const { centre, radius, counts } = limit;
  const away = distance(limit, point);
  if (away <= radius) return point;
  return point.map((x, axis) =>
    counts[axis] === 0 ? x : centre[axis]! + (radius / away) * (x - centre[axis]!),
  ) as Vec3;
}

function plus(a: Vec3, b: Readonly<Vec3>, times: number): Vec3 {
  return [a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]];
}
