// Measures in Node what plan.json asks for, with the WebAssembly module that the page uses, and writes wasm.json beside
// it; `speed` in this folder starts it. The fields are those of src/speed/results.h. Growth is measured natively only.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { loadChebnet } from '../../wasm/chebnet.js';

const ROOT = new URL('../../', import.meta.url);
const KERNELS = fileURLToPath(new URL('build/wasm_bench/chebnet_kernels.js', ROOT));
const FALLBACK_STAGE = 4; // of projection: see make_projection()

const [folder] = process.argv.slice(2);
const plan = JSON.parse(readFileSync(join(folder, 'plan.json'), 'utf8'));
const chebnet = await loadChebnet({ wasmBinary: readFileSync(new URL('build/wasm/chebnet_core.wasm', ROOT)) });

/** What the kernels' program prints. It runs like this one: without the quick compiler, see `speed`. */
function kernels(...args) {
  return execFileSync(process.execPath, [...process.execArgv, KERNELS, ...args.map(String)], {
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'inherit'],
  });
}

function open({ net }) {
  return net.endsWith('.obj') ? chebnet.openObj(readFileSync(net, 'utf8'), net) : chebnet.openRecipe(net);
}

function timedSolve(editor) {
  const start = performance.now();
  const report = editor.solve();
  return { report, ms: performance.now() - start };
}

/** JSON has no infinity. */
const finite = (value) => Math.min(value, Number.MAX_VALUE);

const fellBack = ({ trace }) => trace.some(({ stage }) => stage === FALLBACK_STAGE);

function describe({ edit }, editor, report) {
  return {
    edit,
    method: editor.method,
    vertices: editor.info.vertices,
    status: report.status,
    iterations: report.iterations,
    max_dL: finite(report.maxDeviation),
    bend: editor.bend(),
    smallest_angle: (editor.smallestAngle() * 180) / Math.PI,
    fell_back: fellBack(report),
    ms: [],
  };
}

/** The methods take turns, so that whatever else the machine does hits them alike. */
function measureEdit(task) {
  const editor = open(task);
  const results = [];
  for (let repeat = 0; repeat < plan.repeats; ++repeat) {
    plan.methods.forEach((method, i) => {
      editor.reset();
      editor.setMethod(method); // a new one, for which nothing is prepared
      editor.setHandles(task.handles);
      const { report, ms } = timedSolve(editor);
      results[i] ??= describe(task, editor, report);
      results[i].ms.push(ms);
    });
  }
  editor.dispose();
  return results;
}

function moveHandles(task, part, editor) {
  for (const { vertex, target } of task.handles) {
    const rest = editor.restPositions.subarray(3 * vertex, 3 * vertex + 3);
    editor.moveHandle(
      vertex,
      target.map((to, k) => rest[k] + part * (to - rest[k])),
    );
  }
}

function atRest(task, method) {
  const editor = open(task);
  editor.setMethod(method);
  editor.setHandles(task.handles);
  editor.reset();
  return editor;
}

function addFrame(editor, result) {
  const { report, ms } = timedSolve(editor);
  result.ms.push(ms);
  result.unsolved_frames += report.status === 'converged' ? 0 : 1;
  result.fallback_frames += fellBack(report) ? 1 : 0;
  result.max_dL = Math.max(result.max_dL, finite(report.maxDeviation));
}

function measureDrag(task) {
  const runs = plan.methods.map((method) => {
    const editor = atRest(task, method);
    const { vertices } = editor.info;
    const result = { edit: task.edit, method, vertices, unsolved_frames: 0, fallback_frames: 0, max_dL: 0, ms: [] };
    return { editor, result };
  });
  for (let frame = 1; frame <= plan.frames; ++frame) {
    for (const { editor, result } of runs) {
      moveHandles(task, frame / plan.frames, editor);
      addFrame(editor, result);
    }
  }
  return runs.map(({ editor, result }) => {
    const bend = editor.bend();
    editor.dispose();
    return { ...result, bend };
  });
}

function measureKernels({ edit, net, handles }) {
  const lines = kernels(net, plan.repeats, ...handles.map(({ vertex }) => vertex))
    .trim()
    .split('\n');
  return lines.map((line) => ({ edit, ...JSON.parse(line) }));
}

const MEASURES = { kernels: measureKernels, edits: measureEdit, drags: measureDrag };

function measureAll() {
  const compiler = `${kernels().trim()}, Node ${process.version}`;
  const results = {
    target: 'wasm',
    machine: { cpu: cpus()[0]?.model ?? 'unknown', compiler, blas: '' },
    methods: plan.methods,
    growth: [],
    stops: [],
    kernels: [],
    edits: [],
    drags: [],
  };
  for (const task of plan.tasks) {
    const measure = MEASURES[task.section];
    if (measure === undefined) continue;
    console.error(`  wasm  ${task.section}  ${task.edit}`);
    results[task.section].push(...measure(task));
  }
  return results;
}

try {
  writeFileSync(join(folder, 'wasm.json'), JSON.stringify(measureAll(), null, 1));
} catch (error) {
  console.error(`speed: ${error.message}`);
  process.exitCode = 2;
}
