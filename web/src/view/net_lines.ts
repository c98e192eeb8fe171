/** The edges as lines with a width. Each edge is a strip of four vertices; the card reads both ends and the number it is coloured by from the
 *  net's textures (net_data.ts), so nothing is written per edge when the net moves. That draws half the vertices of three's
 *  LineSegments2 and uploads a sixth as much, so one kind of line serves nets of every size. Plain vertices, not instances:
 *  graphics cards, and still more their stand-ins in software, are slow at instances as small as these. */
import { BufferAttribute, BufferGeometry, Color, GLSL3, Mesh, ShaderMaterial, Vector2 } from 'three';
import { type Eye, halfHeight } from './camera_rig';
import { type ColourTexture, IN_SECTION, type NetData, type NetUniforms, PLACE_ON_MAP, READ_NET } from './net_data';
import type { Theme } from './theme';

const VERTEX = /* glsl */ `
uniform vec2 viewport;      // device pixels
uniform float width;        // device pixels
uniform float near;
uniform float lift;
uniform vec2 fadeRange;     // distances from the camera
out float value;
out float across;
out float away;
out float mobility;
out float beyond;
${READ_NET}
${PLACE_ON_MAP}
${IN_SECTION}

/** Clips a line at the near plane. */
vec3 cut(vec3 p, vec3 q) { return p.z > -near ? mix(p, q, (p.z + near) / (p.z - q.z)) : p; }

/** A little nearer on the line of sight: in front of faces that are not quite flat. */
vec3 lifted(vec3 p) { return isOrthographic ? p + vec3(0.0, 0.0, lift) : p * (1.0 - lift / max(length(p), lift)); }

void main() {
  // Of the four vertices of an edge, odd ones stand at its second end, the latter two at its other side.
  int corner = gl_VertexID & 3;
  bool second = (corner & 1) == 1;
  float side = corner < 2 ? -1.0 : 1.0;
  int edge = gl_VertexID >> 2;
  ivec2 vertex = readEnds(edge);
  vec3 a = readVertex(vertex.x), b = readVertex(vertex.y);
  vec3 p = (modelViewMatrix * vec4(a, 1.0)).xyz, q = (modelViewMatrix * vec4(b, 1.0)).xyz;
  vec4 c = projectionMatrix * vec4(lifted(cut(p, q)), 1.0), d = projectionMatrix * vec4(lifted(cut(q, p)), 1.0);
  vec2 along = (d.xy / d.w - c.xy / c.w) * viewport;
  along = dot(along, along) > 1e-8 ? normalize(along) : vec2(1.0, 0.0);
  // One pixel wider than the line, for antialiasing.
  float reach = 0.5 * (width + 2.0);
  gl_Position = second ? d : c;
  gl_Position.xy += vec2(-along.y, along.x) * side * reach * 2.0 / viewport * gl_Position.w;
  across = side * reach;
  beyond = second ? beyondSection(vertex.y, b) : beyondSection(vertex.x, a);
  value = placeOnMap(readNumber(atVertices ? (second ? vertex.y : vertex.x) : edge));
  mobility = readMobility(second ? vertex.y : vertex.x);
  away = smoothstep(fadeRange.x, fadeRange.y, second ? -q.z : -p.z);
}`;

const FRAGMENT = /* glsl */ `
uniform sampler2D colours;
uniform float low, high, width, fade, inkShare;
uniform vec3 fadeColour, ink;
in float value;
in float across;
in float away;
in float mobility;
in float beyond;
out vec4 colour;
void main() {
  if (beyond > 0.0) discard;
  vec3 mapped = texture(colours, vec2((value - low) / (high - low), 0.5)).rgb;
  mapped = mix(mapped, ink, inkShare);
  // Lines thinner than a pixel are drawn one pixel wide and lighter.
  float rim = clamp(0.5 * max(width, 1.0) + 0.5 - abs(across), 0.0, 1.0) * min(width, 1.0);
  if (rim < 0.02) discard;
  colour = vec4(mix(mapped, fadeColour, max(fade * away, 0.8 * (1.0 - mobility))), rim);
}`;

const INK_SHARE = 0.55;
/** In edge lengths. */
const LIFT = 0.12;

/** How wide a line is for an edge of so many pixels: thin in dense nets, so that they do not fill up. */
function lineWidth(edgePixels: number): number {
  return Math.min(1.7, Math.max(0.55, 0.11 * edgePixels + 0.35));
}

export class NetLines {
  readonly object: Mesh<BufferGeometry, ShaderMaterial>;
  #edgeLength = 1;

  constructor(net: NetUniforms, colours: ColourTexture) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      // Only faces and handles occlude lines. If lines wrote depth, their antialiased rims would cut gaps at every crossing.
      depthWrite: false,
      uniforms: {
        ...net,
        ...colours.uniforms,
        viewport: { value: new Vector2() },
        width: { value: 1 },
        near: { value: 0.01 },
        lift: { value: LIFT },
        fadeRange: { value: new Vector2() },
        fade: { value: 0 },
        fadeColour: { value: new Color() },
        ink: { value: new Color() },
        inkShare: { value: 0 },
      },
    });
    this.object = new Mesh(new BufferGeometry(), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 2;
  }

  /** @param strips two triangles an edge, of its four vertices. */
  setNet({ edgeLength }: NetData, strips: Uint32Array): void {
    this.object.geometry.dispose();
    this.object.geometry = new BufferGeometry();
    this.object.geometry.setIndex(new BufferAttribute(strips, 1));
    this.object.material.uniforms.lift!.value = LIFT * edgeLength;
    this.#edgeLength = edgeLength;
  }

  setTheme(theme: Theme): void {
    const { fade, fadeColour, ink } = this.object.material.uniforms;
    fadeColour!.value.setRGB(...theme.fade);
    ink!.value.setRGB(...theme.ink);
    fade!.value = theme.fadeShare;
  }

  /** On coloured faces lines are darkened towards ink, to stand out. */
  setOverColours(over: boolean): void {
    this.object.material.uniforms.inkShare!.value = over ? INK_SHARE : 0;
  }

  beforeDraw(camera: Eye, size: Vector2, pixelRatio: number, distance: number): void {
    const { viewport, width, near, fadeRange } = this.object.material.uniforms;
    const pixelsPerLength = size.y / (2 * halfHeight(camera, distance));
    viewport!.value.copy(size).multiplyScalar(pixelRatio);
    width!.value = lineWidth(this.#edgeLength * pixelsPerLength) * pixelRatio;
    near!.value = camera.near;
    fadeRange!.value.set(distance - 0.7, distance + 1.2);
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
