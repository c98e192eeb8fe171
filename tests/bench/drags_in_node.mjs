// The table of `drags` in this folder, in Node, with the WebAssembly module that the page uses; and of `equilibrium` what is
// asked of it: what must be, what is aimed at, and what came of it.
import { readFileSync } from 'node:fs';
import { loadChebnet } from '../../wasm/chebnet.js';

const ROOT = new URL('../../', import.meta.url);
const DEGREES = 180 / Math.PI;
/** Of which more is asked than of the others, and the method that it is compared with. */
const [ASKED, OTHER] = ['equilibrium', 'li2022'];

const { methods, frames, tasks } = JSON.parse(readFileSync(0, 'utf8'));
const chebnet = await loadChebnet({ wasmBinary: readFileSync(new URL('build/wasm/chebnet_core.wasm', ROOT)) });

function quantile(numbers, q) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const place = q * (sorted.length - 1);
  const below = Math.floor(place);
  const above = Math.min(below + 1, sorted.length - 1);
  return sorted[below] + (place - below) * (sorted[above] - sorted[below]);
}
const largest = (numbers) => numbers.reduce((most, each) => Math.max(most, each), -Infinity);
const smallest = (numbers) => -largest(numbers.map((each) => -each));

function timed(what) {
  const start = performance.now();
  const result = what();
  return [result, performance.now() - start];
}

/** How far each vertex is from where it was. */
function distances(a, b) {
  return Array.from({ length: a.length / 3 }, (_, v) =>
    Math.hypot(a[3 * v] - b[3 * v], a[3 * v + 1] - b[3 * v + 1], a[3 * v + 2] - b[3 * v + 2]),
  );
}

/** Handles of a net on their way from rest to their targets, moved as a hand does, by one method. */
class Drag {
  constructor({ net, handles }, method) {
    this.editor = net.endsWith('.obj') ? chebnet.openObj(readFileSync(net, 'utf8'), net) : chebnet.openRecipe(net);
    this.editor.setMethod(method);
    this.ways = handles.map(({ vertex, target }) => {
      const rest = Array.from(this.editor.restPositions.subarray(3 * vertex, 3 * vertex + 3));
      return { vertex, rest, target };
    });
    /** The farthest that a handle goes, in all frames together. */
    this.hand = largest(this.ways.map(({ rest, target }) => Math.hypot(...target.map((to, k) => to - rest[k]))));
  }

  begin() {
    this.editor.setHandles(this.ways.map(({ vertex, rest }) => ({ vertex, target: rest })));
    this.editor.reset();
    this.settle();
    return this;
  }

  /** Solves until it ends. */
  settle() {
    return this.editor.solve();
  }

  /** All handles at once at their targets, of a net for which nothing has been prepared. */
  solveCold() {
    this.editor.setHandles(this.ways.map(({ vertex, target }) => ({ vertex, target })));
    return this.settle();
  }

  /** Handles go to a part of their way, for one frame: until the net has its lengths, or the solve ends. */
  frame(part) {
    for (const { vertex, rest, target } of this.ways)
      this.editor.moveHandle(
        vertex,
        rest.map((from, k) => from + part * (target[k] - from)),
      );
    const threshold = this.editor.options().threshold;
    let report = this.editor.solve({ iterations: 1 });
    while (report.status === 'running' && !(report.maxDeviation < threshold))
      report = this.editor.solve({ iterations: 1 });
    return report;
  }

  positions() {
    return this.editor.positions();
  }

  angle() {
    return this.editor.smallestAngle() * DEGREES;
  }

  /** Root mean square distance, in edge lengths. */
  rmsFrom(positions) {
    const squares = distances(this.positions(), positions).map((each) => each ** 2);
    return Math.sqrt(squares.reduce((sum, each) => sum + each, 0) / squares.length) / this.editor.info.meanLength;
  }

  end() {
    this.editor.dispose();
  }
}

