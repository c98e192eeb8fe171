/**
 * A Vite plugin for workers: what an entry shares with a chunk that it loads later gets a chunk of its own. Left to
 * itself, the bundler lets such a chunk import from the entry; WebKit evaluates a worker's entry anew for that, in the same
 * global scope, where it takes the place of the first with all that this one holds.
 */
import type { Plugin } from 'vite';

export function entriesAlone(): Plugin {
  return {
    name: 'entries-alone',
    // An entry may then export only what its source exports. Vite's own `worker.rolldownOptions` cannot say it.
    options: (options) => ({ ...options, preserveEntrySignatures: 'strict' }),
  };
}
