/** Documents in every form they can have, and what happens to them on the way. */
import fc from 'fast-check';
import { axesToSlide } from '../../../web/src/document/document';
import type {
  ChebnetDocument,
  DocumentNet,
  GuideFile,
  HandleData,
  NetSource,
  Vec3,
  ViewState,
} from '../../../web/src/document/document';
import { areEnds, FIELD_NAMES, type FieldName, fieldOf } from '../../../web/src/fields/fields';
import { grid } from '../../web/nets';

export const net = grid(4, 3);
const VERTICES = net.restPositions.length / 3;

/** JSON knows no −0. */
const number = fc.double({ noNaN: true, noDefaultInfinity: true }).map((x) => x + 0);
const positive = number.filter((x) => x > 0);
const point: fc.Arbitrary<Vec3> = fc.tuple(number, number, number);
/** Names that objects have of their own among them. */
const text = fc.oneof(fc.string({ unit: 'binary' }), fc.constantFrom('__proto__', 'constructor', 'toString', ''));

/** A record some of whose fields are missing, as those who write documents leave them. */
const partial = <T extends object>(fields: { [Name in keyof T]: fc.Arbitrary<T[Name]> }) =>
  fc.record(fields, { requiredKeys: [] }) as fc.Arbitrary<Partial<T>>;

const handle: fc.Arbitrary<HandleData> = fc
  .tuple(
    fc.record({ vertex: fc.nat(VERTICES - 1), target: point, anchor: fc.boolean() }),
    partial({
      name: fc.string({ maxLength: 20 }),
      hidden: fc.boolean(),
      weight: positive,
      slides: fc.constantFrom(...axesToSlide()),
    }),
  )
  .map(([needed, more]) => ({ ...needed, ...more }));

/** What is told of a file beside the net in it. */
const traits = fc
  .tuple(
    fc.record({ name: text }),
    partial({ restLengths: fc.constantFrom('automatic' as const, 'equal' as const, 'own' as const) }),
  )
  .map(([needed, more]) => ({ ...needed, ...more }));

/** Faces of any vertices. */
export const mesh = fc
  .tuple(fc.array(point, { maxLength: 5 }), fc.array(fc.array(fc.nat(99), { minLength: 1, maxLength: 5 })))
  .map(([points, faces]) => {
    let end = 0;
    return {
      positions: Float64Array.from(points.flat()),
      faceStart: Int32Array.of(0, ...faces.map((face) => (end += face.length))),
      faceVertices: Int32Array.from(faces.flat()),
    };
  });

const documentNet: fc.Arbitrary<DocumentNet> = fc.oneof(
  fc.record({ recipe: text }),
  fc.tuple(mesh, traits).map(([given, more]) => ({ mesh: given, ...more })),
);

/** Also as text, as in a project that was opened. */
export const source: fc.Arbitrary<NetSource> = fc.oneof(
  documentNet,
  fc.tuple(text, traits).map(([obj, more]) => ({ obj, ...more })),
);

/** A surface that somebody brought: projects have it, links do not. */
export const guideFile: fc.Arbitrary<GuideFile> = fc.record({ name: text, mesh });

/** Written with seven digits. */
const camera = fc
  .array(fc.integer({ min: -999_999, max: 999_999 }), { minLength: 6, maxLength: 6 })
  .filter(([x, y, z, u, v, w]) => x !== u || y !== v || z !== w)
  .map(([x = 0, y = 0, z = 0, u = 0, v = 0, w = 0]) => ({ position: [x, y, z] as Vec3, target: [u, v, w] as Vec3 }));

const ends = (name: FieldName) => fc.tuple(number, number).filter((pair) => areEnds(fieldOf(name), pair));
/** Of any of the fields that have some to be set. */
const allEnds: fc.Arbitrary<NonNullable<ViewState['ends']>> = fc.record(
  Object.fromEntries(FIELD_NAMES.filter((name) => fieldOf(name).ends).map((name) => [name, ends(name)])),
  { requiredKeys: [] },
);

