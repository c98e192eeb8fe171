/** A Vite plugin that tells the service worker what the page consists of. */
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';

const SERVICE_WORKER = 'service_worker.js';
/** The whole core is smaller. Larger files belong to parts that few visitors use: they are kept when they are first asked for. */
const LARGEST_KEPT_AT_ONCE = 2e6;

export function offline(): Plugin {
  return {
    name: 'offline',
    apply: 'build',
    config: () => ({
      build: {
        rollupOptions: {
          input: { service_worker: 'src/offline/service_worker.ts' },
          output: {
            entryFileNames: ({ name }) => (name === 'service_worker' ? SERVICE_WORKER : 'assets/[name]-[hash].js'),
          },
        },
      },
    }),
    writeBundle: {
      order: 'post',
      handler: ({ dir = 'dist' }) => putInto(dir, filesIn(dir)),
    },
  };
}

function filesIn(folder: string): string[] {
  const all = readdirSync(folder, { recursive: true, encoding: 'utf8' }).map((path) => path.replaceAll('\\', '/'));
  return all.filter((path) => path !== SERVICE_WORKER && statSync(join(folder, path)).isFile()).sort();
}

function putInto(folder: string, files: string[]): void {
  const isSmall = (path: string) => statSync(join(folder, path)).size <= LARGEST_KEPT_AT_ONCE;
  const hash = (data: string | Buffer) => createHash('sha256').update(data).digest('base64');
  const now = Object.fromEntries(
    files.filter(isSmall).map((path) => [path, `sha256-${hash(readFileSync(join(folder, path)))}`]),
  );
  const later = files.filter((path) => !isSmall(path));
  const contents = { version: hash(JSON.stringify([now, later])), now, later };
  const worker = join(folder, SERVICE_WORKER);
  writeFileSync(
    worker,
    readFileSync(worker, 'utf8').replace('__CONTENTS__', () => JSON.stringify(contents)),
  );
}
