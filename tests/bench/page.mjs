// Measures what a net costs the page's main thread while it is opened, dragged and pointed at, and what is heavy costs it,
// and prints JSON. Times are processor time of Chromium's tasks: by the clock a software renderer would count, which shares
// the processor here; the longest of script is told in parts of a fixed piece of work, too, which is the same on a slow
// machine. Bytes are what scripts allocate, garbage included. Before that, on a phone of a quarter of the speed, how long a
// visitor's first move takes to move the first net, by the clock: until the page has the net, and until the frame that
// shows it.
//   (cd web && npm run build) && node tests/bench/page.mjs [RECIPE]...
import { createRequire } from 'node:module';
import { fileURLToPath, pathToFileURL } from 'node:url';

const RECIPES = ['vault:vertices=4000', 'vault:vertices=16000', 'vault:vertices=100000'];
const MOVES = 30;
const VISITS = 5;
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
/** A small picture: a software renderer takes long enough. */
const viewport = { width: 900, height: 600 };
/** Collecting garbage, without what of it lies within. */
const GARBAGE = /^(MinorGC|MajorGC|V8\.GC_MC_INCREMENTAL)$/;
/** Of these, what takes time is script or collecting its garbage. */
const SCRIPT = /^(FunctionCall|EvaluateScript|RunMicrotasks|HandlePostMessage|MinorGC|MajorGC|V8\.GC.*|BlinkGC.*)$/;

const WEB = fileURLToPath(new URL('../../web/', import.meta.url));
const { runnerImport } = await import(pathToFileURL(createRequire(`${WEB}package.json`).resolve('vite')).href);
const { DIST, launch, newVisit, serve } = await importTyped('../browser/site.ts');
const { fan } = await importTyped('../browser/geometry.ts');
const { dropWaves, makeWaves } = await importTyped('../browser/waves.ts');

/** What could hold up the page for long, done to it. */
const HEAVY = {
  'three thousand handles': async ({ script }) => {
    await script.open({ recipe: 'vault:vertices=20000' });
    await script.settled();
    await script.setHandles(Array.from({ length: 3000 }, (_, vertex) => ({ vertex })));
    await script.settled();
  },
  'twenty thousand triangles around one vertex': async ({ script }) => {
    await script.open({ obj: fan(20_000) });
    await script.settled();
  },
  'a million triangles, and a net on them': async ({ page, script }) => {
    const draper = page.getByRole('dialog', { name: /^A net on a surface$/ });
    await page.evaluate(makeWaves);
    await page.evaluate(dropWaves);
    await page.getByRole('button', { name: 'Make a net on it…' }).click();
    await draper.locator('.results .facts:not(.stale)', { hasText: 'Largest dL' }).waitFor();
    await draper.getByRole('button', { name: 'Open this net' }).click();
    await script.settled();
  },
};

const [browser, site] = await Promise.all([launch(), serve(() => DIST)]);
try {
  const given = process.argv.slice(2);
  const figures = [{ firstInput: await firstInput() }];
  for (const recipe of given.length > 0 ? given : RECIPES) figures.push(await measure(recipe));
  if (given.length === 0) for (const name of Object.keys(HEAVY)) figures.push(await measureHeavy(name));
  console.log(JSON.stringify(figures, null, 2));
} finally {
  await browser.close();
  site.close();
}

async function importTyped(path) {
  const file = fileURLToPath(new URL(path, import.meta.url));
  return (await runnerImport(file, { root: WEB, resolve: { dedupe: ['playwright-core'] }, logLevel: 'error' })).module;
}

async function firstInput() {
  const visits = [];
  for (let i = 0; i < VISITS; i++) visits.push(await firstMove());
  return {
    netMs: statistics(visits.map(({ netMs }) => netMs)),
    frameMs: statistics(visits.map(({ frameMs }) => frameMs)),
  };
}

