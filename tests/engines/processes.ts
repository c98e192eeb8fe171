/** What the processes of a browser take, as the system counts it (Linux). */
import { readdirSync, readFileSync } from 'node:fs';

const PAGE = 4096;

/** Command lines of processes that run pages: heaps of scripts and WebAssembly are theirs. */
const RUNS_PAGES = /--type=renderer|-contentproc.*\btab\b|WebKitWebProcess/;

/** Bytes in memory that this process's descendants, the browser, share with nobody. The only count that there is in every
 *  engine. `pages`: of those that run pages; `all`: with what draws them, and what the browser keeps for itself. */
export function browserMemory(): { pages: number; all: number } {
  const ours = descendants().map((id) => ({
    bytes: privateMemory(id),
    runsPages: RUNS_PAGES.test(read(`/proc/${id}/cmdline`)),
  }));
  const sum = (list: typeof ours) => list.reduce((bytes, each) => bytes + each.bytes, 0);
  return { pages: sum(ours.filter(({ runsPages }) => runsPages)), all: sum(ours) };
}

function descendants(): string[] {
  const all = readdirSync('/proc').filter((name) => /^\d+$/.test(name));
  const parents = new Map(all.flatMap((id) => parentOf(id) ?? []));
  const isOurs = (id: string): boolean => {
    const parent = parents.get(id);
    return parent !== undefined && (parent === String(process.pid) || isOurs(parent));
  };
  return all.filter(isOurs);
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
