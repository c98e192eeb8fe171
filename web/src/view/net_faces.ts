/** The faces as fans of triangles, offset in depth so that the lines lie on them. */
import { BufferAttribute, BufferGeometry, Color, DoubleSide, GLSL3, Mesh, ShaderMaterial } from 'three';
import { type ColourTexture, IN_SECTION, type NetUniforms, PLACE_ON_MAP, READ_NET } from './net_data';
import type { Theme } from './theme';

const VERTEX = /* glsl */ `
out vec3 seen;
out float onMap;
out float mobility;
out float beyond;
${READ_NET}
${PLACE_ON_MAP}
${IN_SECTION}
void main() {
  vec3 p = readVertex(gl_VertexID);
  beyond = beyondSection(gl_VertexID, p);
  vec4 inView = modelViewMatrix * vec4(p, 1.0);
  seen = inView.xyz;
  onMap = atVertices ? placeOnMap(readNumber(gl_VertexID)) : 0.0;
  mobility = readMobility(gl_VertexID);
  gl_Position = projectionMatrix * inView;
}`;

const FRAGMENT = /* glsl */ `
uniform sampler2D colours;
uniform float low, high;
uniform bool atVertices;
uniform vec3 front, back, still;
in vec3 seen;
in float onMap;
in float mobility;
in float beyond;
out vec4 colour;
void main() {
  if (beyond > 0.0) discard;
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  // A light over the viewer's left shoulder, soft enough that no fold turns black.
  float light = 0.5 + 0.5 * dot(normal, normalize(vec3(-0.35, 0.7, 0.62)));
  vec3 base = mix(back, front, light);
  if (atVertices) base = texture(colours, vec2((onMap - low) / (high - low), 0.5)).rgb * (0.82 + 0.18 * light);
  colour = vec4(mix(still, base, 0.15 + 0.85 * mobility), 1.0);
}`;

export class NetFaces {
  readonly object: Mesh<BufferGeometry, ShaderMaterial>;

  constructor(net: NetUniforms, colours: ColourTexture) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1.5,
      polygonOffsetUnits: 2,
      uniforms: {
        ...net,
        ...colours.uniforms,
        front: { value: new Color() },
        back: { value: new Color() },
        still: { value: new Color() },
      },
    });
    this.object = new Mesh(new BufferGeometry(), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
  }

  /** @param triangles three vertices each. */
  setTriangles(triangles: Uint32Array): void {
    this.object.geometry.dispose();
    // No attributes: the shader finds each vertex by its number.
    this.object.geometry = new BufferGeometry();
    this.object.geometry.setIndex(new BufferAttribute(triangles, 1));
  }

  setTheme(theme: Theme): void {
    const { front, back, still } = this.object.material.uniforms;
    front!.value.setRGB(...theme.faceLight);
    back!.value.setRGB(...theme.faceDark);
    still!.value.setRGB(...theme.fade);
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
