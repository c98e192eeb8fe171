/** Names what is being opened without a question, a link or a kept project, until it has settled or the page is left in good
 *  order. A flag that is still set when the page starts, while no other tab opens the same, means that opening it crashed the
 *  page. */
import { claim, heldLocks, lockOf, release } from './kept';

const KEY = 'chebnet.opening';

/** What this tab is opening; null: nothing. */
let opening: { what: string } | null = null;
/** The flag that this tab set last: others are those of other tabs. */
let written: string | null = null;

/** Returns what clears it, which does nothing if something else is being opened by then. */
export function setCrashFlag(what: string): () => void {
  end();
  const mine = (opening = { what });
  addEventListener('pagehide', leave);
  addEventListener('pageshow', comeBack);
  begin(what);
  return () => {
    if (opening === mine) clearCrashFlag();
  };
}

/** Its worker has crashed: the flag stays when the page is left. */
export function setLossFlag(what: string): void {
  end();
  write(what);
}

export function clearCrashFlag(): void {
  end();
  removeOwn();
}

export async function hasCrashFlag(what: string): Promise<boolean> {
  try {
    return localStorage.getItem(KEY) === what && !(await heldLocks()).has(lockOf(lockFor(what)));
  } catch {
    return false;
  }
}

/** One for each thing that can be opened: after a crash of the browser tabs come back together, and what one of them opens
 *  tells nothing of the others. Of long links the end, in which they differ. */
function lockFor(what: string): string {
  return `opening ${what.slice(-999)}`;
}

function begin(what: string): void {
  void claim(lockFor(what), 'shared');
  write(what);
}

/** Nothing is being opened any more. */
function end(): void {
  if (opening !== null) release(lockFor(opening.what));
  opening = null;
  removeEventListener('pagehide', leave);
  removeEventListener('pageshow', comeBack);
}

/** It may never come back. */
function leave(): void {
  if (opening !== null) release(lockFor(opening.what));
  removeOwn();
}

/** As it was left, with what was being opened. */
function comeBack({ persisted }: PageTransitionEvent): void {
  if (persisted && opening !== null) begin(opening.what);
}

function write(what: string): void {
  written = what;
  try {
    localStorage.setItem(KEY, what);
  } catch {
    // Storage is disabled: then nothing is kept that could open by itself.
  }
}

function removeOwn(): void {
  try {
    if (localStorage.getItem(KEY) === written) localStorage.removeItem(KEY);
  } catch {
    // As above.
  }
}
