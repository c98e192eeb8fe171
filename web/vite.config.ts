import { defineConfig } from 'vite';
import { offline } from './offline.ts';
import { leanThree, plasma } from './page_parts.ts';

export default defineConfig({
  // Relative addresses, so that the built page can be put into any folder of any site.
  base: './',
  plugins: [leanThree(), plasma(), offline()],
  // The facade and the wasm module lie beside this folder.
  server: { fs: { allow: ['.', '../wasm', '../build/wasm', '../tests'] } },
  worker: { format: 'es' },
  // three.js alone is above the usual limit, and the page shows nothing without it.
  build: { target: 'es2022', assetsInlineLimit: 0, chunkSizeWarningLimit: 1000 },
});
