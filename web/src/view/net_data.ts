/** The moving numbers of the net, on the graphics card once: lines, faces and shadow all read the same textures, so a frame
 *  costs one upload however many things are drawn. */
import {
  DataTexture,
  FloatType,
  IntType,
  LinearFilter,
  NearestFilter,
  type PixelFormat,
  RedFormat,
  RGBAFormat,
  RGIntegerFormat,
  type Texture,
  type TextureDataType,
} from 'three';
import type { Field } from '../document/document';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { lookupTable, type Scale } from './colour_map';
import { isLonger } from './longer';
import type { Space } from './space';

const DEGREES = 180 / Math.PI;

/** Shaders that include this read vertex `i` and edge `e` of the net. */
export const READ_NET = /* glsl */ `
uniform highp sampler2D vertices;
uniform highp sampler2D edgeValues;
uniform highp sampler2D mobilities;
uniform highp isampler2D ends;
ivec2 place(int i, int width) { return ivec2(i % width, i / width); }
/** Scene position, and the corner angle in degrees. */
vec4 readVertex(int i) { return texelFetch(vertices, place(i, textureSize(vertices, 0).x), 0); }
/** Both vertices of an edge. */
ivec2 readEnds(int e) { return texelFetch(ends, place(e, textureSize(ends, 0).x), 0).rg; }
/** How freely a vertex moves with a drag: 1, or less where a region is shown. */
float readMobility(int i) { return texelFetch(mobilities, place(i, textureSize(mobilities, 0).x), 0).r; }
/** Its deviation, or whether it is longer than it is to be. */
float readEdge(int e) { return texelFetch(edgeValues, place(e, textureSize(edgeValues, 0).x), 0).r; }
`;

/** Where shaders find the net of the moment. All materials of a view share it and outlive the net: to compile them anew for
 *  each net would hold the page up. */
export interface NetUniforms {
  vertices: { value: Texture | null };
  edgeValues: { value: Texture | null };
  mobilities: { value: Texture | null };
  ends: { value: Texture | null };
}

export function netUniforms(): NetUniforms {
  return { vertices: { value: null }, edgeValues: { value: null }, mobilities: { value: null }, ends: { value: null } };
}

export class NetData {
  /** Scene position and corner angle: 4 numbers a vertex. Picking reads them too. */
  readonly points: Float32Array<ArrayBuffer>;
  readonly vertexCount: number;
  /** Mean length of an edge, in the scene. */
  readonly edgeLength: number;
  private readonly vertices: DataTexture;
  private readonly edgeTexture: DataTexture;
  private readonly mobilities: DataTexture;
  private readonly mobilityValues: Float32Array<ArrayBuffer>;
  private readonly ends: DataTexture;
  private readonly edgeValues: Float32Array<ArrayBuffer>;

  constructor(
    private readonly net: OpenedNet,
    readonly space: Space,
  ) {
    this.vertexCount = net.restPositions.length / 3;
    this.edgeLength = net.info.meanLength * space.scale;
    const edges = net.edges.length / 2;
    this.points = new Float32Array(4 * texels(this.vertexCount));
    this.edgeValues = new Float32Array(texels(edges));
    const ends = new Int32Array(2 * texels(edges));
    ends.set(net.edges);
    this.vertices = table(this.points, this.vertexCount, RGBAFormat, FloatType);
    this.edgeTexture = table(this.edgeValues, edges, RedFormat, FloatType);
    this.mobilityValues = new Float32Array(texels(this.vertexCount)).fill(1);
    this.mobilities = table(this.mobilityValues, this.vertexCount, RedFormat, FloatType);
    this.mobilities.needsUpdate = true;
    this.ends = table(ends, edges, RGIntegerFormat, IntType);
    this.ends.needsUpdate = true;
  }

  /** @param field what of the edges is wanted. */
  show({ positions, cornerAngles, deviations }: FrameData, field: Field): void {
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
    if (field === 'longer')
      for (let edge = 0; edge < deviations.length; edge++)
        this.edgeValues[edge] = Number(isLonger(this.net, positions, edge));
    else this.edgeValues.set(deviations);
    this.vertices.needsUpdate = true;
    this.edgeTexture.needsUpdate = true;
  }

  /** null: all vertices move freely. */
  showRegion(mobility: Float32Array | null): void {
    if (mobility) this.mobilityValues.set(mobility);
    else this.mobilityValues.fill(1);
    this.mobilities.needsUpdate = true;
  }

  putInto(uniforms: NetUniforms): void {
    uniforms.mobilities.value = this.mobilities;
    uniforms.vertices.value = this.vertices;
    uniforms.edgeValues.value = this.edgeTexture;
    uniforms.ends.value = this.ends;
  }

  dispose(): void {
    for (const texture of [this.vertices, this.edgeTexture, this.mobilities, this.ends]) texture.dispose();
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
    byDecade: { value: true },
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
    this.uniforms.byDecade.value = scale.logarithmic;
  }

  dispose(): void {
    this.uniforms.colours.value.dispose();
  }
}

/** Width of a nearly square texture for `count` texels. */
function side(count: number): number {
  return Math.max(1, Math.ceil(Math.sqrt(count)));
}

/** So many texels such a texture has. */
function texels(count: number): number {
  return side(count) * Math.ceil(count / side(count));
}

/** A texture that shaders read by number. */
function table(
  values: Float32Array<ArrayBuffer> | Int32Array<ArrayBuffer>,
  count: number,
  format: PixelFormat,
  type: TextureDataType,
): DataTexture {
  const texture = new DataTexture(values, side(count), Math.ceil(count / side(count)), format, type);
  texture.minFilter = texture.magFilter = NearestFilter;
  return texture;
}
