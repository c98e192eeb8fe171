/** The net to be changed, and the scene with what became of it. */
import type { FormatInfo } from '../../../wasm/chebnet';
import { type ChangeName, textOf } from '../document/naming';
import { remade, usualMethod } from '../document/defaults';
import { guideTitle } from '../document/changes';
import type { ChebnetDocument, GuideSource, Scene } from '../document/document';
import { fileNameOf } from '../files/file_name';
import type { Selection } from '../handles/selection';
import type { Opening } from '../worker/opening';
import type { DrawnSurface } from '../worker/protocol';
import type { ChangedNet, ChangeRequest, Way } from './change_protocol';
import { type Place, placeOf } from './place';
import { centreOf, scaled } from './scaled';

/** What is asked of a net: at its chosen handles, with another edge length, or all of it. */
export type WantedChange =
  | { way: WayOfAll }
  | { way: 'resize'; length: number }
  | { way: Exclude<Way, WayOfAll | 'resize'>; place: Place };

/** What is done to the whole net. */
export type WayOfAll = 'refine' | 'coarsen' | 'join' | 'cut_flat';

const RADIANS = Math.PI / 180;

export function requestOf({ document, net, frame }: Opening, wanted: WantedChange, chosen: Selection): ChangeRequest {
  const { restPositions, restLengths, faceStart, faceVertices, info } = net;
  const { lengthScale } = frame;
  const { shear_limit: limit } = document.options;
  // Soft handles hold nothing.
  const exact = document.handles.filter(({ weight }) => !weight).map(({ vertex }) => vertex);
  return {
    mesh: { positions: document.positions ?? restPositions, faceStart, faceVertices },
    way: wanted.way,
    place: 'place' in wanted ? placeOf(net, chosen, wanted.place) : {},
    factor: 'length' in wanted ? wanted.length / (info.edgeLength * lengthScale) : 1,
    length: info.isChebyshev ? restLengths[0]! * lengthScale : null,
    held: wanted.way === 'resize' ? [] : exact,
    ...(limit !== undefined && { shearLimit: Number(limit) * RADIANS }),
  };
}

/** Handles stay at their vertices, where these stand now; those whose vertices are gone go, but to the nearest vertex where
 *  the net is only coarser. The shape of the moment is the net's own from now on. A surface beside it stays; see resizedGuide(). */
export function changedScene(
  document: ChebnetDocument,
  { way, mesh: { positions: before } }: Pick<ChangeRequest, 'way' | 'mesh'>,
  { mesh, origins }: ChangedNet,
  formats: readonly FormatInfo[],
): Scene {
  const vertexOf = new Map<number, number>();
  origins.forEach((old, vertex) => {
    if (old >= 0 && !vertexOf.has(old)) vertexOf.set(old, vertex);
  });
  const taken = new Set(document.handles.map(({ vertex }) => vertexOf.get(vertex)));
  const placeFor = (vertex: number): number | undefined => {
    if (vertexOf.has(vertex) || way !== 'coarsen') return vertexOf.get(vertex);
    const nearest = nearestVertex(mesh.positions, before.subarray(3 * vertex, 3 * vertex + 3));
    if (taken.has(nearest)) return undefined;
    taken.add(nearest);
    return nearest;
  };
  const net = { mesh, name: fileNameOf(document.net, 'obj', formats) };
  const handles = document.handles.flatMap((handle) => {
    const vertex = placeFor(handle.vertex);
    return vertex === undefined ? [] : [{ ...handle, vertex, target: null }];
  });
  return {
    ...remade(document, net, handles),
    method: document.method === usualMethod(document.net) ? usualMethod(net) : document.method,
  };
}

function nearestVertex(positions: Float64Array, point: Float64Array): number {
  let [nearest, least] = [0, Infinity];
  const [x, y, z] = [point[0]!, point[1]!, point[2]!];
  for (let i = 0; i < positions.length; i += 3) {
    const distance = (positions[i]! - x) ** 2 + (positions[i + 1]! - y) ** 2 + (positions[i + 2]! - z) ** 2;
    if (!(distance < least)) continue;
    nearest = i / 3;
    least = distance;
  }
  return nearest;
}

/** The surface beside a net that gets another size: of that size, too. `drawn`: what it is. */
export function resizedGuide(
  guide: GuideSource,
  { positions, triangles }: DrawnSurface,
  { mesh, factor }: Pick<ChangeRequest, 'mesh' | 'factor'>,
): GuideSource {
  return {
    name: textOf(guideTitle(guide)),
    mesh: {
      positions: scaled(positions, factor, centreOf(mesh.positions)),
      faceStart: Int32Array.from({ length: triangles.length / 3 + 1 }, (_, face) => 3 * face),
      faceVertices: triangles,
    },
  };
}

/** What the history calls it. */
export function nameOf(way: Way): ChangeName {
  const names = {
    refine: 'refine',
    coarsen: 'coarsen',
    cut: 'cut',
    cut_flat: 'cut',
    keep_larger: 'trim',
    keep_smaller: 'trim',
    delete_rows: 'deleteRows',
    delete_faces: 'deleteFaces',
    keep_pieces: 'keepPieces',
    delete_pieces: 'deletePieces',
    add_row: 'addRow',
    insert_row: 'insertRow',
    remove_line: 'removeLine',
    join: 'join',
    resize: 'resize',
  } as const;
  return [names[way]];
}