async function firstMove() {
  const { page, script } = await newVisit(browser, PHONE);
  const session = await page.context().newCDPSession(page);
  await page.goto(site.address);
  await script.waitForNet();
  await script.settled();
  await session.send('Emulation.setCPUThrottlingRate', { rate: 4 });
  const vertex = await page.evaluate(() => {
    let moved = null;
    const note = ({ timeStamp }) => (moved ??= timeStamp);
    addEventListener('pointerdown', () => addEventListener('pointermove', note, { once: true, capture: true }), {
      once: true,
      capture: true,
    });
    window.first_move = new Promise((resolve) =>
      window.chebnet.on('frame', () => {
        if (moved === null) return;
        const netMs = performance.now() - moved;
        requestAnimationFrame(() => resolve({ netMs, frameMs: performance.now() - moved }));
      }),
    );
    return window.chebnet.handles().at(-1).vertex;
  });
  const { x, y } = await script.screenPosition(vertex);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 4, y - 10);
  const times = await page.evaluate(() => window.first_move);
  await page.mouse.up();
  await page.context().close();
  return times;
}

async function measure(recipe) {
  const { page, script, complaints } = await newVisit(browser, { viewport });
  await page.goto(site.address);
  await script.waitForNet();
  await script.settled();
  const opening = await traced(async () => {
    await script.open({ recipe });
    await script.settled();
  });
  const vertex = await page.evaluate(() => window.chebnet.handles().at(-1).vertex);
  const drag = await traced(() => dragAround(script, vertex));
  const allocated = await allocations(page, () => dragAround(script, vertex));
  const hover = await traced(() => pointAround(page));
  await page.context().close();
  return {
    recipe,
    opening: tasksOf(opening),
    drag: { ...framesOf(drag), ...allocated },
    hover: tasksOf(hover),
    complaints,
  };
}

async function measureHeavy(name) {
  const visit = await newVisit(browser, { viewport });
  visit.page.setDefaultTimeout(120_000);
  await visit.page.goto(site.address);
  await visit.script.waitForNet();
  await visit.script.settled();
  const trace = await traced(() => HEAVY[name](visit));
  await visit.page.context().close();
  return { heavy: name, ...tasksOf(trace), complaints: visit.complaints };
}

/** A drag in a circle, one move a frame. */
async function dragAround(script, vertex) {
  const { mouse } = script.page;
  const { x, y } = await script.screenPosition(vertex);
  await mouse.move(x, y);
  await mouse.down();
  for (let i = 1; i <= MOVES; i++) {
    const turn = (2 * Math.PI * i) / MOVES;
    await mouse.move(x + 30 * Math.sin(turn), y - 30 + 30 * Math.cos(turn));
    await script.page.waitForTimeout(30);
  }
  await mouse.up();
  await script.settled();
}

async function pointAround(page) {
  const { width, height } = viewport;
  for (let i = 0; i < MOVES; i++) {
    await page.mouse.move(0.25 * width + (0.3 * width * i) / MOVES, height * (0.4 + 0.2 * Math.sin(i)));
    await page.waitForTimeout(20);
  }
}

// --------------------------------------------------------------------------------------------------------- allocations

async function allocations(page, doing) {
  const session = await page.context().newCDPSession(page);
  await page.evaluate(() => {
    window.frames_counted = 0;
    window.chebnet.on('frame', () => window.frames_counted++);
  });
  const options = {
    samplingInterval: 256,
    includeObjectsCollectedByMajorGC: true,
    includeObjectsCollectedByMinorGC: true,
  };
  await session.send('HeapProfiler.startSampling', options);
  await doing();
  const { profile } = await session.send('HeapProfiler.stopSampling');
  const frames = await page.evaluate(() => window.frames_counted);
  const bytes = new Map();
  collect(profile.head, bytes);
  const total = [...bytes.values()].reduce((sum, each) => sum + each, 0);
  const most = [...bytes].sort((a, b) => b[1] - a[1]).slice(0, 12);
  return {
    kilobytesAFrame: round(total / frames / 1000),
    allocators: Object.fromEntries(most.map(([name, size]) => [name, round(size / frames / 1000)])),
  };
}

function collect({ callFrame, selfSize, children }, bytes) {
  const name = `${callFrame.functionName || '(anonymous)'} ${callFrame.lineNumber}:${callFrame.columnNumber}`;
  bytes.set(name, (bytes.get(name) ?? 0) + selfSize);
  for (const child of children) collect(child, bytes);
}