export const view: fc.Arbitrary<ViewState> = fc
  .tuple(
    fc.record({
      camera: fc.option(camera),
      field: fc.constantFrom(...FIELD_NAMES),
      colourMap: fc.constantFrom('paper' as const, 'log' as const),
      showFaces: fc.boolean(),
    }),
    partial({
      ends: allEnds,
      guideHidden: fc.boolean(),
      upAxis: fc.constantFrom('y' as const, 'z' as const),
      parallel: fc.boolean(),
      rods: fc.constantFrom(0.02, 0.4),
      section: fc.record({
        axis: fc.constantFrom('x' as const, 'y' as const, 'z' as const),
        at: fc.constantFrom(0, 0.5, 1),
      }),
    }),
  )
  .map(([needed, more]) => ({ ...needed, ...more }));

/** At rest, or not far from there. */
const positions = fc.oneof(
  fc.constant(null),
  fc.constant(net.restPositions),
  fc
    .array(fc.double({ min: -5, max: 5, noNaN: true }), { minLength: 3 * VERTICES, maxLength: 3 * VERTICES })
    .map((moves) => net.restPositions.map((x, i) => x + (moves[i] ?? 0))),
);

export const document: fc.Arbitrary<ChebnetDocument> = fc
  .tuple(
    fc.record({
      net: documentNet,
      handles: fc.array(handle, { maxLength: 5 }),
      method: text,
      initialisation: text,
      options: fc.dictionary(text, fc.oneof(number, fc.boolean())),
      view,
      positions,
      settled: fc.boolean(),
    }),
    partial({
      numbering: fc.nat(2 ** 32 - 1),
      symmetry: fc.record({
        axis: fc.constantFrom('x' as const, 'y' as const, 'z' as const),
        through: fc.constantFrom('centre' as const, 'origin' as const),
      }),
      locality: positive,
      influence: positive,
      guide: fc.record({ own: text }),
      experiment: text,
      compare: fc.array(text, { maxLength: 3 }),
    }),
  )
  .map(([needed, more]) => ({ ...needed, ...more }));

// -------------------------------------------------------------------------------------------------------------- damage

/** A place in a tree of JSON, by turns, and what is put there instead; nothing: it is taken away. */
interface Change {
  turns: number[];
  value: unknown;
}

const hostile = fc.oneof(
  fc.jsonValue(),
  fc.constantFrom(1e308, -1, 0.5, 2 ** 53, '', null, [], {}, [[[[]]]], undefined),
);

export const changes: fc.Arbitrary<Change[]> = fc.array(
  fc.record({ turns: fc.array(fc.nat(30), { minLength: 1, maxLength: 6 }), value: hostile }),
  { minLength: 1, maxLength: 4 },
);

/** A copy of plain data with the changes made. */
export function changed(data: unknown, list: readonly Change[]): unknown {
  const copy: unknown = JSON.parse(JSON.stringify(data));
  for (const { turns, value } of list) change(copy, turns, value);
  return copy;
}

function change(tree: unknown, turns: readonly number[], value: unknown): void {
  if (typeof tree !== 'object' || tree === null || Object.keys(tree).length === 0) return;
  const record = tree as Record<string, unknown>;
  const keys = Object.keys(record);
  const key = keys[(turns[0] ?? 0) % keys.length] ?? '';
  const below = record[key];
  if (turns.length > 1 && typeof below === 'object' && below !== null && Object.keys(below).length > 0) {
    change(below, turns.slice(1), value);
  } else if (value === undefined) {
    delete record[key];
  } else {
    // A copy, since a later change may go into it.
    Object.defineProperty(record, key, {
      value: structuredClone(value),
      enumerable: true,
      writable: true,
      configurable: true,
    });
  }
}

/** Throws if there is a number anywhere in plain data that is not finite. */
export function checkFinite(value: unknown): void {
  if (typeof value === 'number' && !Number.isFinite(value)) throw new Error(`a number is ${value}`);
  if (typeof value === 'object' && value !== null) Object.values(value).forEach(checkFinite);
}
