/** The built page as a test wants it. */
import { createHash } from 'node:crypto';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { DIST } from '../browser/site';
import { newFolder } from './temporary';

/** With a function that runs before all scripts of the page; it may use nothing from around it. No driver of WebKit can
 *  bring one in. */
export function preparedBy(code: () => void): { path: string; remove(): void } {
  const folder = newFolder();
  cpSync(DIST, folder.path, { recursive: true });
  writeFileSync(join(folder.path, 'before.js'), `(${code})();`);
  const page = join(folder.path, 'index.html');
  const html = readFileSync(page, 'utf8');
  const prepared = html.replace('<head>', '<head><script src="./before.js"></script>');
  writeFileSync(page, prepared);
  const worker = join(folder.path, 'service_worker.js');
  writeFileSync(worker, readFileSync(worker, 'utf8').replace(sha256(html), sha256(prepared)));
  return folder;
}

function sha256(text: string): string {
  return createHash('sha256').update(text).digest('base64');
}
