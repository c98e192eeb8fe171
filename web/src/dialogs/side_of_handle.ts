/** From where a net is seen first that comes from a dialog or a script: a visitor is to pull its free handle, which the net
 *  itself may hide. */
import { Vector3 } from 'three';
import type { Mesh } from '../../../wasm/chebnet';
import type { CameraPlace, HandleSeed, UpAxis, ViewPlace } from '../document/document';
import { directionsTowards, isClear, isHidden } from '../drape/seen_from';
import { directionFor } from '../view/camera_fit';
import { Space } from '../view/space';
import { fanTriangles } from '../worker/triangles';

/** In the scene: about as far as an eye stands that sees the whole net. */
const AWAY = 3.5;

/** From the front if the handle is seen from there, else from behind, as other nets are; else by a camera that stands where it is
 *  seen, at no particular distance. From the front, too, where nothing shows it. */
export function sideOf(net: Mesh, handles: readonly HandleSeed[], upAxis: UpAxis): ViewPlace {
  const free = handles.filter(({ anchor }) => !anchor).at(-1);
  if (free === undefined) return { camera: null };
  const space = new Space(net.positions, upAxis);
  const corners = inScene(net.positions, space);
  const triangles = fanTriangles(net.faceStart, net.faceVertices);
  const place = new Vector3().fromArray(corners, 3 * free.vertex);
  const front = directionFor();
  const back = directionFor('free', true);
  const directions = [front, back, ...directionsTowards(normalAt(free.vertex, corners, triangles), front)];
  const isSeen = (asks: typeof isHidden, direction: Vector3) =>
    asks(place, direction.clone().multiplyScalar(AWAY), corners, triangles);
  const seen =
    directions.find((each) => isSeen(isClear, each)) ?? directions.find((each) => !isSeen(isHidden, each)) ?? front;
  if (seen === front || seen === back) return { camera: null, behind: seen === back };
  return { camera: cameraAt(seen, space) };
}

function cameraAt(direction: Vector3, space: Space): CameraPlace {
  return { position: space.toNet(direction.clone().multiplyScalar(AWAY)), target: space.toNet(new Vector3()) };
}

function inScene(positions: Float64Array, space: Space): Float32Array {
  const corners = new Float32Array(positions.length);
  const place = new Vector3();
  for (let i = 0; i < positions.length; i += 3) {
    space.toScene(place, [positions[i]!, positions[i + 1]!, positions[i + 2]!]);
    place.toArray(corners, i);
  }
  return corners;
}

function normalAt(vertex: number, corners: Float32Array, triangles: ArrayLike<number>): Vector3 {
  const [a, b, c, sum] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  for (let t = 0; t < triangles.length; t += 3) {
    if (![0, 1, 2].some((i) => triangles[t + i] === vertex)) continue;
    for (const [i, corner] of [a, b, c].entries()) corner.fromArray(corners, 3 * triangles[t + i]!);
    sum.add(b.sub(a).cross(c.sub(a)));
  }
  return sum.normalize();
}
