/** A floor under the net: a faint grid, and the net's soft shadow. The shadow is the faces projected onto the floor, rendered
 *  at low resolution and blurred twice; it is redrawn when the net moves, not when the camera does. */
import {
  type BufferGeometry,
  Color,
  GLSL3,
  LinearFilter,
  MaxEquation,
  CustomBlending,
  OneFactor,
  Mesh,
  OrthographicCamera,
  PlaneGeometry,
  RedFormat,
  Scene,
  ShaderMaterial,
  Vector2,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
  DoubleSide,
} from 'three';
import { type NetData, type NetUniforms, READ_NET } from './net_data';
import type { Space } from './space';
import type { Theme } from './theme';

/** Half the side of the floor, in the scene, where the rest net's half diagonal is 1. */
const REACH = 2.6;
/** Of the grid, usually. */
const CELL = 0.2;
const PLAN_PIXELS = 256;
const BLUR_PIXELS = 128;

const PLAN_VERTEX = /* glsl */ `
uniform float reach, floorHeight;
out float height;
${READ_NET}
void main() {
  vec3 p = readVertex(gl_VertexID);
  height = p.z - floorHeight;
  gl_Position = vec4(p.xy / reach, 0.0, 1.0);
}`;

const PLAN_FRAGMENT = /* glsl */ `
in float height;
out vec4 colour;
// The higher above the floor, the more light comes in from the sides.
void main() { colour = vec4(exp(-0.9 * max(height, 0.0)), 0.0, 0.0, 1.0); }`;

