/** Nothing is lost: undo and redo of everything, a reload, a project saved and opened again. */
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { FileChooser } from 'playwright-core';
import { expect, test, vi } from 'vitest';
import { dragBy } from './geometry';
import type { Visit } from './page';
import { dropFile, OUTPUT, Script, visits, openForResearch } from './page';

const SHAPE = 'vault:vertices=600';
/** Milliseconds that a busy machine may take. */
const PATIENCE = { timeout: 15_000 };

declare global {
  interface Window {
    workers: Worker[];
  }
}

const { arrive, open } = visits();

const historyOf = ({ page }: Visit) => page.locator('.history');
const names = (visit: Visit) => historyOf(visit).getByRole('button').allTextContents();
const present = (visit: Visit) => historyOf(visit).locator('[aria-current]').textContent();
const said = ({ page }: Visit) => page.locator('[role=status]').allInnerTexts();
const press = ({ page }: Visit, name: string) => page.getByRole('button', { name, exact: true }).click();

interface Standing {
  positions: Float64Array;
  method: string;
  handles: number;
}

async function standing(script: Script): Promise<Standing> {
  await script.settled();
  const { method, handles } = await script.stats();
  return { positions: await script.positions(), method, handles };
}

async function openSection({ page }: Visit, name: string) {
  await page.locator('summary', { hasText: name }).click();
}

/** A vault, a drag, another method, one handle less; and how the net stood after each. */
async function edit(visit: Visit): Promise<Standing[]> {
  const { page, script } = visit;
  await script.open({ recipe: SHAPE });
  const stood = [await standing(script)];
  const handles = await page.evaluate(() => window.chebnet.handles().map(({ vertex }) => vertex));
  await dragBy(script, handles.at(-1)!, [-60, -40]);
  stood.push(await standing(script));
  await openForResearch(page, 'Solver');
  await page.getByRole('combobox', { name: /^Method/ }).selectOption('li2022');
  stood.push(await standing(script));
  await page.locator('canvas').first().focus();
  await dragBy(script, handles.at(-1)!, [30, -30]);
  stood.push(await standing(script));
  return stood;
}

/** What the browser keeps of this tab, as the names of the history. */
function kept({ page }: Visit): Promise<string[]> {
  return page.evaluate(async () => {
    const done = <T>(request: IDBRequest<T>) =>
      new Promise<T>((resolve, reject) => {
        request.onsuccess = () => resolve(request.result);
        request.onerror = () => reject(request.error);
      });
    const tab = sessionStorage.getItem('chebnet.tab');
    if (tab === null) return [];
    const database = await done(indexedDB.open('chebnet'));
    const { states } = (await done(database.transaction('projects').objectStore('projects').get(tab))) as {
      states: { name: string }[];
    };
    database.close();
    return states.map(({ name }) => name);
  });
}

/** Under which the browser keeps something. */
function keys({ page }: Visit): Promise<string[]> {
  return page.evaluate(
    () =>
      new Promise<string[]>((resolve, reject) => {
        const opening = indexedDB.open('chebnet');
        opening.onerror = () => reject(opening.error);
        opening.onsuccess = () => {
          const request = opening.result.transaction('projects').objectStore('projects').getAllKeys();
          request.onsuccess = () => resolve(request.result.map(String));
          request.onerror = () => reject(request.error);
          opening.result.close();
        };
      }),
  );
}

