/** Workers that cannot be loaded, of which browsers say nothing. */
import { expect, test } from 'vitest';
import type { ChangeRequest } from '../../web/src/change/change_protocol';
import { Changing } from '../../web/src/change/changing';
import { AskedDraper } from '../../web/src/drape/asking';
import { Draping, type DrapingEvents } from '../../web/src/drape/draping';
import type { EqualizeRequest } from '../../web/src/equalize/equalize_protocol';
import { Equalizing } from '../../web/src/equalize/equalizing';
import { words } from '../../web/src/language/language';

class Unloaded {
  onmessage = null;
  onerror: ((event: ErrorEvent) => void) | null = null;

  postMessage(): void {
    queueMicrotask(() => this.onerror?.(new Event('error') as ErrorEvent));
  }

  terminate(): void {}
}

const draping = (): Promise<never> =>
  new Promise((_, reject) =>
    new Draping(() => new Unloaded(), { refused: reject } as unknown as DrapingEvents).open({ own: 'shell' }),
  );

test.each([
  ['changes the net', () => new Changing(new Unloaded(), {} as ChangeRequest, () => {}).result],
  ['equalises it', () => new Equalizing(() => new Unloaded()).run({} as EqualizeRequest, () => {})],
  ['lays one on a surface', draping],
  [
    'does so for a script',
    () => new AskedDraper(new Unloaded()).ask({ type: 'open', source: { own: 'shell' } }, 'opened'),
  ],
])('the one that %s is said to be missing', async (_, ask) => {
  await expect(ask()).rejects.toMatchObject({ code: 'worker_lost', message: words.page.programMissing });
});
