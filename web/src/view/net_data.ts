/** The moving numbers of the net, on the graphics card once: lines, faces and shadow all read the same textures, so a frame
 *  costs one upload however many things are drawn. */
import {
  DataTexture,
  FloatType,
  LinearFilter,
  NearestFilter,
  RedFormat,
  RGBAFormat,
  type Texture,
} from 'three';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { lookupTable, type Scale } from './colour_map';
import type { Space } from './space';

const DEGREES = 180 / Math.PI;

/** Shaders that include this read vertex `i` and edge `e` of the net. */
export const READ_NET = /* glsl */ `
uniform highp sampler2D vertices;
uniform highp sampler2D deviations;
ivec2 place(int i, int width) { return ivec2(i % width, i / width); }
/** Scene position, and the corner angle in degrees. */
vec4 readVertex(int i) { return texelFetch(vertices, place(i, textureSize(vertices, 0).x), 0); }
float readDeviation(int e) { return texelFetch(deviations, place(e, textureSize(deviations, 0).x), 0).r; }
`;

export class NetData {
  /** Scene position and corner angle: 4 numbers a vertex. Picking reads them too. */
  readonly points: Float32Array<ArrayBuffer>;
  readonly vertexCount: number;
  /** Mean length of an edge, in the scene. */
  readonly edgeLength: number;
  readonly uniforms: { vertices: { value: Texture }; deviations: { value: Texture } };
  private readonly vertexTexture: DataTexture;
  private readonly edgeTexture: DataTexture;
  private readonly deviations: Float32Array<ArrayBuffer>;

  constructor(
    net: OpenedNet,
    readonly space: Space,
  ) {
    this.vertexCount = net.restPositions.length / 3;
    this.edgeLength = net.info.meanLength * space.scale;
    const width = side(this.vertexCount);
    this.points = new Float32Array(4 * width * Math.ceil(this.vertexCount / width));
    this.vertexTexture = new DataTexture(this.points, width, Math.ceil(this.vertexCount / width), RGBAFormat, FloatType);
    const edges = net.edges.length / 2;
    const edgeWidth = side(edges);
    this.deviations = new Float32Array(edgeWidth * Math.ceil(edges / edgeWidth));
    this.edgeTexture = new DataTexture(this.deviations, edgeWidth, Math.ceil(edges / edgeWidth), RedFormat, FloatType);
    for (const texture of [this.vertexTexture, this.edgeTexture]) {
      texture.minFilter = texture.magFilter = NearestFilter;
    }
    this.uniforms = { vertices: { value: this.vertexTexture }, deviations: { value: this.edgeTexture } };
  }

  show({ positions, cornerAngles, deviations }: FrameData): void {
    const { points, vertexCount } = this;
    const { scale, centre, axisY, axisZ, signY } = this.space;
    const [cx, cy, cz] = [centre[0], centre[axisY], centre[axisZ]];
    const scaleY = scale * signY;
    for (let i = 0, from = 0, to = 0; i < vertexCount; i++, from += 3, to += 4) {
      points[to] = (positions[from]! - cx) * scale;
      points[to + 1] = (positions[from + axisY]! - cy) * scaleY;
      points[to + 2] = (positions[from + axisZ]! - cz) * scale;
      points[to + 3] = cornerAngles[i]! * DEGREES;
    }
    this.deviations.set(deviations);
    this.vertexTexture.needsUpdate = true;
    this.edgeTexture.needsUpdate = true;
  }

  dispose(): void {
    this.vertexTexture.dispose();
    this.edgeTexture.dispose();
  }
}

/** The colour map on the graphics card; lines and faces share it. */
export class ColourTexture {
  readonly uniforms = {
    colours: { value: new DataTexture(new Uint8Array(4 * 256), 256, 1) },
    /** Ends of the map, in decades if logarithmic. */
    low: { value: 0 },
    high: { value: 1 },
    byAngle: { value: false },
  };

  constructor() {
    const texture = this.uniforms.colours.value;
    texture.minFilter = texture.magFilter = LinearFilter;
  }

  show(scale: Scale, byAngle: boolean): void {
    const { colours, low, high } = this.uniforms;
    (colours.value.image.data as Uint8Array).set(lookupTable(scale));
    colours.value.needsUpdate = true;
    low.value = scale.logarithmic ? Math.log10(scale.low) : scale.low;
    high.value = scale.logarithmic ? Math.log10(scale.high) : scale.high;
    this.uniforms.byAngle.value = byAngle;
  }

  dispose(): void {
    this.uniforms.colours.value.dispose();
  }
}

/** Width of a nearly square texture for `count` texels. */
function side(count: number): number {
  return Math.max(1, Math.ceil(Math.sqrt(count)));
}
