/** How long the page's own script holds it up. */
import type { Browser } from 'playwright-core';

/** As Chromium traces them: `dur` counts µs by the clock, `tdur` µs of processor time. */
interface TraceEvent {
  name: string;
  pid: number;
  tid: number;
  dur?: number;
  tdur?: number;
  args?: { name?: string };
}

/** The tasks of the page's main thread while `doing` goes on, ms. Here the software renderer draws on the processor that
 *  the page runs on, and others may use it too: by the clock a task waits for them, so its own time counts. */
export async function mainThreadTasks(
  browser: Browser,
  doing: () => Promise<void>,
): Promise<{ own: number[]; clock: number[]; unmeasured: number }> {
  await browser.startTracing(undefined, { categories: ['__metadata', 'disabled-by-default-devtools.timeline'] });
  let trace: Buffer;
  try {
    await doing();
  } finally {
    trace = await browser.stopTracing();
  }
  const { traceEvents } = JSON.parse(String(trace)) as { traceEvents: TraceEvent[] };
  const isMain = ({ name, args }: TraceEvent) => name === 'thread_name' && args?.name === 'CrRendererMain';
  const mainThreads = new Set(traceEvents.filter(isMain).map(({ pid, tid }) => `${pid} ${tid}`));
  const tasks = traceEvents.filter(({ name, pid, tid }) => name === 'RunTask' && mainThreads.has(`${pid} ${tid}`));
  // A task under way when tracing begins or ends lacks one time or both.
  const whole = tasks.flatMap(({ dur, tdur }) => (dur === undefined || tdur === undefined ? [] : [{ dur, tdur }]));
  return {
    own: whole.map(({ tdur }) => tdur / 1000),
    clock: whole.map(({ dur }) => dur / 1000),
    unmeasured: tasks.length - whole.length,
  };
}