test('everything done is listed, undone, done again, kept over a reload, saved as a project and opened again', async () => {
  const visit = await arrive();
  const { page, script } = visit;
  // Listened for from the start: the browser is told so, which takes its time.
  const choosers: FileChooser[] = [];
  page.on('filechooser', (chooser) => choosers.push(chooser));
  await openSection(visit, 'History');
  const stood = await edit(visit);
  const list = await names(visit);
  expect(list.slice(1)).toEqual([
    'Open vault',
    expect.stringMatching(/^Move handle \d+$/),
    'Method: Li et al. 2022',
    list[2],
  ]);
  expect(await present(visit)).toBe(list[4]);

  for (let i = 3; i >= 1; --i) {
    await page.keyboard.press('Control+z');
    expect(await standing(script)).toEqual(stood[i - 1]);
    expect(await present(visit)).toBe(list[i]);
  }
  await page.keyboard.press('Control+Shift+z');
  expect(await standing(script)).toEqual(stood[1]);
  await page.keyboard.press('Control+y');
  expect(await standing(script)).toEqual(stood[2]);
  await historyOf(visit).getByRole('button').last().click();
  await expect.poll(() => present(visit), PATIENCE).toBe(list[4]);
  expect(await standing(script)).toEqual(stood[3]);

  await historyOf(visit).locator('[aria-current]').focus();
  for (const key of ['Home', 'ArrowDown', 'Enter']) await page.keyboard.press(key);
  await expect.poll(() => present(visit), PATIENCE).toBe('Open vault');
  expect(await standing(script)).toEqual(stood[0]);
  for (const key of ['End', 'Enter']) await page.keyboard.press(key);
  expect(await standing(script)).toEqual(stood[3]);
  await page.screenshot({ path: join(OUTPUT, 'history-desktop.png') });

  await expect.poll(() => kept(visit), PATIENCE).toEqual(list);
  await page.reload();
  await script.waitForNet();
  await expect.poll(() => said(visit), PATIENCE).toContainEqual(expect.stringMatching(/as you left it/));
  expect(await standing(script)).toEqual(stood[3]);
  await page.screenshot({ path: join(OUTPUT, 'restored-desktop.png') });
  await page.keyboard.press('Control+z');
  expect(await standing(script)).toEqual(stood[2]);
  await page.keyboard.press('Control+y');
  expect(await standing(script)).toEqual(stood[3]);

  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  const file = await download;
  expect(file.suggestedFilename()).toBe('vault.chebnet.json');
  const path = await file.path();

  await press(visit, 'File');
  await page.screenshot({ path: join(OUTPUT, 'project-menu-desktop.png') });
  await page.getByRole('button', { name: /^New/ }).click();
  await expect.poll(async () => (await script.stats()).vertices, PATIENCE).toBeGreaterThan(1000);

  await page.keyboard.press('Control+o');
  const chooser = await vi.waitUntil(() => choosers[0], PATIENCE);
  await chooser.setFiles({
    name: 'vault.chebnet.json',
    mimeType: 'application/json',
    buffer: await readFile(path),
  });
  await expect.poll(() => said(visit), PATIENCE).toContainEqual(expect.stringMatching(/project is open/));
  expect(await standing(script)).toEqual(stood[3]);
  await openSection(visit, 'History');
  await expect.poll(() => names(visit), PATIENCE).toEqual(list);
  await historyOf(visit).getByRole('button', { name: 'Open vault' }).click();
  await expect.poll(() => present(visit), PATIENCE).toBe('Open vault');
  expect(await standing(script)).toEqual(stood[0]);

  await press(visit, 'File');
  await page.getByRole('button', { name: /^Restore my last net/ }).click();
  await expect.poll(async () => (await script.stats()).vertices, PATIENCE).toBeGreaterThan(1000);
});

test('what was done last is kept though the page is left at once', async () => {
  const visit = await arrive();
  const { page, script } = visit;
  await script.open({ recipe: SHAPE });
  const { vertex, target } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const [x, y, z] = target;
  await expect.poll(() => kept(visit), PATIENCE).not.toEqual([]);
  await script.move(vertex, [x, y, z - 0.5]);
  const left = await standing(script);
  await page.reload();
  await script.waitForNet();
  expect(await standing(script)).toEqual(left);
});

test('a turn of the camera writes the view alone, and is there after a reload, after a second one, too', async () => {
  const visit = await arrive();
  const { page, script } = visit;
  await script.open({ recipe: 'vault:vertices=4000' });
  await script.settled();
  await expect.poll(() => kept(visit), PATIENCE).not.toEqual([]);
  // Its picture in the list of projects comes after that.
  await expect.poll(() => keys(visit), PATIENCE).toContainEqual(expect.stringMatching(/^look /));
  const turn = async (): Promise<string[]> => {
    const before = await script.screenPosition(0);
    const written = await page.evaluateHandle(() => {
      const keys: string[] = [];
      const { put } = IDBObjectStore.prototype;
      IDBObjectStore.prototype.put = function (value: unknown, key?: IDBValidKey) {
        keys.push(String(key));
        return put.call(this, value, key);
      };
      return keys;
    });
    await page.locator('canvas').first().focus();
    await page.keyboard.press('ArrowLeft');
    await expect.poll(() => script.screenPosition(0)).not.toEqual(before);
    await expect.poll(() => written.jsonValue(), PATIENCE).not.toEqual([]);
    return written.jsonValue();
  };
  for (const _ of [1, 2]) {
    const keys = await turn();
    expect(keys.filter((key) => !key.startsWith('view '))).toEqual([]);
    const seen = await script.screenPosition(0);
    await page.reload();
    await script.waitForNet();
    await script.settled();
    const again = await script.screenPosition(0);
    expect(Math.hypot(again.x - seen.x, again.y - seen.y)).toBeLessThan(1);
    // That it has been looked at, from which on turns are told.
    await page.waitForTimeout(1000);
  }
});

