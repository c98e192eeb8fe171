/**
 * A Vite plugin: what tells of a missing origin stands in the document itself. Without an origin no browser loads modules, and
 * WebKit no script of the site at all. The page's content security policy admits this text alone, by its hash.
 */
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import type { Plugin } from 'vite';

const SCRIPT = new URL('src/embed/no_origin.js', import.meta.url);
const ADMITTED = "script-src 'self'";

export function noOriginInline(): Plugin {
  return {
    name: 'no-origin-inline',
    transformIndexHtml: {
      order: 'post',
      handler: (html, { path }) => {
        if (path !== '/index.html') return [];
        if (!html.includes(ADMITTED)) throw new Error('the policy of the page has no place for a hash');
        const script = readFileSync(SCRIPT, 'utf8');
        const hash = createHash('sha256').update(script).digest('base64');
        return {
          html: html.replace(ADMITTED, `${ADMITTED} 'sha256-${hash}'`),
          tags: [{ tag: 'script', children: script, injectTo: 'body' }],
        };
      },
    },
  };
}
