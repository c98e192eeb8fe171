/** Positions and field values of the net as textures, which lines, faces and shadow share: a frame costs one upload. */
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
  Vector4,
} from 'three';
import { lookupTable, type Scale } from '../fields/colour_map';
import type { ColourField, Placed } from '../fields/fields';
import type { OpenedNet } from '../worker/protocol';
import type { Space } from './space';

/** Shaders that include this read vertex `i` and edge `e` of the net. */
export const READ_NET = /* glsl */ `
uniform highp sampler2D vertices;
uniform highp sampler2D numbers;
uniform highp sampler2D mobilities;
uniform highp isampler2D ends;
ivec2 place(int i, int width) { return ivec2(i % width, i / width); }
/** Whether a vertex is left out of the picture. */
bool isHidden(int i) { return texelFetch(vertices, place(i, textureSize(vertices, 0).x), 0).w > 0.0; }
/** Scene position. */
vec3 readVertex(int i) { return texelFetch(vertices, place(i, textureSize(vertices, 0).x), 0).xyz; }
/** Both vertices of an edge. */
ivec2 readEnds(int e) { return texelFetch(ends, place(e, textureSize(ends, 0).x), 0).rg; }
/** How freely a vertex moves with a drag: 1, or less where a region is shown. */
float readMobility(int i) { return texelFetch(mobilities, place(i, textureSize(mobilities, 0).x), 0).r; }
/** Of the field that is shown, at a vertex or an edge. */
float readNumber(int i) { return texelFetch(numbers, place(i, textureSize(numbers, 0).x), 0).r; }
`;

/** Shaders that include this, after READ_NET, leave out what is beyond the section plane, where the number is positive; and what belongs to
 *  hidden vertices: between one of these and one that is shown, the number is positive all the way. */
export const IN_SECTION = /* glsl */ `
uniform vec4 section;
float beyondSection(int i, vec3 p) { return isHidden(i) ? 1e6 : dot(section.xyz, p) - section.w; }
`;

/** Uniforms with the section plane and the textures of the present net. All materials of a view share them and outlive the net: recompiling them
 *  for each net would block the page. */
export interface NetUniforms {
  vertices: { value: Texture | null };
  numbers: { value: Texture | null };
  mobilities: { value: Texture | null };
  ends: { value: Texture | null };
  /** Its normal, and how far it is from the origin along that; 0: there is none. */
  section: { value: Vector4 };
}

export function netUniforms(): NetUniforms {
  return {
    vertices: { value: null },
    numbers: { value: null },
    mobilities: { value: null },
    ends: { value: null },
    section: { value: new Vector4() },
  };
}

export class NetData {
  /** Scene position, 4 numbers a vertex, since there are no textures of three channels; the fourth is 1 where it is hidden,
   *  or 0. Picking reads them too. */
  readonly points: Float32Array<ArrayBuffer>;
  readonly vertexCount: number;
  /** Mean length of an edge, in the scene. */
  readonly edgeLength: number;
  readonly #vertices: DataTexture;
  readonly #numberTexture: DataTexture;
  readonly #mobilities: DataTexture;
  readonly #mobilityValues: Float32Array<ArrayBuffer>;
  readonly #ends: DataTexture;
  /** Of the field that is shown, one for each vertex or each edge. */
  readonly #numbers: Float32Array<ArrayBuffer>;
  readonly #net: OpenedNet;

  constructor(
    net: OpenedNet,
    readonly space: Space,
  ) {
    this.#net = net;
    this.vertexCount = net.restPositions.length / 3;
    this.edgeLength = net.info.meanLength * space.scale;
    const edges = net.edges.length / 2;
    this.points = new Float32Array(4 * texels(this.vertexCount));
    const most = Math.max(this.vertexCount, edges);
    this.#numbers = new Float32Array(texels(most));
    const ends = new Int32Array(2 * texels(edges));
    ends.set(net.edges);
    this.#vertices = table(this.points, this.vertexCount, RGBAFormat, FloatType);
    this.#numberTexture = table(this.#numbers, most, RedFormat, FloatType);
    this.#mobilityValues = new Float32Array(texels(this.vertexCount)).fill(1);
    this.#mobilities = table(this.#mobilityValues, this.vertexCount, RedFormat, FloatType);
    this.#mobilities.needsUpdate = true;
    this.#ends = table(ends, edges, RGIntegerFormat, IntType);
    this.#ends.needsUpdate = true;
  }

  setFrame(placed: Placed, field: ColourField): void {
    const { points, vertexCount } = this;
    const { positions } = placed;
    const { scale, centre, axisY, axisZ, signY } = this.space;
    const [cx, cy, cz] = [centre[0], centre[axisY], centre[axisZ]];
    const scaleY = scale * signY;
    for (let i = 0, from = 0, to = 0; i < vertexCount; i++, from += 3, to += 4) {
      points[to] = (positions[from]! - cx) * scale;
      points[to + 1] = (positions[from + axisY]! - cy) * scaleY;
      points[to + 2] = (positions[from + axisZ]! - cz) * scale;
    }
    field.write(this.#numbers, placed, this.#net);
    this.#vertices.needsUpdate = true;
    this.#numberTexture.needsUpdate = true;
  }

  /** null: all vertices move freely. */
  setMobility(mobility: Float32Array | null): void {
    if (mobility) this.#mobilityValues.set(mobility);
    else this.#mobilityValues.fill(1);
    this.#mobilities.needsUpdate = true;
  }

  /** By vertex, 1 where it is left out of the picture; none: all are in it. */
  setHidden(hidden?: Uint8Array): void {
    for (let i = 0; i < this.vertexCount; i++) this.points[4 * i + 3] = hidden?.[i] ?? 0;
    this.#vertices.needsUpdate = true;
  }

  putInto(uniforms: NetUniforms): void {
    uniforms.mobilities.value = this.#mobilities;
    uniforms.vertices.value = this.#vertices;
    uniforms.numbers.value = this.#numberTexture;
    uniforms.ends.value = this.#ends;
  }

  dispose(): void {
    for (const texture of [this.#vertices, this.#numberTexture, this.#mobilities, this.#ends]) texture.dispose();
  }
}

/** Shaders that include this map a value of the field to its position on the colour map. */
export const PLACE_ON_MAP = /* glsl */ `
uniform bool atVertices, byDecade;
float placeOnMap(float number) { return byDecade ? log(max(number, 1e-30)) / log(10.0) : number; }
`;

/** The colour map on the graphics card; lines and faces share it. */
export class ColourTexture {
  readonly uniforms = {
    colours: { value: new DataTexture(new Uint8Array(4 * 256), 256, 1) },
    /** Ends of the map, in decades if logarithmic. */
    low: { value: 0 },
    high: { value: 1 },
    atVertices: { value: false },
    byDecade: { value: true },
  };

  constructor() {
    const texture = this.uniforms.colours.value;
    texture.minFilter = texture.magFilter = LinearFilter;
  }

  /** @param place where the numbers stand. */
  setScale(scale: Scale, place: ColourField['place']): void {
    const { colours, low, high } = this.uniforms;
    (colours.value.image.data as Uint8Array).set(lookupTable(scale));
    colours.value.needsUpdate = true;
    low.value = scale.logarithmic ? Math.log10(scale.low) : scale.low;
    high.value = scale.logarithmic ? Math.log10(scale.high) : scale.high;
    this.uniforms.atVertices.value = place === 'vertex';
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
