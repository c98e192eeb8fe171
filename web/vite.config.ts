import { defineConfig } from 'vite';
import { entriesAlone } from './entries_alone.ts';
import { galleryPictures } from './gallery_pictures.ts';
import { licences } from './licences.ts';
import { noOriginInline } from './no_origin_inline.ts';
import { offline } from './offline.ts';
import { leanThree } from './lean_three.ts';
import { plasma } from './plasma.ts';
import { plotsInPageLanguage } from './plots_in_page_language.ts';
import { rhino3dmWithoutEval } from './rhino3dm_without_eval.ts';
import { stylesWhileDeveloping } from './styles_while_developing.ts';
import { wordsFirst } from './words_first.ts';

const licenceTexts = licences();

/** Each entry runs as soon as it is imported, by whatever else would lie in its file. */
const ENTRY = /\.html$|\/(main|service_worker|lesson)\.\w+$/;
/** What the page needs first is one file: in the forty parts that its later parts would share, it is 8 kB larger when
 *  compressed. What it has in common with the lesson has a file of its own. */
const FIRST_LOAD = [
  { name: 'common', test: /src\/language\/choice|preload-helper/, priority: 1 },
  { name: 'first', test: (id: string) => !ENTRY.test(id), tags: ['$initial' as const] },
];

export default defineConfig({
  // Relative addresses, so that the built page can be put into any folder of any site.
  base: './',
  plugins: [
    leanThree(),
    plasma(),
    galleryPictures(),
    plotsInPageLanguage(),
    wordsFirst(),
    noOriginInline(),
    stylesWhileDeveloping(),
    licenceTexts.page,
    offline(),
  ],
  // The facade and the wasm module lie beside this folder.
  server: { fs: { allow: ['.', '../wasm', '../build/wasm', '../tests'] } },
  // Its main file is no module.
  resolve: { alias: [{ find: /^rhino3dm$/, replacement: 'rhino3dm/rhino3dm.module.js' }] },
  worker: { format: 'es', plugins: () => [rhino3dmWithoutEval(), entriesAlone(), licenceTexts.worker] },
  // three.js alone is above the usual limit, and the page shows nothing without it.
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1000,
    // Browsers that do not know modulepreload load the same a little later.
    modulePreload: { polyfill: false },
    rollupOptions: {
      input: { index: 'index.html', lesson: 'lesson.html' },
      output: { codeSplitting: { groups: FIRST_LOAD } },
      // A slow machine makes the pictures of the gallery for seconds, which is no fault.
      checks: { pluginTimings: false },
    },
  },
});