test('a net that has not come to rest is kept when a project takes its place', async () => {
  const visit = await arrive();
  const { page, script } = visit;
  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  const project = await readFile(await (await download).path(), 'utf8');
  // Sooner than it would be kept by itself.
  const vertices = await page.evaluate(async (text) => {
    await window.chebnet.open({ recipe: 'vault:vertices=4000' });
    const { vertex, target } = window.chebnet.handles().at(-1)!;
    void window.chebnet.move(vertex, [target[0], target[1], target[2] - 3]);
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], 'net.chebnet.json'));
    document
      .getElementById('view')
      ?.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    return window.chebnet.stats().vertices;
  }, project);
  await expect.poll(() => said(visit), PATIENCE).toContainEqual(expect.stringMatching(/project is open/));
  await press(visit, 'File');
  await page.getByRole('button', { name: /^Restore my last net/ }).click();
  await expect.poll(async () => (await script.stats()).vertices, PATIENCE).toBe(vertices);
  expect((await standing(script)).handles).toBeGreaterThan(0);
});

/** The dialog of projects, and the names in it. */
function chooserOf(visit: Visit) {
  const dialog = visit.page.getByRole('dialog', { name: 'My projects' });
  const show = async () => {
    await press(visit, 'File');
    await visit.page.getByRole('button', { name: /^My projects/ }).click();
    await dialog.waitFor();
  };
  const lines = () =>
    dialog.getByRole('textbox').evaluateAll((all) => all.map((each) => (each as HTMLInputElement).value));
  return { dialog, show, lines };
}

test('several projects with names and pictures: opened, renamed, copied, deleted and brought back; one open elsewhere stays whole', async () => {
  const visit = await arrive();
  const { page, script } = visit;
  const { dialog, show, lines } = chooserOf(visit);
  await show();
  await dialog.getByText('Nothing is kept yet').waitFor();
  await page.screenshot({ path: join(OUTPUT, 'projects-empty.png') });
  await dialog.getByRole('button', { name: 'Keep it' }).click();
  await dialog.getByText('open now').waitFor();
  await dialog.getByRole('button', { name: 'Close' }).click();

  await script.open({ recipe: SHAPE });
  const hall = await standing(script);
  await expect.poll(() => kept(visit), PATIENCE).toHaveLength(2);
  await show();
  await dialog.getByRole('textbox').fill('Hall');
  await dialog.getByRole('textbox').press('Enter');
  await dialog.getByRole('button', { name: 'Duplicate Hall' }).click();
  await expect.poll(lines).toEqual(['Hall', 'Copy of Hall']);
  await dialog.getByRole('button', { name: 'Close' }).click();
  await press(visit, 'File');
  await page.getByRole('button', { name: /^New/ }).click();
  await expect.poll(async () => (await script.stats()).vertices, PATIENCE).toBeGreaterThan(1000);
  await show();
  await expect.poll(lines).toEqual(['', 'Hall', 'Copy of Hall']);
  await page.screenshot({ path: join(OUTPUT, 'projects-desktop.png') });
  await dialog.getByRole('button', { name: 'Delete Copy of Hall' }).click();
  await expect.poll(lines).toEqual(['', 'Hall']);
  await dialog.getByRole('button', { name: 'Undo' }).press('Enter');
  await expect.poll(lines).toEqual(['', 'Hall', 'Copy of Hall']);
  expect(await dialog.locator(':focus').innerText()).toBe('Close');

  const other = await newTab(visit);
  await other.page.goto(page.url());
  await other.script.waitForNet();
  await press(other, 'File');
  await other.page.getByRole('button', { name: /^My projects/ }).click();
  await other.page.getByText('open in another tab').waitFor();
  await other.page.close();

  await dialog.getByRole('button', { name: 'Open Hall', exact: true }).click();
  await dialog.waitFor({ state: 'detached' });
  expect(await standing(script)).toEqual(hall);
  await page.reload();
  await script.waitForNet();
  expect(await standing(script)).toEqual(hall);
  const [saved] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+s')]);
  expect(saved.suggestedFilename()).toBe('Hall.chebnet.json');
  const stranger = await arrive();
  await dropFile(stranger.page, 'Hall.chebnet.json', await readFile((await saved.path())!));
  await expect.poll(() => said(stranger), PATIENCE).toContainEqual(expect.stringMatching(/project is open/));
  const theirs = chooserOf(stranger);
  await theirs.show();
  await expect.poll(theirs.lines).toContain('Hall');
  await stranger.page.close();
  await page.setViewportSize({ width: 390, height: 844 });
  await page.emulateMedia({ colorScheme: 'dark' });
  await show();
  await expect.poll(lines).toEqual(['Hall', '', 'Copy of Hall']);
  await page.screenshot({ path: join(OUTPUT, 'projects-phone.png') });
});