const FULL_VERTEX = /* glsl */ `
out vec2 place;
void main() {
  place = position.xy * 0.5 + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

const BLUR_FRAGMENT = /* glsl */ `
uniform sampler2D source;
uniform vec2 stride;
in vec2 place;
out vec4 colour;
void main() {
  float sum = 0.0, weights = 0.0;
  for (int i = -6; i <= 6; i++) {
    float weight = exp(-0.06 * float(i * i));
    sum += weight * texture(source, place + float(i) * stride).r;
    weights += weight;
  }
  colour = vec4(sum / weights, 0.0, 0.0, 1.0);
}`;

const FLOOR_VERTEX = /* glsl */ `
out vec2 plan;
void main() {
  plan = position.xy;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const FLOOR_FRAGMENT = /* glsl */ `
uniform sampler2D plan_shadow;
uniform vec3 shadowColour, gridColour;
uniform float reach, shadowShare, cell;
uniform vec3 origin;
in vec2 plan;
out vec4 colour;
float lines(vec2 p) {
  vec2 width = fwidth(p);
  vec2 near = abs(fract(p - 0.5) - 0.5) / max(width, vec2(1e-6));
  // Fade cells of a few pixels, which would alias.
  float room = 1.0 - smoothstep(0.12, 0.35, max(width.x, width.y));
  return (1.0 - min(min(near.x, near.y), 1.0)) * room;
}
void main() {
  float shadow = shadowShare * texture(plan_shadow, plan / reach * 0.5 + 0.5).r;
  float rim = 1.0 - smoothstep(0.35, 1.0, length(plan) / reach);
  float grid = 0.45 * rim * rim * lines((plan - origin.xy) / cell);
  float alpha = shadow + grid * (1.0 - shadow);
  if (alpha < 0.003) discard;
  colour = vec4(mix(gridColour, shadowColour, shadow / alpha), alpha);
}`;

export class Ground {
  readonly object: Mesh<PlaneGeometry, ShaderMaterial>;
  readonly #plan = target(PLAN_PIXELS);
  readonly #blurred = [target(BLUR_PIXELS), target(BLUR_PIXELS)] as const;
  readonly #scene = new Scene();
  readonly #painter: Mesh<BufferGeometry, ShaderMaterial>;
  readonly #camera = new OrthographicCamera();
  readonly #sheet = new PlaneGeometry(2, 2);
  readonly #planMaterial: ShaderMaterial;
  readonly #blurMaterial = new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: FULL_VERTEX,
    fragmentShader: BLUR_FRAGMENT,
    depthTest: false,
    uniforms: { source: { value: null }, stride: { value: new Vector2() } },
  });
  #faces: BufferGeometry | null = null;

  constructor(net: NetUniforms) {
    this.#planMaterial = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: PLAN_VERTEX,
      fragmentShader: PLAN_FRAGMENT,
      side: DoubleSide,
      depthTest: false,
      blending: CustomBlending,
      blendEquation: MaxEquation,
      blendSrc: OneFactor,
      blendDst: OneFactor,
      uniforms: { ...net, reach: { value: REACH }, floorHeight: { value: 0 } },
    });
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: FLOOR_VERTEX,
      fragmentShader: FLOOR_FRAGMENT,
      transparent: true,
      depthWrite: false,
      uniforms: {
        plan_shadow: { value: this.#blurred[1].texture },
        shadowColour: { value: new Color() },
        gridColour: { value: new Color() },
        shadowShare: { value: 0 },
        reach: { value: REACH },
        cell: { value: CELL },
        origin: { value: new Vector3() },
      },
    });
    this.object = new Mesh(new PlaneGeometry(2 * REACH, 2 * REACH), material);
    this.#painter = new Mesh<BufferGeometry, ShaderMaterial>(this.#sheet, this.#planMaterial);
    this.#painter.frustumCulled = false;
    this.#scene.add(this.#painter);
  }

  /** `faces`: the net's triangles. */
  setNet({ space }: NetData, faces: BufferGeometry): void {
    this.#faces = faces;
    this.#planMaterial.uniforms.floorHeight!.value = space.floor;
    // A little below, to avoid z-fighting with a flat net.
    this.object.position.z = space.floor - 0.02;
  }

  /** Draws the grid to which drags snap, of so many units of the net, if there is one. */
  setGrid(step: number | null | undefined, space: Space): void {
    const { cell, origin } = this.object.material.uniforms;
    cell!.value = step ? step * space.scale : CELL;
    space.toScene(origin!.value, step ? [0, 0, 0] : space.centre);
  }

  setTheme(theme: Theme): void {
    const { shadowColour, gridColour, shadowShare } = this.object.material.uniforms;
    shadowColour!.value.setRGB(...theme.shadow);
    gridColour!.value.setRGB(...theme.grid);
    shadowShare!.value = theme.shadowShare;
  }

  drawShadow(renderer: WebGLRenderer): void {
    if (!this.#faces) return;
    this.#paint(renderer, this.#faces, this.#planMaterial, this.#plan);
    const { source, stride } = this.#blurMaterial.uniforms;
    source!.value = this.#plan.texture;
    stride!.value.set(1 / BLUR_PIXELS, 0);
    this.#paint(renderer, this.#sheet, this.#blurMaterial, this.#blurred[0]);
    source!.value = this.#blurred[0].texture;
    stride!.value.set(0, 1 / BLUR_PIXELS);
    this.#paint(renderer, this.#sheet, this.#blurMaterial, this.#blurred[1]);
    renderer.setRenderTarget(null);
  }

  #paint(renderer: WebGLRenderer, geometry: BufferGeometry, material: ShaderMaterial, to: WebGLRenderTarget): void {
    this.#painter.geometry = geometry;
    this.#painter.material = material;
    renderer.setRenderTarget(to);
    renderer.render(this.#scene, this.#camera);
  }

  dispose(): void {
    for (const thing of [this.#plan, ...this.#blurred, this.#sheet, this.#planMaterial, this.#blurMaterial])
      thing.dispose();
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}

function target(pixels: number): WebGLRenderTarget {
  return new WebGLRenderTarget(pixels, pixels, {
    format: RedFormat,
    minFilter: LinearFilter,
    magFilter: LinearFilter,
    depthBuffer: false,
  });
}
