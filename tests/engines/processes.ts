/** What the processes of a browser take, as the system counts it (Linux). */
import { readdirSync, readFileSync } from 'node:fs';

const PAGE = 4096;

/** Bytes in memory that this process's descendants, the browser, share with nobody: heaps of scripts, WebAssembly,
 *  textures and whatever else. The only count that there is in every engine. */
export function browserMemory(): number {
  const all = readdirSync('/proc').filter((name) => /^\d+$/.test(name));
  const parents = new Map(all.flatMap((id) => parentOf(id) ?? []));
  const isOurs = (id: string): boolean => {
    const parent = parents.get(id);
    return parent !== undefined && (parent === String(process.pid) || isOurs(parent));
  };
  return all.filter(isOurs).reduce((sum, id) => sum + privateMemory(id), 0);
}

function parentOf(id: string): [[string, string]] | null {
  const parent = /^PPid:\s*(\d+)/m.exec(read(`/proc/${id}/status`))?.[1];
  return parent === undefined ? null : [[id, parent]];
}

function privateMemory(id: string): number {
  const [, resident = 0, shared = 0] = read(`/proc/${id}/statm`).split(' ').map(Number);
  return (resident - shared) * PAGE;
}

/** Empty: it has ended meanwhile. */
function read(path: string): string {
  try {
    return readFileSync(path, 'utf8');
  } catch {
    return '';
  }
}
