/**
 * uPlot writes numbers in the language of the browser, whatever the page speaks; and where a browser names none that exists,
 * as WebKitGTK does by `C` under that locale, it does not even load. This plugin lets it ask the page. If another version of
 * uPlot asks otherwise, the build fails.
 */
import type { Plugin } from 'vite';

const QUESTION = 'nav.language';

export function plotsInPageLanguage(): Plugin {
  return {
    name: 'plots-in-page-language',
    // While developing, it would be bundled beforehand, past this.
    config: () => ({ optimizeDeps: { exclude: ['uplot'] } }),
    transform: { filter: { id: /uPlot\.esm\.js/ }, handler: inPageLanguage },
  };
}

export function inPageLanguage(code: string): string {
  if (code.split(QUESTION).length !== 2)
    throw new Error('uPlot asks for the language in another way; see plots_in_page_language.ts');
  return code.replace(QUESTION, 'document.documentElement.lang');
}
