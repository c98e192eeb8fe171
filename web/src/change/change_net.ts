/** Changes one net and reports progress: the changing worker's part without the worker. */
import type { ChangedMesh, Chebnet, EqualizeOptions, Mesh } from '../../../wasm/chebnet';
import { codeOf, messageOf } from '../failure';
import type { ChangedNet, ChangeRequest, ChangeResponse } from './change_protocol';

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
  const positions = request.length === null ? mesh.positions : exactPositions(core, request, changed, news);
  if (positions === null) return null;
  const exact = { ...mesh, positions };
  const editor = core.openMesh(exact);
  const pieces = editor.info.components;
  editor.dispose();
  return { mesh: exact, origins, pieces };
}

function changedFaces(core: Chebnet, { mesh, way, place, factor }: ChangeRequest): ChangedMesh {
  if (way !== 'resize') return core.change(mesh, way, place);
  const positions = scaled(mesh.positions, factor);
  const origins = Int32Array.from({ length: positions.length / 3 }, (_, vertex) => vertex);
  return { mesh: { ...mesh, positions }, origins, lengthFactor: factor, keepsEdges: true };
}

/** About their centre. */
function scaled(positions: Float64Array, factor: number): Float64Array {
  const centre = [0, 0, 0];
  positions.forEach((x, i) => (centre[i % 3]! += (3 * x) / positions.length));
  return positions.map((x, i) => centre[i % 3]! + factor * (x - centre[i % 3]!));
}

/** With handles held, or where no net is found so, with all of it free. */
function exactPositions(
  core: Chebnet,
  { length, held, shearLimit }: ChangeRequest,
  { mesh, origins, lengthFactor, keepsEdges }: ChangedMesh,
  news: (iterations: number) => void,
): Float64Array | null {
  const options: EqualizeOptions = {
    length: length! * lengthFactor,
    ...(shearLimit !== undefined && { shearLimit }),
    // Nothing but lost digits is to be found.
    ...(keepsEdges && { method: 'projection' }),
  };
  const handles = held.map((vertex) => origins.indexOf(vertex)).filter((vertex) => vertex >= 0);
  return (
    (handles.length > 0 ? solved(core, mesh, { ...options, handles }, news) : null) ?? solved(core, mesh, options, news)
  );
}

function solved(
  core: Chebnet,
  mesh: Mesh,
  options: EqualizeOptions,
  news: (iterations: number) => void,
): Float64Array | null {
  const equalizer = core.equalizer(mesh, options);
  try {
    for (;;) {
      const { status, iterations } = equalizer.solve({ milliseconds: SLICE });
      if (status !== 'running') return status === 'converged' ? equalizer.positions() : null;
      news(iterations);
    }
  } finally {
    equalizer.dispose();
  }
}
