// The table of `surfaces` in this folder, which builds what this needs.
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { loadChebnet } from '../../wasm/chebnet.js';

const ROOT = new URL('../../', import.meta.url);
const PROGRAM = fileURLToPath(new URL('build/native/chebnet', ROOT));
const READ = /\.(obj|ply|off|stl)$/i;

const { values, positionals } = parseArgs({
  options: { cells: { type: 'string', default: '4000' }, only: { type: 'string', default: '' } },
  allowPositionals: true,
});
const cells = Number(values.cells);
const chebnet = await loadChebnet({ wasmBinary: readFileSync(new URL('build/wasm/chebnet_core.wasm', ROOT)) });

/** Where the net comes from: how the program is asked for it, and what the module does. */
const WAYS = [
  { name: 'drape', args: ['drape'], run: (surface) => surface.drape(surface.suggest(cells)) },
  {
    name: 'drape, best',
    args: ['drape', '--best'],
    run: (surface) => {
      const { length } = surface.suggest(cells);
      return surface.drape({ length, ...surface.propose({ length })[0] });
    },
  },
  { name: 'remesh', args: ['remesh'], run: (surface) => surface.remesh({ cells }) },
];

const COLUMNS = [
  ['surface', 20],
  ['way', 12],
  ['cells', 6],
  ['native ms', 10],
  ['wasm ms', 9],
  ['ratio', 6],
  ['covered', 8],
  ['mean/L', 8],
  ['largest/L', 10],
  ['angle', 6],
  ['> 30°', 7],
  ['singular', 9],
  ['max dL', 8],
];

/** Text to the left, numbers to the right. */
function line(cellsOfLine) {
  return COLUMNS.map(([, width], i) => {
    const text = String(cellsOfLine[i] ?? '');
    return i < 2 ? text.padEnd(width) : text.padStart(width);
  }).join(' ');
}

/** Our own, and the files of the folders. */
function surfaces() {
  const own = chebnet.ownSurfaces().map(({ name }) => ({
    name,
    args: ['--surface', name],
    open: () => chebnet.ownSurface(name),
  }));
  const foreign = positionals.flatMap((folder) =>
    readdirSync(folder)
      .filter((file) => READ.test(file))
      .sort()
      .map((file) => join(folder, file)),
  );
  const files = foreign.map((file) => ({
    name: basename(file),
    args: ['--repair', file],
    open: () => chebnet.openSurface(chebnet.repairMesh(chebnet.readMesh(readFileSync(file), file)).mesh),
  }));
  return [...own, ...files].filter(({ name }) => name.includes(values.only));
}

/** Without the tree, which both build beforehand. */
function natively(way, surface) {
  const args = [...way.args, ...surface.args, '--cells', String(cells)];
  const { status, stdout, stderr } = spawnSync(PROGRAM, args, { encoding: 'utf8', maxBuffer: 2 ** 26 });
  if (status !== 0 && status !== 1) throw new Error(stderr.trim());
  const { net, milliseconds } = JSON.parse(stdout);
  const { tree: _, ...phases } = milliseconds;
  return { net, ms: Object.values(phases).reduce((sum, each) => sum + each, 0) };
}

function inWebAssembly(way, surface) {
  const opened = surface.open();
  opened.nearest([0, 0, 0]); // makes the tree
  const start = performance.now();
  way.run(opened);
  const ms = performance.now() - start;
  opened.dispose();
  return ms;
}

console.log(line(COLUMNS.map(([name]) => name)));
for (const surface of surfaces())
  for (const way of WAYS) {
    try {
      const { net, ms } = natively(way, surface);
      const wasm = inWebAssembly(way, surface);
      console.log(
        line([
          surface.name,
          way.name,
          net.cells,
          ms.toFixed(0),
          wasm.toFixed(0),
          (wasm / ms).toFixed(1),
          `${(100 * net.coverage).toFixed(1)} %`,
          net.mean_distance_in_lengths.toFixed(4),
          net.largest_distance_in_lengths.toFixed(2),
          net.smallest_corner_angle_degrees.toFixed(2),
          `${(100 * net.cells_sheared_over_30_degrees).toFixed(1)} %`,
          net.singular_vertices ?? '',
          net.max_dL.toExponential(0),
        ]),
      );
    } catch (error) {
      console.log(line([surface.name, way.name]), error.message);
    }
  }
