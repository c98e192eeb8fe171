/** What the graphics card reads: made once a net, written in place ever after. */
import { describe, expect, test } from 'vitest';
import type { CoreFields } from '../../wasm/chebnet';
import { load } from '../wasm/load';
import { FIELDS, numbersOf, type Placed } from '../../web/src/fields/fields';
import { ColourTexture, NetData, netUniforms } from '../../web/src/view/net_data';
import { NetLines } from '../../web/src/view/net_lines';
import { Space } from '../../web/src/view/space';
import type { OpenedNet } from '../../web/src/worker/protocol';
import { stripTriangles } from '../../web/src/worker/triangles';

const core = await load();

function openedNet(recipe: string): OpenedNet {
  return { ...core.openRecipe(recipe) } as unknown as OpenedNet;
}

function frameOf({ restPositions, edges }: OpenedNet, shift: number): Placed {
  return {
    positions: restPositions.map((x) => x + shift),
    lengthScale: 1,
    fields: {
      deviation: new Float32Array(edges.length / 2).fill(shift),
      angle: new Float32Array(restPositions.length / 3).fill(Math.PI / 2),
    } as CoreFields,
  };
}

const net = openedNet('vault:vertices=300');
const smaller = openedNet('dome:vertices=200');
const { vertices, edges } = net.info;

function dataOf(shown: OpenedNet): NetData {
  return new NetData(shown, new Space(shown.restPositions));
}

/** Stretched along x. */
function stretched({ restPositions }: OpenedNet, factor: number): Float64Array {
  return restPositions.map((x, i) => (i % 3 === 0 ? factor * x : x));
}

describe('edges longer than they are to be', () => {
  const along = (e: number) =>
    Math.abs(net.restPositions[3 * net.edges[2 * e]!]! - net.restPositions[3 * net.edges[2 * e + 1]!]!);
  const notAcross = Array.from({ length: edges }, (_, e) => along(e) > 1e-3 * net.info.meanLength);

  const longerAt = (positions: Float64Array) => [...numbersOf(FIELDS.longer, { ...frameOf(net, 0), positions }, net)];

  test('are none at rest, where lengths are off by rounding alone', () => {
    expect(longerAt(net.restPositions)).not.toContain(1);
    expect(longerAt(stretched(net, 1 + 1e-12))).not.toContain(1);
  });

  test('are those that a stretch reaches, and none of them when it shrinks', () => {
    expect(notAcross.some(Boolean)).toBe(true);
    expect(longerAt(stretched(net, 1.1))).toEqual(notAcross.map(Number));
    expect(longerAt(stretched(net, 0.9))).not.toContain(1);
  });

  test('are marked on the graphics card when they are what is shown', () => {
    const data = dataOf(net);
    const uniforms = netUniforms();
    data.putInto(uniforms);
    const { data: values } = uniforms.numbers.value!.image as { data: Float32Array };
    const frame = { ...frameOf(net, 0.25), positions: stretched(net, 1.1) };
    data.setFrame(frame, FIELDS.longer);
    expect([...values.subarray(0, edges)]).toEqual(notAcross.map(Number));
    data.setFrame(frame, FIELDS.deviation);
    expect([...values.subarray(0, edges)]).toEqual(Array(edges).fill(0.25));
  });
});

describe('the textures of a net', () => {
  const data = dataOf(net);
  const uniforms = netUniforms();
  data.putInto(uniforms);

  test('hold every vertex and edge, by number', () => {
    data.setFrame(frameOf(net, 0), FIELDS.deviation);
    const { data: points } = uniforms.vertices.value!.image as { data: Float32Array };
    const { data: ends } = uniforms.ends.value!.image as { data: Int32Array };
    expect(points).toBe(data.points);
    expect(points.subarray(0, 4 * vertices).every((x) => Math.abs(x) <= 1)).toBe(true);
    expect(ends.subarray(0, 2 * edges)).toEqual(net.edges);
  });

  test('stay the same objects from frame to frame, and each frame is one upload', () => {
    const { section: _, ...textures } = uniforms;
    const kept = Object.values(textures).map(({ value }) => value!);
    const arrays = kept.map((texture) => (texture.image as { data: unknown }).data);
    const versions = kept.map(({ version }) => version);
    for (const shift of [0.1, 0.2, 0.3]) data.setFrame(frameOf(net, shift), FIELDS.deviation);
    expect(Object.values(textures).map(({ value }) => value!)).toEqual(kept);
    kept.forEach((texture, i) => expect((texture.image as { data: unknown }).data).toBe(arrays[i]));
    expect(kept.map(({ version }, i) => version - versions[i]!)).toEqual([3, 3, 0, 0]);
  });
});

test('two triangles of an edge share its four vertices', () => {
  expect([...stripTriangles(2)]).toEqual([0, 1, 2, 2, 1, 3, 4, 5, 6, 6, 5, 7]);
});

test('the next net is drawn by the same material: nothing is compiled for it', () => {
  const uniforms = netUniforms();
  const lines = new NetLines(uniforms, new ColourTexture());
  const { material } = lines.object;
  for (const shown of [net, smaller]) {
    const data = dataOf(shown);
    data.putInto(uniforms);
    lines.setNet(data, stripTriangles(shown.info.edges));
    expect(lines.object.material).toBe(material);
    expect(material.uniforms.vertices!.value).toHaveProperty('image.data', data.points);
    expect(lines.object.geometry.index!.count).toBe(6 * shown.info.edges);
  }
});
