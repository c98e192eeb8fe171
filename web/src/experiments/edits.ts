/** Edits as the solver takes them. Their meshes come when they are asked for. */
import type { HandleSeed, NetSource } from '../document/document';
import { type Edit, EDITS, fileNameOf } from './figures';

const MESHES = import.meta.glob<string>('./meshes/*.obj', { query: '?raw', import: 'default' });

export interface EditScene {
  net: NetSource;
  handles: HandleSeed[];
}

/** @param atRest nothing is moved yet. */
export async function editScene(name: string, atRest = false): Promise<EditScene> {
  const { net, handles } = EDITS[name]!;
  return { net: await netOf(net), handles: handles.map((handle) => seedOf(handle, atRest)) };
}

async function netOf(net: Edit['net']): Promise<NetSource> {
  if ('recipe' in net) return net;
  const name = fileNameOf(net.mesh);
  return { obj: await MESHES[`./meshes/${name}`]!(), name };
}

function seedOf(handle: Edit['handles'][number], atRest: boolean): HandleSeed {
  if (typeof handle === 'number') return { vertex: handle, target: null, anchor: true };
  const [vertex, ...target] = handle;
  return { vertex, target: atRest ? null : target, anchor: false };
}
