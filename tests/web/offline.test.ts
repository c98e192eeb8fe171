/** The offer of another version, by a browser that is none. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { keepOffline } from '../../web/src/offline/offline';

class WorkerOfPage extends EventTarget {
  readonly told: string[] = [];
  state = 'installing';

  postMessage(message: string): void {
    this.told.push(message);
  }

  go(state: string): void {
    this.state = state;
    this.dispatchEvent(new Event('statechange'));
  }
}

let registration: EventTarget & Record<'active' | 'waiting' | 'installing', WorkerOfPage | null>;
let accepts: (() => void)[];
let reloads: number;

/** Another version has been found, and waits. */
function update(): WorkerOfPage {
  const worker = new WorkerOfPage();
  registration.installing = worker;
  registration.dispatchEvent(new Event('updatefound'));
  registration.waiting?.go('redundant');
  [registration.installing, registration.waiting] = [null, worker];
  worker.go('installed');
  return worker;
}

function activate(worker: WorkerOfPage): void {
  [registration.waiting, registration.active] = [null, worker];
  worker.go('activated');
}

beforeEach(async () => {
  vi.stubEnv('PROD', true);
  registration = Object.assign(new EventTarget(), { active: new WorkerOfPage(), waiting: null, installing: null });
  vi.stubGlobal('isSecureContext', true);
  vi.stubGlobal('navigator', { serviceWorker: { register: async () => registration } });
  [accepts, reloads] = [[], 0];
  await keepOffline(
    (accept) => accepts.push(accept),
    () => (reloads += 1),
  );
});
afterEach(() => {
  vi.unstubAllEnvs();
  vi.unstubAllGlobals();
});

test('the page goes over to a version that is offered, once that is active', () => {
  const worker = update();
  expect(accepts).toHaveLength(1);
  accepts[0]!();
  expect([worker.told, reloads]).toEqual([['activate'], 0]);
  activate(worker);
  expect(reloads).toBe(1);
});

test('an offer that a later version has overtaken leads to that one', () => {
  const first = update();
  const second = update();
  accepts[0]!();
  expect([first.told, second.told]).toEqual([[], ['activate']]);
  activate(second);
  expect(reloads).toBe(1);
});

test('where another window has gone over before, the page is loaded at once', () => {
  update();
  activate(update());
  accepts[0]!();
  expect(reloads).toBe(1);
});
