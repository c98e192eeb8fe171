/** What a document keeps of a mesh. */
import type { Mesh } from '../../../wasm/chebnet';

/** OBJ text in as few digits as bring every coordinate back, for a link has to carry it; the core's writer spends 17. */
export function objText({ positions, faceStart, faceVertices }: Mesh): string {
  const lines: string[] = [];
  for (let i = 0; i < positions.length; i += 3) lines.push(`v ${positions.subarray(i, i + 3).join(' ')}`);
  for (let f = 0; f + 1 < faceStart.length; ++f) {
    const face = faceVertices.subarray(faceStart[f], faceStart[f + 1]);
    lines.push(`f ${face.map((vertex) => vertex + 1).join(' ')}`);
  }
  return [...lines, ''].join('\n');
}
