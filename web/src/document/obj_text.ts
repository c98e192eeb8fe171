/** Meshes as text, for links and project files. */
import type { Mesh } from '../../../wasm/chebnet';

/** OBJ text with the fewest digits that restore every coordinate, since links carry it; the core's writer always uses 17. */
export function objText({ positions, faceStart, faceVertices }: Mesh): string {
  const lines: string[] = [];
  for (let i = 0; i < positions.length; i += 3) lines.push(`v ${positions.subarray(i, i + 3).join(' ')}`);
  for (let f = 0; f + 1 < faceStart.length; ++f) {
    const face = faceVertices.subarray(faceStart[f], faceStart[f + 1]);
    lines.push(`f ${face.map((vertex) => vertex + 1).join(' ')}`);
  }
  return [...lines, ''].join('\n');
}
