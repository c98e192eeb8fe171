/** A lesson with the editor in it: an example of a page that talks to the editor it embeds, see protocol.ts. */
import type { Vec3 } from '../document/document';
import { preferredLanguage } from '../language/choice';
import { lesson as en } from '../language/en/lesson';
import type { Stats } from '../scripting';
import type { Answer, CallName, HostCall, News } from './protocol';

const NET = { recipe: 'dome:vertices=800' };
/** By how much a button moves the crown. */
const STEP = 0.4;

interface Waiting {
  resolve(result: unknown): void;
  reject(error: Error): void;
}

const words = preferredLanguage() === 'zh' ? (await import('../language/zh/lesson')).lesson : en;
const frame = document.querySelector('iframe')!;
const measured = element('measured');
const waiting = new Map<number | string, Waiting>();
let count = 0;

showWords();
element('push').addEventListener('click', () => void moveCrown(-STEP));
element('lift').addEventListener('click', () => void moveCrown(STEP));
element('again').addEventListener('click', () => void call('open', NET));
addEventListener('message', ({ source, data }: MessageEvent<Answer | News>) => {
  if (source === frame.contentWindow && data?.chebnet === 1) receive(data);
});
// Only now is the frame loaded: the editor sends `ready` only once.
frame.src = './index.html?embed';

function element(id: string): HTMLElement {
  return document.getElementById(id)!;
}

function showWords(): void {
  document.documentElement.lang = words.locale;
  document.title = words.title;
  frame.title = words.picture;
  for (const each of document.querySelectorAll<HTMLElement>('[data-words]')) {
    each.textContent = String(words[each.dataset.words as keyof typeof words]);
  }
}

function call(name: CallName, ...args: unknown[]): Promise<unknown> {
  const id = ++count;
  const message: HostCall = { chebnet: 1, id, call: name, args };
  frame.contentWindow!.postMessage(message, location.origin);
  return new Promise((resolve, reject) => waiting.set(id, { resolve, reject }));
}

function receive(message: Answer | News): void {
  if ('event' in message) return hear(message);
  const { id } = message;
  if ('error' in message) waiting.get(id)?.reject(new Error(message.error.message));
  else waiting.get(id)?.resolve(message.result);
  waiting.delete(id);
}

function hear(news: News): void {
  if (news.event === 'ready') void begin();
  else if (news.event === 'settled') showStats(news.stats);
}

async function begin(): Promise<void> {
  await call('on', 'settled');
  await call('open', NET);
  showStats((await call('stats')) as Stats);
  for (const button of document.querySelectorAll('button')) button.disabled = false;
}

function showStats({ edges, maxDeviation, iterations }: Stats): void {
  const worst = maxDeviation < 1e-12 ? words.below('1e-12') : maxDeviation.toExponential(1);
  measured.textContent = words.measured(edges, worst, iterations);
}

/** The last handle is the one to drag. */
async function moveCrown(up: number): Promise<void> {
  const handles = (await call('handles')) as { vertex: number; target: Vec3 }[];
  const {
    vertex,
    target: [x, y, z],
  } = handles.at(-1)!;
  await call('move', vertex, [x, y, z + up]);
}