// --------------------------------------------------------------------------------------------------------------- traces

/** The events of the page's main thread while `doing` goes on, and of the messages to it. */
async function traced(doing) {
  const categories = ['__metadata', 'devtools.timeline', 'disabled-by-default-devtools.timeline'];
  await browser.startTracing(undefined, { categories });
  await doing();
  const { traceEvents } = JSON.parse(String(await browser.stopTracing()));
  const isMain = ({ name, args }) => name === 'thread_name' && args?.name === 'CrRendererMain';
  const threads = new Set(traceEvents.filter(isMain).map(threadOf));
  return { main: traceEvents.filter((event) => threads.has(threadOf(event))), all: traceEvents };
}

function threadOf({ pid, tid }) {
  return `${pid} ${tid}`;
}

function tasksOf({ main }) {
  const own = times(main, /^RunTask$/);
  const script = times(scriptsOf(main), SCRIPT);
  const longestScriptMs = Math.max(...script);
  return {
    longestTaskMs: round(Math.max(...own)),
    longestScriptMs: round(longestScriptMs),
    longestScriptInFixedWork: round(longestScriptMs / fixedWorkMs()),
    scriptMs: round(sum(script)),
  };
}

/** Processor time of a fixed piece of work (sorting, filling a map), taken in the same minute as what is compared with it:
 *  about 40 on a desk, 100 where processors are slow or shared. */
function fixedWorkMs() {
  const times = Array.from({ length: 5 }, () => {
    const before = process.cpuUsage();
    const values = Float64Array.from({ length: 200_000 }, (_, i) => (i * 7919) % 200_003).sort();
    const pairs = new Map();
    for (let i = 0; i < values.length / 2; ++i) pairs.set(values[i], [i, i + 1]);
    const { user, system } = process.cpuUsage(before);
    return (user + system) / 1000;
  });
  return times.sort((a, b) => a - b)[2];
}

function framesOf(trace) {
  const { main, all } = trace;
  const drawn = main.filter(({ name }) => name === 'FireAnimationFrame').length;
  return {
    ...tasksOf(trace),
    framesDrawn: drawn,
    garbageMsAFrame: round(sum(times(main, GARBAGE)) / drawn),
    messageMs: statistics(times(main, /^HandlePostMessage$/)),
    timerMs: statistics(times(main, /^TimerFire$/)),
    animationFrameMs: statistics(times(main, /^FireAnimationFrame$/)),
    latencyMs: statistics(latencies(all, main)),
  };
}

/** Processor time of the events of these names, ms. */
function times(events, names) {
  return events.filter(({ name, tdur }) => names.test(name) && tdur !== undefined).map(({ tdur }) => tdur / 1000);
}

/** Outermost events of script. */
function scriptsOf(main) {
  const scripts = [];
  let end = -Infinity;
  for (const event of main
    .filter(({ name, tdur }) => SCRIPT.test(name) && tdur !== undefined)
    .sort((a, b) => a.ts - b.ts)) {
    if (event.ts < end) continue;
    end = event.ts + event.dur;
    scripts.push(event);
  }
  return scripts;
}

/** From when a worker posted a message to the page until it was read, ms by the clock. */
function latencies(all, main) {
  const threads = new Set(main.map(threadOf));
  const posts = all.filter(
    (event) => event.name === 'SchedulePostMessage' && event.args.data !== undefined && !threads.has(threadOf(event)),
  );
  const posted = new Map(posts.map(({ ts, args }) => [args.data.traceId, ts]));
  return main
    .filter(
      ({ name, args }) => name === 'HandlePostMessage' && args.data !== undefined && posted.has(args.data.traceId),
    )
    .map(({ ts, args }) => (ts - posted.get(args.data.traceId)) / 1000);
}

function statistics(values) {
  const sorted = values.sort((a, b) => a - b);
  const at = (share) => round(sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN);
  return { count: values.length, median: at(0.5), p95: at(0.95), largest: at(1) };
}

function sum(values) {
  return values.reduce((total, value) => total + value, 0);
}

function round(value) {
  return Number(value.toPrecision(3));
}
