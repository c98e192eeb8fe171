/** Changes one net and reports progress: the changing worker's part without the worker. */
import type { ChangedMesh, Chebnet } from '../../../wasm/chebnet';
import { codeOf, messageOf } from '../failure';
import type { ChangedNet, ChangeRequest, ChangeResponse } from './change_protocol';
import { centreOf, scaled } from './scaled';

/** Milliseconds between two pieces of news; one iteration is the least. */
const SLICE = 80;

export function changeNet(core: Chebnet, request: ChangeRequest, post: (response: ChangeResponse) => void): void {
  try {
    post({ type: 'ended', changed: changedNet(core, request, (iterations) => post({ type: 'news', iterations })) });
  } catch (error) {
    post({ type: 'error', code: codeOf(error), message: messageOf(error) });
  }
}

function changedNet(core: Chebnet, request: ChangeRequest, news: (iterations: number) => void): ChangedNet | null {
  const changed = changedFaces(core, request);
  const { mesh, origins } = changed;
  const found = exactPositions(core, request, changed, news);
  if (found === null) return null;
  const exact = { ...mesh, positions: found.positions };
  const editor = core.openMesh(exact);
  const pieces = editor.info.components;
  editor.dispose();
  return { mesh: exact, origins, pieces, sharp: found.sharp };
}

function changedFaces(core: Chebnet, { mesh, way, place, factor }: ChangeRequest): ChangedMesh {
  if (way !== 'resize') return core.change(mesh, way, place);
  const positions = scaled(mesh.positions, factor, centreOf(mesh.positions));
  const origins = Int32Array.from({ length: positions.length / 3 }, (_, vertex) => vertex);
  return { mesh: { ...mesh, positions }, origins, lengthFactor: factor, keepsEdges: true };
}

/** Null: no net is found near this shape whose edges have one length. */
function exactPositions(
  core: Chebnet,
  { length, held, shearLimit }: ChangeRequest,
  changed: ChangedMesh,
  news: (iterations: number) => void,
): { positions: Float64Array; sharp: boolean } | null {
  const exact = core.exactChange(changed, { length, held, ...(shearLimit !== undefined && { shearLimit }) });
  try {
    for (;;) {
      const { status, iterations } = exact.solve({ milliseconds: SLICE });
      if (status === 'converged' || status === 'exact')
        return { positions: exact.positions(), sharp: status === 'exact' };
      if (status !== 'running') return null;
      news(iterations);
    }
  } finally {
    exact.dispose();
  }
}
