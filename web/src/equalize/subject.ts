/** The net to be equalised, and the scene with the result. */
import type { FormatInfo, Mesh } from '../../../wasm/chebnet';
import { remade } from '../document/defaults';
import type { ChebnetDocument, GuideSource, Scene } from '../document/document';
import { fileNameOf } from '../files/file_name';
import type { OpenedNet } from '../worker/protocol';

export interface Subject {
  /** Its name for the user. */
  name: string;
  net: OpenedNet;
  positions: Float64Array;
  /** Vertices that the user may want to fix. */
  handles: number[];
  /** A surface beside it. */
  guide?: GuideSource | undefined;
}

/** What becomes of it. */
export interface Equalized {
  mesh: Mesh;
  /** Of the original, as large as the net; null if its faces are no surface, or the net is near the one beside it. */
  surface: Mesh | null;
  /** Whether the net was given another size. */
  isResized: boolean;
}

export function subjectOfNet(document: ChebnetDocument, net: OpenedNet, formats: readonly FormatInfo[]): Subject {
  return {
    name: fileNameOf(document.net, 'obj', formats),
    net,
    positions: document.positions ?? net.restPositions,
    // Soft handles fix nothing.
    handles: document.handles.filter(({ weight }) => !weight).map(({ vertex }) => vertex),
    guide: document.guide,
  };
}

/** The scene of the net that was open, with what has become of it for its net: handles stay at their vertices, where
 *  these stand now. A surface that was beside it stays, if it fits. */
export function equalizedScene(
  document: ChebnetDocument,
  { mesh, surface, isResized }: Equalized,
  formats: readonly FormatInfo[],
): Scene {
  const handles = document.handles.map((handle) => ({ ...handle, target: null }));
  const name = fileNameOf(document.net, 'obj', formats);
  const guide = surface === null ? undefined : { mesh: surface, name };
  return {
    ...remade(document, { mesh, name }, handles),
    guide: isResized ? guide : (document.guide ?? guide),
  };
}
