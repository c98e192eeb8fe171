/** Editing on both sides of a plane at once: which vertex is the mirror image of which, and where it then goes. */
import type { Handle } from '../../../wasm/chebnet';
import type { HandleData, Symmetry, Vec3 } from '../document/document';
import { pointOf } from '../document/point_of';
import { PointGrid } from './point_grid';
import { AXES } from './transform';

/** A vertex may lie so far from the mirror image of its partner, in edge lengths. */
const REACH = 0.5;

/** Where the plane cuts its axis: `centre` is that of the net at rest. */
export function offsetOf({ axis, through }: Symmetry, restPositions: Float64Array): number {
  if (through === 'origin') return 0;
  let [low, high] = [Infinity, -Infinity];
  for (let i = AXES.indexOf(axis); i < restPositions.length; i += 3) {
    low = Math.min(low, restPositions[i]!);
    high = Math.max(high, restPositions[i]!);
  }
  return (low + high) / 2;
}

export class Mirror {
  readonly #axis: number;
  readonly #offset: number;
  readonly #known = new Map<number, number | null>();
  readonly #restPositions: Float64Array;
  readonly #atRest: PointGrid;

  constructor(symmetry: Symmetry, restPositions: Float64Array, edgeLength: number) {
    this.#restPositions = restPositions;
    this.#atRest = new PointGrid(restPositions, REACH * edgeLength);
    this.#axis = AXES.indexOf(symmetry.axis);
    this.#offset = offsetOf(symmetry, restPositions);
  }

  /** The vertex that rests at the mirror image of this one, itself if it rests on the plane; null: there is none. */
  partner(vertex: number): number | null {
    const nearest = this.#nearest(vertex);
    return nearest !== null && this.#nearest(nearest) === vertex ? nearest : null;
  }

  /** These vertices and their partners. */
  both(vertices: readonly number[]): number[] {
    return [...new Set([...vertices, ...vertices.flatMap((vertex) => this.partner(vertex) ?? [])])];
  }

  /** Targets for both sides. Of two partners that are both moved, the one on the side of the first target leads; what rests
   *  on the plane stays beside it. Partners that are locked, or no handles, stay out of it. */
  mirrored(targets: readonly Handle[], handles: readonly HandleData[]): Handle[] {
    const mayMove = new Set(handles.filter(({ anchor }) => !anchor).map(({ vertex }) => vertex));
    const moved = new Set(targets.map(({ vertex }) => vertex));
    const [first] = targets;
    const side = first === undefined || this.#height(first.vertex) >= 0 ? 1 : -1;
    const leads = ({ vertex }: Handle): boolean => {
      const partner = this.partner(vertex);
      return partner === null || partner === vertex || !moved.has(partner) || side * this.#height(vertex) > 0;
    };
    return targets.filter(leads).flatMap(({ vertex, target }) => {
      const partner = this.partner(vertex);
      if (partner === vertex) return [{ vertex, target: this.#besidePlane(vertex, target) }];
      const image =
        partner !== null && mayMove.has(partner)
          ? [{ vertex: partner, target: this.#imageFor(vertex, target, partner) }]
          : [];
      return [{ vertex, target }, ...image];
    });
  }

  /** The vertex nearest to the mirror image of this one, at rest. */
  #nearest(vertex: number): number | null {
    const known = this.#known.get(vertex);
    if (known !== undefined) return known;
    const nearest = this.#atRest.nearest(this.#image(this.#rest(vertex)));
    this.#known.set(vertex, nearest);
    return nearest;
  }

  /** The mirror image of a target, and by as much beside it as the partner rests beside the image of the vertex. */
  #imageFor(vertex: number, target: Vec3, partner: number): Vec3 {
    const [image, restImage, rest] = [this.#image(target), this.#image(this.#rest(vertex)), this.#rest(partner)];
    return image.map((x, axis) => x + rest[axis]! - restImage[axis]!) as Vec3;
  }

  #besidePlane(vertex: number, target: Vec3): Vec3 {
    const beside: Vec3 = [...target];
    beside[this.#axis] = this.#rest(vertex)[this.#axis]!;
    return beside;
  }

  #image(point: Vec3): Vec3 {
    const image: Vec3 = [...point];
    image[this.#axis] = 2 * this.#offset - point[this.#axis]!;
    return image;
  }

  #height(vertex: number): number {
    return this.#rest(vertex)[this.#axis]! - this.#offset;
  }

  #rest(vertex: number): Vec3 {
    return pointOf(this.#restPositions, vertex);
  }
}