function dragTo(from, to, drag, row) {
  for (let k = 1; k <= frames; ++k) {
    const before = drag.positions();
    const [report, ms] = timed(() => drag.frame(from + ((to - from) * k) / frames));
    row.frameMs.push(ms);
    row.kicks.push(largest(distances(drag.positions(), before)) / ((drag.hand * Math.abs(to - from)) / frames));
    row.frameDeviation = Math.max(row.frameDeviation, report.maxDeviation);
    row.frameAngle = Math.min(row.frameAngle, drag.angle());
  }
}

/** WebAssembly takes time when it first runs. */
function warmUp() {
  for (const method of methods) {
    const drag = new Drag(tasks[0], method);
    drag.solveCold();
    drag.end();
  }
}

function measureCold(task, method, row) {
  const cold = new Drag(task, method);
  [, row.coldMs] = timed(() => cold.solveCold());
  cold.end();
}

/** Lengths in edge lengths, angles in degrees; of the slow drag unless said otherwise. */
function measure(task, method) {
  const row = { edit: task.edit, method, frameMs: [], kicks: [], frameDeviation: 0, frameAngle: 180 };
  measureCold(task, method, row);
  const slow = new Drag(task, method).begin();
  const start = slow.positions();
  row.vertices = slow.editor.info.vertices;
  row.handStep = slow.hand / frames / slow.editor.info.meanLength;
  dragTo(0, 1, slow, row);
  const [{ status, iterations, maxDeviation }, restMs] = timed(() => slow.settle());
  Object.assign(row, { status, restMs, restIterations: iterations, deviation: maxDeviation, angle: slow.angle() });
  row.bend = slow.editor.bend();

  const jump = new Drag(task, method).begin();
  [, row.jumpMs] = timed(() => {
    jump.frame(1);
    jump.settle();
  });
  row.path = slow.rmsFrom(jump.positions());
  jump.end();

  dragTo(1, 0, slow, row);
  slow.settle();
  row.wayBack = slow.rmsFrom(start);
  slow.end();
  return row;
}

const line = (cells) => `| ${cells.join(' | ')} |`;

/** The same columns as those of the native table. */
const COLUMNS = [
  ['edit', ({ edit }) => edit],
  ['method', ({ method }) => method],
  ['V', ({ vertices }) => vertices],
  [
    'frame ms: median, 95 %, largest',
    ({ frameMs }) => [0.5, 0.95, 1].map((q) => quantile(frameMs, q).toFixed(1)).join(', '),
  ],
  ['dL in a frame, settled', (row) => `${row.frameDeviation.toExponential(0)}, ${row.deviation.toExponential(0)}`],
  ['angle in a frame, settled', ({ frameAngle, angle }) => `${frameAngle.toFixed(2)}, ${angle.toFixed(2)}`],
  ['kick 95 %', ({ kicks }) => quantile(kicks, 0.95).toFixed(2)],
  ['return', ({ wayBack }) => wayBack.toFixed(4)],
  ['path', ({ path }) => path.toFixed(4)],
  ['bend', ({ bend }) => bend.toFixed(4)],
  ['to rest: iterations, ms', ({ restIterations, restMs }) => `${restIterations}, ${restMs.toFixed(0)}`],
  ['jump ms', ({ jumpMs }) => jumpMs.toFixed(0)],
  ['cold ms', ({ coldMs }) => coldMs.toFixed(0)],
  ['', ({ status }) => status],
];

// ---------------------------------------------------------------------------------------------------- what is asked of it

/** Nets of up to so many vertices and more than the size before: milliseconds of a frame, median and largest, and from
 *  release to rest; each as it must be, and as is aimed at. */
const SIZES = [
  { vertices: 4000, median: [10, 6], largest: [30, 12], rest: [400, 150] },
  { vertices: 8700, median: [20, 12], largest: [60, 24], rest: [1200, 400] },
  { vertices: 20_000, median: [45, 30], largest: [120, 60] },
];

const atLeast = (value, bound) => value >= bound;
const atMost = (value, bound) => value <= bound;

/** Of an edit by both methods. */
function ratios(rows, number) {
  return rows.flatMap((row) => {
    const other = row.others.get(OTHER);
    return other === undefined ? [] : [number(row) / number(other)];
  });
}
const geometricMean = (numbers) => Math.exp(numbers.reduce((sum, each) => sum + Math.log(each), 0) / numbers.length);

