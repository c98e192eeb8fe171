/** Another net made of the one that is open. */
import { afterEach, expect, test, vi } from 'vitest';
import { codeOf } from '../../web/src/failure';
import { freshScene } from '../../web/src/document/defaults';
import { sentenceOf } from '../../web/src/document/naming';
import { Openers } from '../../web/src/dialogs/openers';
import { load } from '../wasm/load';
import { openPage } from './page_without_pictures';

// They ask the browser as soon as they are loaded.
vi.mock('../../web/src/view/scene', () => ({ createView: () => {} }));
vi.mock('../../web/src/view/theme', () => ({}));
/** Of each change that is under way, what ends it. */
const ends: (() => void)[] = [];
vi.mock('../../web/src/dialogs/change_dialog', () => ({
  ChangeDialog: class {
    until = () => new Promise((resolve) => ends.push(() => resolve({ origins: [] })));
  },
}));
/** What an equaliser ends with. */
const equalized = vi.hoisted(() => ({ result: Promise.resolve<unknown>(null) }));
vi.mock('../../web/src/dialogs/equalize_dialog', () => ({
  EqualizeDialog: class {
    result = equalized.result;
  },
}));
afterEach(() => {
  ends.length = 0;
  vi.unstubAllGlobals();
});

test('is not made while a third one is being opened, which would be replaced', async () => {
  const { app } = await openPage(await load());
  await app.openScene(freshScene({ recipe: 'dome:vertices=100' }));
  const openers = new Openers(app, {} as HTMLElement);
  const opening = app.openScene(freshScene({ recipe: 'vault:vertices=100' }));
  for (const making of [openers.changeNet({ way: 'refine' }), openers.equalizeNet()])
    expect(await making.catch(codeOf)).toBe('cancelled');
  await opening;
});

test('by a change that ends late replaces no net that was opened meanwhile; there is one change at a time, whose end is waited for', async () => {
  vi.stubGlobal(
    'Worker',
    class {
      postMessage(): void {}
    },
  );
  const { app, solve } = await openPage(await load());
  await app.openScene(freshScene({ recipe: 'dome:vertices=100' }));
  const openers = new Openers(app, {} as HTMLElement);
  const changes = [0, 1].map(() => app.awaitNet(openers.changeNet({ way: 'refine' })));
  expect(ends).toHaveLength(1);
  const settled = vi.fn();
  void app.settled().then(settled);
  await app.openScene(freshScene({ recipe: 'vault:vertices=100' }));
  const { document } = app.opening!;
  await changes[1];
  await solve();
  expect(settled).not.toHaveBeenCalled();
  ends[0]!();
  expect(await Promise.all(changes)).toEqual([false, false]);
  await vi.waitFor(() => expect(settled).toHaveBeenCalled());
  expect(app.opening!.document.net).toBe(document.net);
});

test('by equalising is a change of the one that is open, not another one', async () => {
  const { app } = await openPage(await load());
  await app.openScene(freshScene({ recipe: 'dome:vertices=100' }));
  const { restPositions: positions, faceStart, faceVertices } = app.opening!.net;
  equalized.result = Promise.resolve({
    mesh: { positions, faceStart, faceVertices },
    surface: null,
    isResized: false,
  });
  await new Openers(app, {} as HTMLElement).equalizeNet();
  expect(app.history.names.map(sentenceOf)).toEqual(['Open dome', 'Equalise edges']);
});
