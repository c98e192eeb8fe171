/** A net as binary glTF: its triangles with a colour at each vertex, and its edges. Loaded when it is asked for. */
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  SRGBColorSpace,
  Vector3,
} from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import type { UpAxis } from '../document/document';
import type { Rgb } from '../fields/colour_map';

export interface Painted {
  positions: Float64Array;
  triangles: Uint32Array;
  edges: Int32Array;
  /** Red, green, blue of each vertex as the screen takes them, 0…255. */
  colours: Uint8Array;
  ink: Rgb;
  /** In glTF y points up; a net with another up axis is rotated. */
  up: UpAxis;
  name: string;
}

export async function glbOf({
  positions,
  triangles,
  edges,
  colours,
  ink,
  up,
  name,
}: Painted): Promise<Uint8Array<ArrayBuffer>> {
  const origin = originOf(positions);
  const places = new BufferAttribute(
    Float32Array.from(positions, (x, i) => x - origin.getComponent(i % 3)),
    3,
  );
  const faces = new BufferGeometry();
  faces.setAttribute('position', places);
  faces.setAttribute('color', new BufferAttribute(linear(colours), 3));
  faces.setIndex(new BufferAttribute(triangles, 1));
  faces.computeVertexNormals();
  const lines = new BufferGeometry();
  lines.setAttribute('position', places);
  lines.setIndex(new BufferAttribute(Uint32Array.from(edges), 1));

  const net = new Group();
  net.name = name;
  if (up === 'z') net.rotation.x = -Math.PI / 2;
  const paint = new MeshStandardMaterial({ vertexColors: true, side: DoubleSide, roughness: 0.9, metalness: 0 });
  const pen = new MeshBasicMaterial({ color: new Color().setRGB(...ink, SRGBColorSpace) });
  net.add(named('faces', new Mesh(faces, paint)), named('edges', new LineSegments(lines, pen)));
  for (const part of net.children) part.position.copy(origin);
  return new Uint8Array((await new GLTFExporter().parseAsync(net, { binary: true, trs: true })) as ArrayBuffer);
}

/** Farther from the origin than so many times its size, a net is told from a place within it: positions have 24 bits. */
const FAR = 100;

/** From where positions are told; nodes have numbers of full length. */
function originOf(positions: Float64Array): Vector3 {
  const box = new Box3().setFromArray(positions);
  const centre = box.getCenter(new Vector3());
  return centre.length() > FAR * box.getSize(new Vector3()).length() ? centre : new Vector3();
}

function named<T extends { name: string }>(name: string, object: T): T {
  object.name = name;
  return object;
}

/** Linear colours, as glTF demands. */
function linear(colours: Uint8Array): Float32Array {
  const colour = new Color();
  const values = new Float32Array(colours.length);
  for (let i = 0; i < colours.length; i += 3) {
    colour.setRGB(colours[i]! / 255, colours[i + 1]! / 255, colours[i + 2]! / 255, SRGBColorSpace).toArray(values, i);
  }
  return values;
}