test('a project that cannot be opened says why, and can be deleted', async () => {
  const visit = await arrive();
  const { page, script } = visit;
  const { dialog, show, lines } = chooserOf(visit);
  await script.open({ recipe: SHAPE });
  await expect.poll(() => kept(visit), PATIENCE).toHaveLength(2);
  await press(visit, 'File');
  await page.getByRole('button', { name: /^New/ }).click();
  await expect.poll(async () => (await script.stats()).vertices, PATIENCE).toBeGreaterThan(1000);
  await show();
  await expect.poll(lines).toHaveLength(2);
  await page.evaluate(async () => {
    const done = <T>(request: IDBRequest<T>) =>
      new Promise<T>((resolve) => (request.onsuccess = () => resolve(request.result)));
    const database = await done(indexedDB.open('chebnet'));
    const projects = database.transaction('projects', 'readwrite').objectStore('projects');
    const ids = await done(projects.get('index') as IDBRequest<string[]>);
    await done(projects.put({ chebnet: 99 }, ids[1]!));
    database.close();
  });
  const second = dialog.getByRole('listitem').nth(1);
  await second.getByRole('button', { name: 'Open' }).click();
  await expect.poll(() => dialog.getByRole('status').innerText()).toMatch(/another version/);
  await dialog.getByRole('button', { name: 'Close' }).click();
  await show();
  await second.getByRole('button', { name: 'Delete' }).click();
  await expect.poll(lines).toHaveLength(1);
});

test('a line of the list stays where it is while its project is renamed: with the focus, and under the pointer', async () => {
  const visit = await arrive();
  const { page } = visit;
  const { dialog, show, lines } = chooserOf(visit);
  await show();
  await dialog.getByRole('button', { name: 'Keep it' }).click();
  const field = dialog.getByRole('textbox');
  await field.fill('Hall');
  await field.press('Enter');
  const copy = dialog.getByRole('button', { name: 'Duplicate Hall' });
  await copy.waitFor();
  expect(await field.evaluate((each) => each === document.activeElement)).toBe(true);
  await field.fill('Tower');
  const { x, y, width, height } = (await copy.boundingBox())!;
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await dialog.getByRole('button', { name: 'Duplicate Tower' }).waitFor();
  await page.mouse.up();
  await expect.poll(lines).toEqual(['Tower', 'Copy of Tower']);
});

test('where the browser stores nothing, a net too large for a link is not given up for another language, but saved first', async () => {
  const visit = await open('');
  const { page, script } = visit;
  await page.addInitScript(() => {
    IDBFactory.prototype.open = () => {
      throw new DOMException('No.', 'SecurityError');
    };
  });
  await page.reload();
  await script.waitForNet();
  await page.evaluate(async () => {
    await window.chebnet.open({ recipe: 'vault:vertices=4000' });
    const name = () => String.fromCharCode(...Array.from({ length: 40 }, () => 0x4e00 + 5000 * Math.random()));
    const handles = Array.from({ length: 2000 }, (_, vertex) => ({ vertex, name: name() }));
    await window.chebnet.setHandles(handles);
  });
  await page.getByText('does not let the page keep your net').waitFor();
  await page.getByRole('button', { name: 'Dismiss' }).click();
  // Nor for a project, but where it is asked for once more.
  const dataTransfer = await page.evaluateHandle(() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File(['{}'], 'other.chebnet.json'));
    return transfer;
  });
  const drop = () => page.dispatchEvent('canvas', 'drop', { dataTransfer });
  await drop();
  await page.getByText('would replace it for good').waitFor();
  await drop();
  await page.getByText('other.chebnet.json').waitFor();
  await page.getByRole('button', { name: 'Dismiss' }).first().click();
  await page.getByRole('button', { name: '中文' }).click();
  await page.getByText('does not let the page keep your net').waitFor();
  expect(await page.locator('html').getAttribute('lang')).toBe('en-US');
  expect((await script.stats()).handles).toBe(2000);
  await Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+s')]);
  await page.getByRole('button', { name: '中文' }).click();
  await page.locator('html[lang=zh-CN]').waitFor();
});

