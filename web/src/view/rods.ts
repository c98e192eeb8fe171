/** The edges as rods of a thickness: an instance of one tube for each, which the card puts between both ends of the edge
 *  (net_data.ts), so that nothing is written per edge when the net moves. Loaded when they are first wanted. */
import { Color, GLSL3, InstancedBufferGeometry, Mesh, ShaderMaterial } from 'three';
import { type ColourTexture, IN_SECTION, type NetData, type NetUniforms, PLACE_ON_MAP, READ_NET } from './net_data';
import type { Theme } from './theme';

/** Corners around a tube. */
const CORNERS = 7;

const VERTEX = /* glsl */ `
uniform float radius;
out vec3 upright;
out float onMap, mobility, beyond;
${READ_NET}
${PLACE_ON_MAP}
${IN_SECTION}
void main() {
  ivec2 vertex = readEnds(gl_InstanceID);
  vec3 a = readVertex(vertex.x), b = readVertex(vertex.y);
  vec3 along = normalize(b - a);
  vec3 u = normalize(cross(along, abs(along.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
  // Even vertices stand around the first end, odd ones around the second; the last two are the tips that close it.
  bool second = (gl_VertexID & 1) == 1;
  int corner = gl_VertexID >> 1;
  float angle = 6.2831853 * float(corner) / ${CORNERS}.0;
  upright = corner < ${CORNERS} ? cos(angle) * u + sin(angle) * cross(along, u) : second ? along : -along;
  vec3 place = (second ? b : a) + radius * upright;
  beyond = beyondSection(second ? vertex.y : vertex.x, place);
  onMap = placeOnMap(readNumber(atVertices ? (second ? vertex.y : vertex.x) : gl_InstanceID));
  mobility = readMobility(second ? vertex.y : vertex.x);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 1.0);
  upright = normalMatrix * upright;
}`;

const FRAGMENT = /* glsl */ `
uniform sampler2D colours;
uniform float low, high;
uniform vec3 still;
in vec3 upright;
in float onMap, mobility, beyond;
out vec4 colour;
void main() {
  if (beyond > 0.0) discard;
  vec3 mapped = texture(colours, vec2((onMap - low) / (high - low), 0.5)).rgb;
  // The light of the faces, harder: a rod is to look round.
  float light = dot(normalize(upright), normalize(vec3(-0.35, 0.7, 0.62)));
  colour = vec4(mix(still, mapped * (0.72 + 0.38 * light), 0.2 + 0.8 * mobility), 1.0);
}`;

export class Rods {
  readonly object: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  #edgeLength = 1;
  #share = 0;

  constructor(net: NetUniforms, colours: ColourTexture) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ...net, ...colours.uniforms, radius: { value: 0 }, still: { value: new Color() } },
    });
    const geometry = new InstancedBufferGeometry();
    geometry.setIndex(tube());
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
  }

  setNet({ edgeLength }: NetData, edges: number): void {
    this.object.geometry.instanceCount = edges;
    this.#edgeLength = edgeLength;
    this.setThickness(this.#share);
  }

  /** Their diameter, as a part of an edge's length. */
  setThickness(share: number): void {
    this.#share = share;
    this.object.material.uniforms.radius!.value = (share * this.#edgeLength) / 2;
  }

  setTheme(theme: Theme): void {
    this.object.material.uniforms.still!.value.setRGB(...theme.fade);
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}

/** Triangles of the vertices as the shader numbers them. */
function tube(): number[] {
  const [firstTip, secondTip] = [2 * CORNERS, 2 * CORNERS + 1];
  return Array.from({ length: CORNERS }, (_, corner) => {
    const [a, b] = [2 * corner, 2 * ((corner + 1) % CORNERS)];
    return [a, b, a + 1, b, b + 1, a + 1, firstTip, b, a, secondTip, a + 1, b + 1];
  }).flat();
}
