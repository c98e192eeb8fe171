import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { freshScene } from '../../web/src/document/defaults';
import { Teacher } from '../../web/src/learn/teacher';
import { energy, worstRatio } from '../../web/src/net/energy';
import type { FrameData, OpenedNet } from '../../web/src/worker/protocol';
import { load, loadFirst } from '../wasm/load';
import { openPage, type Page } from './page_without_pictures';

test('the energy of an edge is least where its length is right, and steeper with a larger exponent', () => {
  expect(energy(1, 2)).toBe(2);
  expect(energy(2, 2)).toBe(4.25);
  expect(energy(0.5, 2)).toBe(4.25);
  expect(energy(1.02, 50)).toBeGreaterThan(energy(1.02, 2));
});

test('the worst edge is found, too long or too short', () => {
  const net = { edges: Int32Array.of(0, 1, 1, 2), restLengths: Float64Array.of(1, 2) } as unknown as OpenedNet;
  const frame = {
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 0, 1),
    lengthScale: 1,
    fields: { deviation: Float32Array.of(0, 0.5) },
  } as unknown as FrameData;
  expect(worstRatio(net, frame)).toBe(0.5);
  expect(worstRatio(net, { ...frame, lengthScale: 2 })).toBe(0.25);
});

describe('a lesson', () => {
  let page: Page;
  let teacher: Teacher;
  /** What the page does with input. */
  let touch: (event: Event) => void;

  beforeEach(async () => {
    for (const name of ['KeyboardEvent', 'Element', 'HTMLCanvasElement']) vi.stubGlobal(name, class {});
    vi.stubGlobal('addEventListener', (_: string, listener: typeof touch) => (touch = listener));
    vi.stubGlobal('requestAnimationFrame', setImmediate);
    page = await openPage(await loadFirst(), await load());
    teacher = new Teacher(page.app);
    await page.app.openScene(freshScene({ recipe: 'dome:vertices=100' }));
    await page.solve();
  });
  afterEach(() => vi.unstubAllGlobals());

  const scene = () => {
    const { method, options, handles, view } = page.app.opening!.document;
    return { method, options, handles, view };
  };

  test('that is interrupted while what it needs is still on its way leaves nothing behind', async () => {
    const before = scene();
    const shown = teacher.show('energy');
    expect(page.app.opening!.document.method).toBe('li2022');
    touch(new Event('pointerdown'));
    await shown;
    await page.solve();
    expect(scene()).toEqual(before);
    expect(page.app.history.canUndo).toBe(false);
  });

  test('asked for twice at once is given once', async () => {
    const before = scene();
    const first = teacher.show('stages');
    const second = teacher.show('stages');
    await expect.poll(() => scene().handles).not.toEqual(before.handles);
    expect(page.said).toEqual([]);
    touch(new Event('keydown'));
    await page.solve();
    await Promise.all([first, second]);
    expect(scene()).toEqual(before);
  });

  test('leaves no trace in the history where another net is opened meanwhile', async () => {
    for (const lesson of ['net', 'energy', 'deviation'] as const) {
      const before = scene();
      const shown = teacher.show(lesson);
      await new Promise(setImmediate);
      const opening = page.app.openNet({ recipe: 'dome:vertices=120' });
      expect(scene()).toEqual(before);
      await opening;
      await page.solve();
      await shown;
      expect(page.app.history.names.flat()).not.toContain('move');
      expect(scene()).toMatchObject({ method: before.method, view: { field: before.view.field } });
    }
    expect(page.app.history.names).toHaveLength(2);
  });
});