test('what is kept for the first time is listed at once, with its name, date and picture', async () => {
  const visit = await arrive('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const { dialog, show } = chooserOf(visit);
  await show();
  await dialog.getByRole('button', { name: 'Keep it' }).click();
  await dialog.getByText('open now').waitFor();
  await visit.page.screenshot({ path: join(OUTPUT, 'projects-first.png') });
  const field = dialog.getByRole('textbox');
  const name = await field.getAttribute('placeholder');
  expect(name).toMatch(/\w/);
  expect(await field.getAttribute('aria-label')).toBe(`Name of ${name}`);
  expect(await dialog.locator('li small').innerText()).toMatch(/\d.* · open now$/);
  await dialog.getByText('One that is open can be deleted once another one is open instead.').waitFor();
  const remove = dialog.getByRole('button', { name: /^Delete/ });
  expect([await remove.isDisabled(), await remove.getAttribute('title')]).toEqual([
    true,
    expect.stringMatching(/^It is open/),
  ]);
  const isDrawn = (canvas: HTMLCanvasElement) =>
    canvas
      .getContext('2d')!
      .getImageData(0, 0, canvas.width, canvas.height)
      .data.some((value) => value > 0);
  expect(await dialog.locator('canvas').evaluate(isDrawn)).toBe(true);
});

test('a broken project is refused with what is wrong, and the net stays', async () => {
  const { page, script } = await arrive();
  const before = await standing(script);
  await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    const text = '{"chebnet":1,"nets":[{"recipe":"vault"}],"positions":["????"],"states":[]}';
    dataTransfer.items.add(new File([text], 'net.chebnet.json'));
    document
      .getElementById('view')
      ?.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  });
  await expect.poll(() => page.getByRole('alert').innerText()).toMatch(/net\.chebnet\.json: positions\[0\] must be/);
  expect(await standing(script)).toEqual(before);
});

/** Another tab of the same visitor. */
async function newTab(first: Visit): Promise<Visit> {
  const page = await first.page.context().newPage();
  return { ...first, page, script: new Script(page) };
}

test('a link wins, and what was kept stays within reach', async () => {
  const first = await arrive();
  await first.script.open({ recipe: SHAPE });
  const before = await standing(first.script);
  await expect.poll(() => kept(first), PATIENCE).toHaveLength(2);

  const second = await newTab(first);
  await second.page.goto(new URL('#experiment=long-edges', first.page.url()).href);
  await second.script.waitForNet();
  await expect.poll(async () => (await second.script.stats()).method, PATIENCE).toBe('composite_majorization');
  await press(second, 'Restore my last net');
  await expect.poll(async () => (await second.script.stats()).method, PATIENCE).not.toBe('composite_majorization');
  expect(await standing(second.script)).toEqual(before);
});

test('what the page died of is offered, not opened', async () => {
  const visit = await arrive();
  const { page, script } = visit;
  await script.open({ recipe: SHAPE });
  const before = await standing(script);
  await expect.poll(() => kept(visit), PATIENCE).toHaveLength(2);
  // As if the page had died while it opened what it kept.
  await page.evaluate(() => localStorage.setItem('chebnet.opening', sessionStorage.getItem('chebnet.tab')!));
  await page.reload();
  await script.waitForNet();
  await expect.poll(() => said(visit), PATIENCE).toContainEqual(expect.stringMatching(/not opened again by itself/));
  expect((await script.stats()).vertices).toBeGreaterThan(1000);
  await page.screenshot({ path: join(OUTPUT, 'died-desktop.png') });
  await press(visit, 'Open it');
  await expect.poll(async () => (await script.stats()).vertices, PATIENCE).toBeLessThan(1000);
  expect(await standing(script)).toEqual(before);
  expect(await page.evaluate(() => localStorage.getItem('chebnet.opening'))).toBeNull();
});

