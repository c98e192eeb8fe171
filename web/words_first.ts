/**
 * A Vite plugin: the words of the visitor's language are asked for at once. As a part that is chosen while the page starts,
 * they would come a round trip after all else. See public/words_first.js.
 */
import type { Plugin } from 'vite';

const LANGUAGES = ['en', 'zh'];

export function wordsFirst(): Plugin {
  return {
    name: 'words-first',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler: (_, { bundle = {}, path }) => {
        if (path !== '/index.html') return [];
        const chunks = Object.values(bundle).filter((each) => each.type === 'chunk');
        const chunkOf = (language: string) => {
          const chunk = chunks.find(({ facadeModuleId }) => facadeModuleId?.endsWith(`/src/language/${language}.ts`));
          if (chunk === undefined) throw new Error(`the words of "${language}" have no chunk of their own`);
          return [`data-${language}`, `./${chunk.fileName}`] as const;
        };
        const attrs = { src: './words_first.js', ...Object.fromEntries(LANGUAGES.map(chunkOf)) };
        return [{ tag: 'script', attrs, injectTo: 'head' }];
      },
    },
  };
}