function demandsOfSize({ vertices, ...times }, least, rows) {
  const ofSize = rows.filter((row) => row.vertices > least && row.vertices <= vertices);
  const medians = ofSize.map(({ frameMs }) => quantile(frameMs, 0.5));
  const name = `${(least + 1).toLocaleString('en')} … ${vertices.toLocaleString('en')} vertices`;
  return [
    [`ms of a frame, ${name}: median`, atMost, times.median, largest(medians)],
    [`ms of a frame, ${name}: largest`, atMost, times.largest, largest(ofSize.flatMap(({ frameMs }) => frameMs))],
    ...(times.rest ? [[`ms to rest, ${name}`, atMost, times.rest, largest(ofSize.map(({ restMs }) => restMs))]] : []),
  ];
}

/** What is asked, how it is compared with must and aim, and what is. */
function demands(rows) {
  const slowHand = rows.filter(({ handStep }) => handStep < 1);
  const bends = ratios(rows, ({ bend }) => bend);
  return [
    ['smallest corner, settled', atLeast, [30, 30], smallest(rows.map(({ angle }) => angle))],
    ['smallest corner, in any frame', atLeast, [29.5, 29.5], smallest(rows.map(({ frameAngle }) => frameAngle))],
    ['max dL, settled', atMost, [1e-9, 1e-12], largest(rows.map(({ deviation }) => deviation))],
    ['max dL, in any frame', atMost, [1e-6, 1e-9], largest(rows.map(({ frameDeviation }) => frameDeviation))],
    [`bend over that of ${OTHER}, geometric mean`, atMost, [0.5, 0.4], geometricMean(bends)],
    [`bend over that of ${OTHER}, largest`, atMost, [0.9, 0.7], largest(bends)],
    [
      'path, in 95 % of edits',
      atMost,
      [0.02, 0.001],
      quantile(
        rows.map(({ path }) => path),
        0.95,
      ),
    ],
    [
      'return, in 95 % of edits',
      atMost,
      [0.02, 0.001],
      quantile(
        rows.map(({ wayBack }) => wayBack),
        0.95,
      ),
    ],
    [
      'kick, 95 %',
      atMost,
      [1.5, 1.2],
      quantile(
        slowHand.flatMap(({ kicks }) => kicks),
        0.95,
      ),
    ],
    ...SIZES.flatMap((size, i) => demandsOfSize(size, SIZES[i - 1]?.vertices ?? 0, rows)),
    [`cold solve over that of ${OTHER}, largest`, atMost, [1, 0.3], largest(ratios(rows, ({ coldMs }) => coldMs))],
  ].filter(([, , , is]) => Number.isFinite(is));
}

/** Of the edits that have a net; of the others it is said that they have none. */
function printDemands(rows) {
  const feasible = rows.filter(({ status }) => status === 'converged' || status === 'exact');
  if (feasible.length === 0) return;
  const short = (number) => Number(number.toPrecision(3));
  console.log(`\n${ASKED}: ${feasible.length} of ${rows.length} edits end in a net.\n`);
  console.log(line(['asked', 'must', 'aim', 'is', '']));
  console.log(line(['---', '---', '---', '---', '---']));
  for (const [what, holds, [must, aim], is] of demands(feasible)) {
    const verdict = holds(is, aim) ? 'aim' : holds(is, must) ? 'must' : 'missed';
    console.log(line([what, must, aim, short(is), verdict]));
  }
}

console.log(line(COLUMNS.map(([name]) => name)));
console.log(line(COLUMNS.map(() => '---')));
if (tasks.length > 0) warmUp();
const asked = [];
for (const task of tasks) {
  const others = new Map();
  for (const method of methods) {
    const row = measure(task, method);
    console.log(line(COLUMNS.map(([, text]) => text(row))));
    others.set(method, row);
    if (method === ASKED) asked.push({ ...row, others });
  }
}
printDemands(asked);
