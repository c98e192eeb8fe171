/** A surface as a shaded body, drawn a little behind where it is: the edges of a net on it are chords, and would vanish in it. */
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  GLSL3,
  Mesh,
  ShaderMaterial,
  type Vector3,
  Vector4,
} from 'three';
import type { Point } from '../../../wasm/chebnet';
import { mix } from '../fields/colour_map';
import type { DrawnSurface } from '../worker/protocol';
import type { NetUniforms } from './net_data';
import type { Space } from './space';
import type { Theme } from './theme';

const VERTEX = /* glsl */ `
uniform float behind;
uniform vec4 section;
out vec3 upright;
out float beyond;
void main() {
  beyond = dot(section.xyz, position) - section.w;
  upright = normalMatrix * normal;
  vec3 inView = (modelViewMatrix * vec4(position, 1.0)).xyz;
  gl_Position = projectionMatrix * vec4(inView * (1.0 + behind / length(inView)), 1.0);
}`;

const FRAGMENT = /* glsl */ `
uniform vec3 front, back;
uniform float opacity;
in vec3 upright;
in float beyond;
out vec4 colour;
void main() {
  if (beyond > 0.0) discard;
  vec3 normal = normalize(gl_FrontFacing ? upright : -upright);
  colour = vec4(mix(back, front, 0.5 + 0.5 * dot(normal, normalize(vec3(-0.35, 0.7, 0.62)))), opacity);
}`;

export class SurfaceShade {
  readonly object: Mesh<BufferGeometry, ShaderMaterial>;

  /** @param opacity below 1, what is behind shows through. @param section see NetUniforms. */
  constructor(opacity = 1, section: NetUniforms['section'] = { value: new Vector4() }) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: DoubleSide,
      // More than the net's own faces, which would vanish in it where they are seen from the side.
      polygonOffset: true,
      polygonOffsetFactor: 6,
      polygonOffsetUnits: 8,
      transparent: opacity < 1,
      depthWrite: opacity === 1,
      uniforms: {
        opacity: { value: opacity },
        section,
        behind: { value: 0 },
        front: { value: new Color() },
        back: { value: new Color() },
      },
    });
    this.object = new Mesh(new BufferGeometry(), material);
    this.object.frustumCulled = false;
  }

  setSurface({ positions, normals, triangles }: DrawnSurface, space: Space): void {
    this.object.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', inScene(positions, space, space.centre, space.scale));
    geometry.setAttribute('normal', inScene(normals, space, [0, 0, 0], 1));
    geometry.setIndex(new BufferAttribute(new Uint32Array(triangles), 1));
    this.object.geometry = geometry;
  }

  /** Of the vertices in the scene, 3 numbers each. */
  get places(): Float32Array {
    return this.object.geometry.getAttribute('position').array as Float32Array;
  }

  /** Their corners by their places, 3 each. */
  get triangles(): Uint32Array {
    return this.object.geometry.getIndex()!.array as Uint32Array;
  }

  /** How far behind, in the scene. */
  setBehind(distance: number): void {
    this.object.material.uniforms.behind!.value = distance;
  }

  setTheme(theme: Theme): void {
    const { front, back } = this.object.material.uniforms;
    // Darker than the page, lighter than a net.
    front!.value.setRGB(...mix(theme.faceLight, theme.ink, 0.06));
    back!.value.setRGB(...mix(theme.faceDark, theme.ink, 0.18));
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}

/** A direction in the scene. */
export function turn(point: Vector3, direction: Readonly<Point>, { axisY, axisZ, signY }: Space): void {
  point.set(direction[0], signY * direction[axisY], direction[axisZ]);
}

/** As Space.toScene and `turn` do it, but a million at a time. */
function inScene(
  numbers: Float64Array,
  { axisY, axisZ, signY }: Space,
  centre: Readonly<Point>,
  scale: number,
): BufferAttribute {
  const array = new Float32Array(numbers.length);
  for (let i = 0; i < numbers.length; i += 3) {
    array[i] = (numbers[i]! - centre[0]) * scale;
    array[i + 1] = (numbers[i + axisY]! - centre[axisY]) * scale * signY;
    array[i + 2] = (numbers[i + axisZ]! - centre[axisZ]) * scale;
  }
  return new BufferAttribute(array, 3);
}
