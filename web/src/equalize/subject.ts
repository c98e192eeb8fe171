/** The net to be equalised, and the scene with the result. */
import type { FormatInfo, Mesh } from '../../../wasm/chebnet';
import type { ChebnetDocument, Scene } from '../document/document';
import { fileNameOf } from '../document/file_name';
import type { OpenedNet } from '../worker/protocol';

export interface Subject {
  /** Its name for the user. */
  name: string;
  net: OpenedNet;
  positions: Float64Array;
  /** Vertices that the user may want to fix. */
  handles: number[];
}

export function subjectOfNet(document: ChebnetDocument, net: OpenedNet, formats: readonly FormatInfo[]): Subject {
  return {
    name: fileNameOf(document.net, 'obj', formats),
    net,
    positions: document.positions ?? net.restPositions,
    // Soft handles fix nothing.
    handles: document.handles.filter(({ weight }) => !weight).map(({ vertex }) => vertex),
  };
}

/** The scene of the net that was open, with `mesh` for its net: handles stay at their vertices, where these stand now. */
export function equalizedScene(document: ChebnetDocument, mesh: Mesh, formats: readonly FormatInfo[]): Scene {
  const handles = document.handles.map((handle) => ({ ...handle, target: null }));
  const net = { mesh, name: fileNameOf(document.net, 'obj', formats) };
  return {
    ...document,
    net,
    numbering: undefined,
    handles,
    positions: null,
    settled: true,
    experiment: undefined,
    compare: undefined,
  };
}