test('a net at which the solver broke is offered, not opened, until it has gone on well', async () => {
  const visit = await arrive();
  const { page, script } = visit;
  await page.addInitScript(() => {
    window.workers = [];
    window.Worker = class extends Worker {
      constructor(address: string | URL, options?: WorkerOptions) {
        super(address, options);
        window.workers.push(this);
      }
    };
  });
  await script.open({ recipe: SHAPE });
  const before = await standing(script);
  await expect.poll(() => kept(visit), PATIENCE).toHaveLength(2);
  await page.reload();
  await script.waitForNet();
  expect(await standing(script)).toEqual(before);

  await page.evaluate(() => window.workers[0]!.dispatchEvent(new ErrorEvent('error', { message: 'out of memory' })));
  await expect.poll(() => page.getByRole('alert').innerText(), PATIENCE).toMatch(/started again.*out of memory/i);
  expect(await standing(script)).toEqual(before);
  await page.reload();
  await script.waitForNet();
  await expect.poll(() => said(visit), PATIENCE).toContainEqual(expect.stringMatching(/not opened again by itself/));
  await press(visit, 'Open it');
  await expect.poll(async () => (await script.stats()).vertices, PATIENCE).toBeLessThan(1000);
  await script.settled();
  await expect.poll(() => page.evaluate(() => localStorage.getItem('chebnet.opening')), PATIENCE).toBeNull();
});

test('two tabs keep a net each', async () => {
  const first = await arrive();
  await first.script.open({ recipe: SHAPE });
  const before = await standing(first.script);
  await expect.poll(() => kept(first), PATIENCE).toHaveLength(2);

  const second = await newTab(first);
  const { page } = second;
  await page.goto(first.page.url());
  await second.script.waitForNet();
  expect(await standing(second.script)).toEqual(before);
  await page.keyboard.press('Control+z');
  await expect.poll(() => kept(second), PATIENCE).toHaveLength(2);
  await Promise.all([first.page.reload(), page.reload()]);
  await Promise.all([first.script.waitForNet(), second.script.waitForNet()]);
  expect(await standing(first.script)).toEqual(before);
  expect((await second.script.stats()).vertices).toBeGreaterThan(1000);
});

test('what a tab has made of a link is there after a reload; the link opens as it was elsewhere', async () => {
  const maker = await arrive();
  await maker.script.open({ recipe: SHAPE });
  const link = await maker.page.evaluate(() => window.chebnet.link());
  const linked = await standing(maker.script);

  const visit = await newTab(maker);
  const { page, script } = visit;
  await page.goto(link);
  await script.waitForNet();
  await script.settled();
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await dragBy(script, vertex, [-30, 20]);
  await script.settled();
  const made = await standing(script);
  expect(made).not.toEqual(linked);
  await expect.poll(() => page.evaluate(() => sessionStorage.getItem('chebnet.link')), PATIENCE).toMatch(/^#/);
  await page.reload();
  await script.waitForNet();
  await expect.poll(() => standing(script), PATIENCE).toEqual(made);

  const other = await newTab(visit);
  await other.page.goto(link);
  await other.script.waitForNet();
  await expect.poll(() => standing(other.script), PATIENCE).toEqual(linked);
});

test('another net in place of a project with a name is a project of its own; what has the name stays as it was', async () => {
  const visit = await arrive();
  const { script } = visit;
  const { dialog, show, lines } = chooserOf(visit);
  await script.open({ recipe: SHAPE });
  const hall = await standing(script);
  await expect.poll(() => kept(visit), PATIENCE).toHaveLength(2);
  await show();
  await dialog.getByRole('textbox').fill('Hall');
  await dialog.getByRole('textbox').press('Enter');
  await expect.poll(lines).toEqual(['Hall']);
  await dialog.getByRole('button', { name: 'Close' }).click();

  await script.open({ recipe: 'saddle:vertices=400' });
  await script.settled();
  await show();
  await expect.poll(lines).toEqual(['', 'Hall']);
  await dialog.getByRole('button', { name: 'Close' }).click();
  // Its history goes back to where it came from.
  await press(visit, 'Undo');
  await expect.poll(() => standing(script)).toEqual(hall);
  await press(visit, 'Redo');

  await show();
  await dialog.getByRole('button', { name: 'Open Hall', exact: true }).click();
  await dialog.waitFor({ state: 'detached' });
  await expect.poll(() => standing(script)).toEqual(hall);
  await show();
  await expect.poll(lines).toEqual(['Hall', '']);
});
