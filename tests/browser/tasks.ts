/** How long the page's own script holds it up. */
import type { Browser } from 'playwright-core';

/** As Chromium traces them: `ts` and `dur` count µs by the clock, `tdur` µs of processor time. */
interface TraceEvent {
  name: string;
  pid: number;
  tid: number;
  ts: number;
  dur?: number;
  tdur?: number;
  args?: { name?: string };
}

type Whole = TraceEvent & { dur: number; tdur: number };

/** What of a task is the page's doing. The rest is drawing, which software does here on the page's own thread. */
const OWN = new Set([
  'FunctionCall',
  'EvaluateScript',
  'v8.compile',
  'MinorGC',
  'MajorGC',
  'UpdateLayoutTree',
  'Layout',
]);

/** The tasks of the page's main thread while `doing` goes on, ms: what script, layout and the collection of garbage take
 *  of the processor in each (`own`), and how long each lasts by the clock, where it waits for others too. */
export async function mainThreadTasks(
  browser: Browser,
  doing: () => Promise<void>,
): Promise<{ own: number[]; clock: number[]; unmeasured: number }> {
  const categories = ['__metadata', 'disabled-by-default-devtools.timeline', 'devtools.timeline', 'v8'];
  await browser.startTracing(undefined, { categories });
  let trace: Buffer;
  try {
    await doing();
  } finally {
    trace = await browser.stopTracing();
  }
  const { traceEvents } = JSON.parse(String(trace)) as { traceEvents: TraceEvent[] };
  const isMain = ({ name, args }: TraceEvent) => name === 'thread_name' && args?.name === 'CrRendererMain';
  const thread = ({ pid, tid }: TraceEvent) => `${pid} ${tid}`;
  const mainThreads = new Set(traceEvents.filter(isMain).map(thread));
  const ofMain = traceEvents.filter((event) => mainThreads.has(thread(event)));
  const tasks = ofMain.filter(({ name }) => name === 'RunTask');
  // A task under way when tracing begins or ends lacks one time or both.
  const isWhole = (event: TraceEvent): event is Whole => event.dur !== undefined && event.tdur !== undefined;
  const whole = tasks.filter(isWhole);
  const parts = outermost(ofMain.filter(({ name }) => OWN.has(name)).filter(isWhole));
  const own = (task: Whole) => parts.filter((part) => contains(task, part)).reduce((sum, { tdur }) => sum + tdur, 0);
  return {
    own: whole.map((task) => own(task) / 1000),
    clock: whole.map(({ dur }) => dur / 1000),
    unmeasured: tasks.length - whole.length,
  };
}

/** Without those that others contain. */
function outermost(events: Whole[]): Whole[] {
  const sorted = [...events].sort((a, b) => a.ts - b.ts || b.dur - a.dur);
  let last: Whole | undefined;
  return sorted.filter((event) => {
    if (last !== undefined && contains(last, event)) return false;
    last = event;
    return true;
  });
}

function contains(outer: Whole, inner: Whole): boolean {
  const [ends, innerEnds] = [outer.ts + outer.dur, inner.ts + inner.dur];
  return outer.pid === inner.pid && outer.tid === inner.tid && outer.ts <= inner.ts && innerEnds <= ends;
}

/** Processor time, ms, of a fixed piece of work (sorting, filling a map): about 40 on a desk, 100 where processors are slow
 *  or shared. What tasks take is compared with this, taken in the same minute: milliseconds alone would test the machine. */
export function yardstick(): number {
  const times = Array.from({ length: 5 }, () => {
    const before = process.cpuUsage();
    const values = Float64Array.from({ length: 200_000 }, (_, i) => (i * 7919) % 200_003).sort();
    const pairs = new Map<number, number[]>();
    for (let i = 0; i < values.length / 2; ++i) pairs.set(values[i]!, [i, i + 1]);
    const { user, system } = process.cpuUsage(before);
    return (user + system) / 1000;
  });
  return times.sort((a, b) => a - b)[2]!;
}
