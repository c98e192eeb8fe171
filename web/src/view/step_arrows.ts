/** The direction of a single step: an arrow from where each vertex stood towards where it went. One object with instances;
 *  its arrays are made once. */
import {
  Color,
  DynamicDrawUsage,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  ShaderMaterial,
  Vector2,
  Vector3,
} from 'three';
import { longestMove } from '../document/longest_move';
import type { FrameData } from '../worker/protocol';
import type { Space } from './space';
import type { Theme } from './theme';

/** In larger nets every second vertex has an arrow, or every third …; more could not be told apart. */
const MOST_ARROWS = 5000;
/** The longest arrow, in edges. Moves are mostly too small to be seen, so arrows are scaled to this. */
const LONGEST = 4;

const VERTEX = /* glsl */ `
in vec3 tail;
in vec3 way;
uniform vec2 viewport;  // device pixels
uniform float pixel;    // device pixels in a CSS pixel
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(tail, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(tail + way, 1.0);
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport * 0.5;
  float size = length(along);
  float head = min(6.0 * pixel, 0.6 * size);
  vec2 across = size > 1e-3 ? vec2(-along.y, along.x) / size : vec2(0.0);
  // Vertices 0 and 1 are the tail, 2 and 3 the neck, 4 and 5 the barbs, 6 is the tip.
  int corner = gl_VertexID;
  float side = (corner & 1) == 1 ? 1.0 : -1.0;
  float half_width = corner < 4 ? 0.5 * pixel : corner < 6 ? 0.42 * head : 0.0;
  float part = corner < 2 ? 0.0 : corner < 6 ? 1.0 - head / max(size, 1e-3) : 1.0;
  gl_Position = mix(a, b, part);
  gl_Position.xy += across * side * half_width * 2.0 / viewport * gl_Position.w;
}`;

const FRAGMENT = /* glsl */ `
uniform vec3 ink;
out vec4 colour;
void main() { colour = vec4(ink, 0.8); }`;

const TRIANGLES = [0, 2, 1, 1, 2, 3, 4, 6, 5];

export class StepArrows {
  readonly object: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  readonly #tails = makeAttribute();
  readonly #ways = makeAttribute();
  readonly #from = new Vector3();
  readonly #to = new Vector3();

  constructor() {
    const geometry = new InstancedBufferGeometry();
    geometry.setIndex(TRIANGLES);
    geometry.setAttribute('tail', this.#tails);
    geometry.setAttribute('way', this.#ways);
    geometry.instanceCount = 0;
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      // The previous position of a vertex is often behind the present net.
      depthTest: false,
      depthWrite: false,
      uniforms: { viewport: { value: new Vector2(1, 1) }, pixel: { value: 1 }, ink: { value: new Color() } },
    });
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 4;
    this.object.visible = false;
  }

  /** @param edgeLength in the scene. */
  update({ stepFrom, positions }: FrameData, space: Space, edgeLength: number): void {
    const { geometry } = this.object;
    geometry.instanceCount = 0;
    if (stepFrom === null) return;
    const longest = longestMove(stepFrom, positions) * space.scale;
    if (longest > 0) geometry.instanceCount = this.#write(stepFrom, positions, space, (LONGEST * edgeLength) / longest);
  }

  setTheme(theme: Theme): void {
    this.object.material.uniforms.ink!.value.setRGB(...theme.ink);
  }

  beforeDraw(size: Vector2, pixelRatio: number): void {
    const { viewport, pixel } = this.object.material.uniforms;
    viewport!.value.copy(size).multiplyScalar(pixelRatio);
    pixel!.value = pixelRatio;
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }

  #write(before: Float64Array, after: Float64Array, space: Space, scale: number): number {
    const [tails, ways, from, to] = [this.#tails, this.#ways, this.#from, this.#to];
    const stride = Math.ceil(before.length / 3 / MOST_ARROWS);
    let count = 0;
    for (let i = 0; i < before.length; i += 3 * stride) {
      if (before[i] === after[i] && before[i + 1] === after[i + 1] && before[i + 2] === after[i + 2]) continue;
      placeAt(from, before, i, space);
      placeAt(to, after, i, space).sub(from).multiplyScalar(scale);
      tails.setXYZ(count, from.x, from.y, from.z);
      ways.setXYZ(count, to.x, to.y, to.z);
      count += 1;
    }
    tails.needsUpdate = ways.needsUpdate = true;
    return count;
  }
}

const place: [number, number, number] = [0, 0, 0];

function placeAt(point: Vector3, positions: Float64Array, at: number, space: Space): Vector3 {
  for (let axis = 0; axis < 3; axis++) place[axis] = positions[at + axis]!;
  space.toScene(point, place);
  return point;
}

function makeAttribute(): InstancedBufferAttribute {
  const attribute = new InstancedBufferAttribute(new Float32Array(3 * MOST_ARROWS), 3);
  attribute.setUsage(DynamicDrawUsage);
  return attribute;
}
