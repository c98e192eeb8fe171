/** The report on a file that is shown before it is opened. */
import type { Chebnet, Editor, Finding, Mesh, NetInfo } from '../../../wasm/chebnet';
import { edgeLengths, spreadOf } from '../net/edge_lengths';
import type { LengthSpread } from '../net/edge_lengths';

export interface FileReport
  extends Pick<NetInfo, 'vertices' | 'edges' | 'faces' | 'boundaryLoops' | 'components' | 'singularVertices'> {
  /** Number of corners → how many faces. */
  facesByArity: Record<string, number>;
  lengths: LengthSpread;
  /** All edges have the same length, up to rounding. */
  isChebyshev: boolean;
  /** What repair changes; the numbers above are those of the repaired mesh. Empty: it is sound as it is. */
  findings: Finding[];
  /** Why the core refuses the mesh without repair, with its code; null: it does not. */
  refusal: { code: string; message: string } | null;
}

/** A mesh as the file has it, and as the core repairs it; the same if nothing was found. */
export interface CheckedMesh {
  given: Mesh;
  repaired: Mesh;
  findings: Finding[];
}

export function checkMesh(core: Chebnet, given: Mesh): CheckedMesh {
  const { mesh, findings } = core.repairMesh(given);
  return { given, repaired: findings.length > 0 ? mesh : given, findings };
}

/** Throws ChebnetError if even the repaired mesh is no net. */
export function reportOf(core: Chebnet, { given, repaired, findings }: CheckedMesh): FileReport {
  const measured = withEditor(core, repaired, measure);
  return {
    ...measured,
    facesByArity: countArities(repaired),
    findings,
    refusal: findings.length > 0 ? refusalOf(core, given) : null,
  };
}

function measure({ info, edges, restPositions }: Editor): Omit<FileReport, 'facesByArity' | 'findings' | 'refusal'> {
  const { vertices, edges: edgeCount, faces, boundaryLoops, components, singularVertices, isChebyshev } = info;
  const lengths = spreadOf(edgeLengths(restPositions, edges));
  return { vertices, edges: edgeCount, faces, boundaryLoops, components, singularVertices, isChebyshev, lengths };
}

function countArities({ faceStart }: Mesh): Record<string, number> {
  const counts: Record<string, number> = {};
  for (let f = 0; f + 1 < faceStart.length; ++f) {
    const arity = (faceStart[f + 1] ?? NaN) - (faceStart[f] ?? NaN);
    counts[arity] = (counts[arity] ?? 0) + 1;
  }
  return counts;
}

function refusalOf(core: Chebnet, mesh: Mesh): FileReport['refusal'] {
  try {
    return withEditor(core, mesh, () => null);
  } catch (error) {
    if (error instanceof Error && 'code' in error) return { code: String(error.code), message: error.message };
    throw error;
  }
}

/** Calls `look` with an editor of the mesh. Throws ChebnetError if it is no net. */
export function withEditor<T>(core: Chebnet, mesh: Mesh, look: (editor: Editor) => T): T {
  const editor = core.openMesh(mesh);
  try {
    return look(editor);
  } finally {
    editor.dispose();
  }
}
