/** A stroke of the pen over the picture, and where it runs on the net that is seen there. */
import type { DrawnPoint } from '../handles/way';
import type { NetData } from './net_data';
import type { Place } from './overlay';
import { type Plane, type Projection, project, type ScreenPoint } from './picking';

/** Pixels between places that are looked for on the net. */
const STEP = 4;
/** How often a step that crosses the border is halved to find where. */
const HALVINGS = 6;

/** The net that is drawn on. */
export interface Sheet {
  data: Pick<NetData, 'points' | 'vertexCount' | 'space'>;
  /** Three vertices each. */
  triangles: Uint32Array;
  projection: Projection;
  /** What is beyond is not seen. */
  section: Plane;
}

export class Stroke {
  /** On the net, from border to border where it leaves the net in between. */
  readonly pieces: DrawnPoint[][] = [];
  readonly places: Place[] = [];
  readonly #sheet: Sheet;
  /** Of each vertex; null: not to be seen. */
  readonly #seen: readonly (ScreenPoint | null)[];
  #isOnNet = false;

  constructor(sheet: Sheet, start: Place) {
    this.#sheet = sheet;
    this.#seen = Array.from({ length: sheet.data.vertexCount }, (_, vertex) => placeOf(sheet, vertex));
    this.#visit(start, start);
    this.places.push(start);
  }

  extend(to: Place): void {
    const from = this.places.at(-1)!;
    const steps = Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / STEP);
    for (let k = 1; k <= steps; k++) this.#visit(between(from, to, (k - 1) / steps), between(from, to, k / steps));
    this.places.push(to);
  }

  #visit(before: Place, at: Place): void {
    const found = this.#find(at);
    const isEntering = found !== null && !this.#isOnNet;
    if (isEntering) this.pieces.push([]);
    if (isEntering || (found === null && this.#isOnNet)) this.#addBorder(isEntering ? [at, before] : [before, at]);
    if (found !== null) this.pieces.at(-1)!.push(found);
    this.#isOnNet = found !== null;
  }

  /** So that a line over the border ends at a vertex of the border, however fine the net is. */
  #addBorder([inside, outside]: [Place, Place]): void {
    for (let k = 0; k < HALVINGS; k++) {
      const middle = between(inside, outside, 0.5);
      if (this.#find(middle) === null) outside = middle;
      else inside = middle;
    }
    this.pieces.at(-1)!.push(this.#find(inside)!);
  }

  /** On the frontmost of the triangles there. */
  #find(at: Place): DrawnPoint | null {
    const { triangles } = this.#sheet;
    let [front, nearest]: [number, DrawnPoint | null] = [Infinity, null];
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [this.#seen[triangles[t]!], this.#seen[triangles[t + 1]!], this.#seen[triangles[t + 2]!]];
      const shares = a && b && c && sharesAt(at, a, b, c);
      if (!shares) continue;
      const depth = shares[0] * a.depth + shares[1] * b.depth + shares[2] * c.depth;
      if (depth >= front) continue;
      front = depth;
      nearest = this.#pointOn([...triangles.subarray(t, t + 3)], shares);
    }
    return nearest;
  }

  #pointOn(corners: readonly number[], shares: readonly number[]): DrawnPoint {
    const { points, space } = this.#sheet.data;
    const place = (axis: number) => corners.reduce((sum, v, k) => sum + shares[k]! * points[4 * v + axis]!, 0);
    const [x, y, z] = [place(0), place(1), place(2)];
    const far = corners.map((v) => Math.hypot(points[4 * v]! - x, points[4 * v + 1]! - y, points[4 * v + 2]! - z));
    return { at: space.toNet({ x, y, z }), vertex: corners[far.indexOf(Math.min(...far))]! };
  }
}

function placeOf({ data: { points }, projection, section }: Sheet, vertex: number): ScreenPoint | null {
  const [x, y, z, hidden] = points.subarray(4 * vertex, 4 * vertex + 4) as unknown as [number, number, number, number];
  const place = project(projection, x, y, z);
  const isSeen = hidden === 0 && place.depth > 0 && section.x * x + section.y * y + section.z * z <= section.w;
  return isSeen ? place : null;
}

/** How much of each corner is in a place; null: it lies beside the triangle. */
function sharesAt({ x, y }: Place, a: Place, b: Place, c: Place): [number, number, number] | null {
  if (x < Math.min(a.x, b.x, c.x) || x > Math.max(a.x, b.x, c.x)) return null;
  const twice = (p: Place, q: Place, rx: number, ry: number) => (q.x - p.x) * (ry - p.y) - (q.y - p.y) * (rx - p.x);
  const all = twice(a, b, c.x, c.y);
  const [u, v] = [twice(b, c, x, y) / all, twice(c, a, x, y) / all];
  const w = 1 - u - v;
  return u >= 0 && v >= 0 && w >= 0 ? [u, v, w] : null;
}

function between(a: Place, b: Place, part: number): Place {
  return { x: a.x + part * (b.x - a.x), y: a.y + part * (b.y - a.y) };
}
