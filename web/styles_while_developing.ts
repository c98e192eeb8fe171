/**
 * A Vite plugin: while developing, Vite puts styles that a script imports into the page as text, which the page's content
 * security policy forbids. The built page has them in files.
 */
import type { Plugin } from 'vite';

export function stylesWhileDeveloping(): Plugin {
  return {
    name: 'styles-while-developing',
    apply: 'serve',
    transformIndexHtml: (html) => html.replace("style-src 'self'", "style-src 'self' 'unsafe-inline'"),
  };
}
