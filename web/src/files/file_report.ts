/** The report on a file that is shown before it is opened. */
import type { Chebnet, Editor, Finding, Mesh, NetInfo, SurfaceReport } from '../../../wasm/chebnet';
import type { UpAxis } from '../document/document';
import { type Posture, postureOf } from './posture';

export interface FileReport extends NetInfo {
  /** What repair changes; the numbers above are those of the repaired mesh. Empty: it is sound as it is. */
  findings: Finding[];
  /** Why the core refuses the mesh without repair, with its code; null: it does not. */
  refusal: Refusal | null;
  /** The repaired mesh as a surface to make nets on, or why it is none; null: it is a net beyond doubt. */
  surface: SurfaceReport | Refusal | null;
  posture: Posture;
}

interface Refusal {
  code: string;
  message: string;
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

/** Throws ChebnetError if even the repaired mesh is no net.
 *  @param up the axis that points up, where the file says so. */
export function reportOf(core: Chebnet, { given, repaired, findings }: CheckedMesh, up?: UpAxis): FileReport {
  const posture = postureOf(repaired);
  const info = withEditor(core, repaired, (editor) => editor.info);
  return {
    ...info,
    findings,
    refusal: findings.length > 0 ? orRefusal(() => withEditor(core, given, () => null)) : null,
    surface: isNetBeyondDoubt(info) ? null : orRefusal(() => surfaceReport(core, repaired)),
    posture: up === undefined ? posture : { ...posture, up, isClear: true },
  };
}

/** Whether most faces are triangles: whoever brings such a mesh means a surface. */
export function isMostlyTriangles({ facesByArity, faces }: Pick<NetInfo, 'facesByArity' | 'faces'>): boolean {
  return 2 * (facesByArity[3] ?? 0) > faces;
}

function isNetBeyondDoubt({ isChebyshev, facesByArity }: NetInfo): boolean {
  return isChebyshev && facesByArity[3] === undefined;
}

function surfaceReport(core: Chebnet, mesh: Mesh): SurfaceReport {
  const surface = core.openSurface(mesh);
  try {
    return surface.describe();
  } finally {
    surface.dispose();
  }
}

/** What `look` gives, or why the core refuses. */
function orRefusal<T>(look: () => T): T | Refusal {
  try {
    return look();
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
