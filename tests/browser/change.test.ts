/** The net itself is changed: finer, coarser, cut, shorter and longer, each exact and undone in a step. */
import { join } from 'node:path';
import { beforeEach, expect, test } from 'vitest';
import { load } from '../wasm/load';
import { vertexAt } from './geometry';
import { OUTPUT, room, type Script, type Visit, visits } from './page';

const SHAPE = 'vault:vertices=300';
const net = (await load()).openRecipe(SHAPE);

const { arrive, share } = visits();
let visit: Visit;
let script: Script;

beforeEach(async () => {
  visit = await share();
  ({ script } = visit);
  await script.open({ recipe: SHAPE });
  await script.settled();
  await visit.page.locator('summary', { hasText: /^Change the net$/ }).click();
});

const section = () => visit.page.locator('details', { hasText: /^Change the net/ });
const press = (name: string) => section().getByRole('button', { name, exact: true }).click();
const vertices = async () => (await script.stats()).vertices;

const undo = () => visit.page.keyboard.press('Control+z');
const width = async () => {
  const positions = await script.positions();
  const x = positions.filter((_, i) => i % 3 === 0);
  return Math.max(...x) - Math.min(...x);
};

/** The vertices in the middle of the borders to the left and to the right. */
async function middlesOfSides(): Promise<[number, number]> {
  const positions = await script.positions();
  const numbers = Array.from({ length: positions.length / 3 }, (_, vertex) => vertex);
  const towards = (sign: number) => (v: number) => sign * positions[3 * v]! - 0.2 * Math.abs(positions[3 * v + 1]!);
  const first = (value: (v: number) => number) => numbers.reduce((a, b) => (value(b) > value(a) ? b : a));
  return [first(towards(-1)), first(towards(1))];
}

/** Clicks on a handle. */
async function choose(vertex: number): Promise<void> {
  const { x, y } = await script.screenPosition(vertex);
  await visit.page.mouse.click(x, y);
  await section().getByText('At the chosen handle:').waitFor();
}

async function becomes(count: (before: number) => number, name: string): Promise<void> {
  const wanted = count(await vertices());
  await press(name);
  await expect.poll(vertices).toBe(wanted);
  await script.settled();
  // The dialog gives the focus back.
  expect(await visit.page.evaluate(() => document.activeElement?.textContent)).toBe(name);
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-9);
}

test('the list of lines says what to do as long as there are none', async () => {
  const line = section().getByRole('combobox', { name: 'Line' });
  const told = () => line.locator('option').allTextContents();
  expect(await told()).toEqual(['choose a handle first']);
  const { vertex } = (await visit.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await choose(vertex);
  expect(await told()).toContain('Net line 1');
  await visit.page.locator('#view canvas').focus();
  await visit.page.keyboard.press('Escape');
  await expect.poll(told).toEqual(['choose a handle first']);
});

test('so fine that it does not come to rest any more, and back, which is said with the reason', async () => {
  await script.open({ recipe: 'vault:vertices=3200' });
  await script.settled();
  const behaviour = () => visit.page.getByRole('combobox', { name: 'The net', exact: true }).inputValue();
  expect(await behaviour()).toBe('shape');
  await press('Refine');
  await visit.page
    .getByText(/^The net has 12,\d+ vertices now\. Beyond 12,000 vertices, .* the net keeps its lengths alone now\./)
    .waitFor({ timeout: 60_000 });
  expect(await behaviour()).toBe('lengths');
  await press('Coarsen');
  await visit.page
    .getByText(/^The net has 3,\d+ vertices now\. .* it comes to rest again\.$/)
    .waitFor({ timeout: 60_000 });
  expect(await behaviour()).toBe('shape');
});

test('says which pieces a coarser net has lost', async () => {
  // A strip one cell wide beside a piece of four by four.
  const grid = (x: number, wide: number, first: number): [string[], string[]] => {
    const corner = (i: number, j: number) => first + 5 * i + j;
    const columns = Array.from({ length: wide + 1 }, (_, i) => i);
    const corners = columns.flatMap((i) => [0, 1, 2, 3, 4].map((j) => `v ${x + i} ${j} 0`));
    const faces = columns
      .slice(1)
      .flatMap((i) =>
        [1, 2, 3, 4].map((j) => `f ${corner(i - 1, j - 1)} ${corner(i, j - 1)} ${corner(i, j)} ${corner(i - 1, j)}`),
      );
    return [corners, faces];
  };
  const [wide, narrow] = [grid(0, 4, 1), grid(6, 1, 26)];
  const obj = [...wide[0], ...narrow[0], ...wide[1], ...narrow[1]].join('\n');
  await script.open({ obj });
  await script.settled();
  await press('Coarsen');
  await visit.page
    .getByText('The net has 9 vertices now. One piece was too narrow to be coarser, and is gone.')
    .waitFor();
});

test('says which lengths are allowed, beside the field, until it holds one', async () => {
  const length = section().getByRole('spinbutton', { name: 'Edge length' });
  const note = section().getByText('Allowed: a number from');
  const description = async () =>
    (await length.getAttribute('aria-describedby')) === (await note.getAttribute('id')) && note.getAttribute('role');
  await length.fill('0');
  await length.press('Enter');
  await note.waitFor();
  expect(await note.textContent()).toMatch(/^Allowed: a number from [\d.]+(e-\d+)? to [\d,]+\.$/);
  expect(await description()).toBe('status');
  expect(await length.getAttribute('aria-invalid')).toBe('true');
  await visit.page.screenshot({ path: join(OUTPUT, 'change-allowed.png') });
  await length.press('2');
  await note.waitFor({ state: 'detached' });
  expect(await length.getAttribute('aria-describedby')).toBeNull();

  // The field shows the net's own length again as soon as that moves.
  await length.fill('-1');
  await length.blur();
  await note.waitFor();
  await choose(net.suggestedHandles.at(-1)!);
  await visit.page.keyboard.press('ArrowUp');
  await note.waitFor({ state: 'detached' });
  expect(Number(await length.inputValue())).toBeCloseTo(net.info.meanLength, 4);
});

test('finer, another length, and back', async () => {
  const first = await vertices();
  const handles = (await visit.page.evaluate(() => window.chebnet.handles())).map(({ vertex }) => vertex);
  const edgeLength = async () => Number(await section().getByLabel('Edge length').inputValue());
  const length = net.info.meanLength;
  await expect.poll(edgeLength).toBeCloseTo(length, 4);
  await press('Refine');
  await visit.page.getByText(/^The net has [\d,]+ vertices now\.$/).waitFor();
  await script.settled();
  expect(await vertices()).toBeGreaterThan(3.5 * first);
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-9);
  expect((await visit.page.evaluate(() => window.chebnet.handles())).map(({ vertex }) => vertex)).toEqual(handles);
  await expect.poll(edgeLength).toBeCloseTo(length / 2, 4);
  await visit.page.screenshot({ path: join(OUTPUT, 'change-refined.png') });

  const fine = await vertices();
  await becomes(() => first, 'Coarsen');
  // From where a hand has gone with the camera, too, all of it is seen.
  await visit.page.mouse.move(600, 760);
  await visit.page.mouse.down();
  await visit.page.mouse.move(560, 750, { steps: 4 });
  await visit.page.mouse.up();
  await section().getByLabel('Edge length').fill('2');
  await press('Apply');
  await expect.poll(width).toBeGreaterThan(20);
  await expect.poll(() => room(visit.page)).toBeGreaterThan(40);

  await undo();
  await expect.poll(width).toBeLessThan(20);
  await undo();
  await expect.poll(vertices).toBe(fine);
  await undo();
  await expect.poll(vertices).toBe(first);
});

test('a changed net is seen from the side from which it was, and so is one from a link to it', async () => {
  // The net has x to the right, from the front.
  const isSeenFromBehind = async (script: Script) => {
    const positions = await script.positions();
    const xs = Array.from({ length: positions.length / 3 }, (_, vertex) => positions[3 * vertex]!);
    const [left, right] = await Promise.all(
      [Math.min(...xs), Math.max(...xs)].map((x) => script.screenPosition(xs.indexOf(x))),
    );
    return left!.x > right!.x;
  };
  // Its arch is at the back, and is to be taken hold of first.
  await script.open({ recipe: 'canopy:vertices=300' });
  await script.settled();
  expect(await isSeenFromBehind(script)).toBe(true);
  const whole = await vertices();
  await press('Refine');
  await expect.poll(vertices).toBeGreaterThan(whole);
  await script.settled();
  expect(await isSeenFromBehind(script)).toBe(true);
  const link = await visit.page.evaluate(() => window.chebnet.link());
  expect(await isSeenFromBehind((await arrive(link)).script)).toBe(true);
});

test('in another size the surface beside it has that size, too', async () => {
  await visit.page.evaluate(() => window.chebnet.setGuide({ own: 'shell' }));
  const guide = visit.page.getByRole('group', { name: 'Surface: Free-form shell' });
  await guide.waitFor();
  const distance = async () => (await visit.page.evaluate(() => window.chebnet.report())).meanDistance;
  await script.settled();
  const before = await distance();
  const length = Number(await section().getByLabel('Edge length').inputValue());
  await section()
    .getByLabel('Edge length')
    .fill(String(2 * length));
  await press('Apply');
  await visit.page.getByText(/^The edges are [\d.]+ long now\.$/).waitFor();
  await script.settled();
  await guide.waitFor();
  expect((await distance()) / before).toBeCloseTo(2, 1);
});

test('a line is cut, one side goes, a row comes, and a reason is given where it cannot be', async () => {
  const { vertex } = (await visit.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  expect(await section().getByRole('button', { name: 'Cut', exact: true }).isEnabled()).toBe(false);
  await choose(vertex);
  await section().getByRole('button', { name: 'Cut', exact: true }).hover();
  await visit.page.screenshot({ path: join(OUTPUT, 'change-line.png') });
  await press('Add a row');
  await visit.page.getByText(/where rows are added: choose a vertex there/).waitFor();

  const whole = await vertices();
  await press('Cut');
  await visit.page.getByText(/It has 2 pieces\./).waitFor();
  await expect.poll(vertices).toBeGreaterThan(whole);
  const line = (await vertices()) - whole;
  await press('Join borders');
  await expect.poll(vertices).toBe(whole);

  await choose(vertex);
  await press('Keep the smaller side');
  await visit.page.getByText(/handles are gone: their vertices are no more/).waitFor();
  await expect.poll(vertices).toBeLessThan(whole);
  await script.settled();
  const half = await vertices();
  const kept = await visit.page.evaluate(() => window.chebnet.handles().at(-1)!.vertex);
  await choose(kept);
  await section().getByLabel('Line').selectOption('Net line 2');
  await visit.page.screenshot({ path: join(OUTPUT, 'change-half.png') });
  expect(half).toBeGreaterThan(line);
});

test('a change is awaited, and undo takes back one that is under way, before and after its net is opened', async () => {
  await script.open({ recipe: 'vault:vertices=8000' });
  await script.settled();
  const coarse = await vertices();
  await press('Refine');
  await visit.page.getByRole('dialog', { name: 'The net is being changed' }).waitFor();
  await undo();
  await script.settled();
  await expect.poll(vertices).toBe(coarse);
  expect(await visit.page.getByRole('dialog').count()).toBe(0);

  await press('Refine');
  await script.settled();
  expect(await vertices()).toBeGreaterThan(3 * coarse);
  // The net before is opened again; what is undone meanwhile is the step before it.
  await undo();
  await undo();
  await expect.poll(vertices).toBe(net.info.vertices);
});

test('what is said of a change goes as that is undone', async () => {
  const whole = await vertices();
  await choose(net.suggestedHandles.at(-1)!);
  await press('Keep the smaller side');
  const said = visit.page.getByText(/handles are gone: their vertices are no more/);
  await said.waitFor();
  await undo();
  await expect.poll(vertices).toBe(whole);
  // It would go by itself some seconds later.
  expect(await said.count()).toBe(0);
});

test('pieces are kept and deleted while one without a chosen handle is left', async () => {
  await choose(net.suggestedHandles.at(-1)!);
  await press('Cut');
  await visit.page.getByText(/It has 2 pieces\./).waitFor();
  await script.settled();
  const [keep, remove] = ['Keep only this piece', 'Delete this piece'].map((name) =>
    section().getByRole('button', { name }),
  );
  await visit.page.locator('#view canvas').press('Control+a');
  await section()
    .getByText(/^At the \d+ chosen handles/)
    .waitFor();
  for (const button of [keep!, remove!]) {
    expect(await button.isDisabled()).toBe(true);
    expect(await button.getAttribute('title')).toMatch(/^Every piece of the net has a chosen handle/);
  }
  expect(await section().getByRole('button', { name: 'Delete faces at the handles' }).isEnabled()).toBe(true);
  await visit.page.screenshot({ path: join(OUTPUT, 'change-pieces.png') });

  await choose((await visit.page.evaluate(() => window.chebnet.handles()))[0]!.vertex);
  for (const button of [keep!, remove!]) {
    expect(await button.isEnabled()).toBe(true);
    expect(await button.getAttribute('title')).toMatch(/^Deletes /);
  }
});

test('a row is put in and taken out, and the way through two handles is cut', async () => {
  const { vertex } = (await visit.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const before = await vertices();
  await choose(vertex);
  await press('Put a row in');
  await expect.poll(vertices).toBeGreaterThan(before);
  await script.settled();
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-9);
  await visit.page.screenshot({ path: join(OUTPUT, 'change-inserted.png') });
  const [kept] = (await visit.page.evaluate(() => window.chebnet.handles())).slice(-1);
  await choose(kept!.vertex);
  await press('Take the line out');
  await expect.poll(vertices).toBe(before);

  await script.settled();
  const ends = await middlesOfSides();
  await script.setHandles([ends[0], vertex, ends[1]].map((each) => ({ vertex: each })));
  await script.settled();
  await choose(ends[0]);
  await visit.page.keyboard.down('Shift');
  for (const next of [vertex, ends[1]]) {
    const { x, y } = await script.screenPosition(next);
    await visit.page.mouse.click(x, y);
  }
  await visit.page.keyboard.up('Shift');
  await section().getByText('At the 3 chosen handles').waitFor();
  await section().getByLabel('Line').selectOption('Way through the handles');
  await section().getByRole('button', { name: 'Cut', exact: true }).hover();
  await expect.poll(() => visit.page.locator('path.preview').getAttribute('d')).toMatch(/(?:h0M.*){8}/);
  await visit.page.screenshot({ path: join(OUTPUT, 'change-way.png') });
  await press('Cut');
  await visit.page.getByText(/It has 2 pieces\./).waitFor();
});

/** Where a part of the way across the net in x and y is on the screen. */
async function placeAt(u: number, v: number): Promise<{ x: number; y: number }> {
  const positions = await script.positions();
  return script.screenPosition(vertexAt(positions, u, v));
}

/** Until the camera rests. */
async function lookFromAbove(): Promise<void> {
  await visit.page.locator('#view canvas').press('7');
  let before = '';
  const rests = async () => before === (before = JSON.stringify(await script.screenPosition(0)));
  await expect.poll(rests).toBe(true);
}

async function takePen(): Promise<void> {
  await lookFromAbove();
  await press('Draw a line');
  await section().getByRole('button', { name: 'Draw a line', pressed: true }).waitFor();
}

/** Draws a line through places on the screen with the mouse. */
async function draw(places: readonly { x: number; y: number }[]): Promise<void> {
  const { mouse } = visit.page;
  await mouse.move(places[0]!.x, places[0]!.y);
  await mouse.down();
  for (const { x, y } of places.slice(1)) await mouse.move(x, y, { steps: 8 });
  await mouse.up();
}

/** Goes on beyond the last of two places, as far as it was from the first. */
const beyond = (from: { x: number; y: number }, to: { x: number; y: number }) => ({
  x: to.x + 0.2 * (to.x - from.x),
  y: to.y + 0.2 * (to.y - from.y),
});

test('a line is drawn from border to border, the net is cut along it or one side goes, and that is undone', async () => {
  const whole = await vertices();
  const drawAcross = async () => {
    await takePen();
    const [left, right] = [await placeAt(0, 0.35), await placeAt(1, 0.75)];
    await draw([beyond(right, left), beyond(left, right)]);
  };
  await drawAcross();
  await section()
    .getByText(/^The line parts the net\. Faded is the smaller side, \d+ of \d+ faces\.$/)
    .waitFor();
  expect(await section().getByLabel('Line').inputValue()).toBe('drawn');
  await expect.poll(() => visit.page.locator('path.preview').getAttribute('d')).toMatch(/(?:h0M.*){8}/);
  await visit.page.screenshot({ path: join(OUTPUT, 'change-drawn.png') });

  await press('Cut');
  await visit.page.getByText(/It has 2 pieces\./).waitFor();
  await expect.poll(vertices).toBeGreaterThan(whole);
  await expect.poll(() => visit.page.locator('path.preview').getAttribute('d')).toBe('');
  await undo();
  await expect.poll(vertices).toBe(whole);

  await drawAcross();
  await press('Keep the larger side');
  await expect.poll(vertices).toBeLessThan(whole);
  await script.settled();
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-9);
  await visit.page.screenshot({ path: join(OUTPUT, 'change-trimmed.png') });
  await undo();
  await expect.poll(vertices).toBe(whole);
});

test('a part that a line goes round is taken out, and a line that misses the net is named', async () => {
  const whole = await vertices();
  await takePen();
  const ring = await Promise.all(
    Array.from({ length: 17 }, (_, k) => (2 * Math.PI * k) / 16).map((angle) =>
      placeAt(0.5 + 0.25 * Math.cos(angle), 0.5 + 0.25 * Math.sin(angle)),
    ),
  );
  const { x, y } = (await visit.page.locator('#view canvas').boundingBox())!;
  await draw([
    { x: x + 20, y: y + 200 },
    { x: x + 60, y: y + 300 },
  ]);
  await section().getByText('This line misses the net.').waitFor();
  const { mouse } = visit.page;
  const corner = await script.screenPosition(0);
  await mouse.down({ button: 'right' });
  await mouse.move(x + 80, y + 330, { steps: 4 });
  await mouse.up({ button: 'right' });
  await expect.poll(() => script.screenPosition(0)).not.toEqual(corner);
  await section().getByText('This line misses the net.').waitFor();
  await lookFromAbove();
  await draw(ring);
  await section()
    .getByText(/^The line parts the net\./)
    .waitFor();
  await visit.page.screenshot({ path: join(OUTPUT, 'change-ring.png') });
  await press('Keep the smaller side');
  await expect.poll(vertices).toBeLessThan(whole / 2);
  await undo();
  await expect.poll(vertices).toBe(whole);

  await takePen();
  await draw([await placeAt(0.3, 0.5), await placeAt(0.7, 0.5)]);
  await section()
    .getByText(/^The line parts nothing off:/)
    .waitFor();
  for (const name of ['Keep the larger side', 'Keep the smaller side'])
    expect(await section().getByRole('button', { name }).isDisabled()).toBe(true);
  await visit.page.keyboard.press('Escape');
  expect(await section().getByRole('button', { name: 'Draw a line' }).getAttribute('aria-pressed')).toBe('false');
  await press('Remove it');
  await expect.poll(() => visit.page.locator('path.preview').getAttribute('d')).toBe('');
});

test('by keys a point is moved over the net, set down and lifted; a line across it is cut along', async () => {
  const whole = await vertices();
  await lookFromAbove();
  const draw = section().getByRole('button', { name: 'Draw a line' });
  await draw.press('Enter');
  const sheet = visit.page.getByRole('application', { name: /^Sheet to draw on/ });
  await expect.poll(() => sheet.evaluate((element) => element === document.activeElement)).toBe(true);
  expect(await sheet.locator('.point').getAttribute('visibility')).toBe('visible');
  // From beyond the one border to beyond the other, whichever way the picture shows the net.
  for (let step = 0; step < 20; step++) await sheet.press('Shift+ArrowLeft');
  await sheet.press(' ');
  for (let step = 0; step < 30; step++) await sheet.press('Shift+ArrowRight');
  await sheet.press('ArrowDown');
  await visit.page.screenshot({ path: join(OUTPUT, 'change-drawn-by-keys.png') });
  await sheet.press('Escape');
  await section()
    .getByText(/^The line/)
    .waitFor({ state: 'detached' });
  await sheet.press(' ');
  for (let step = 0; step < 40; step++) await sheet.press('Shift+ArrowLeft');
  await sheet.press('Enter');
  await section()
    .getByText(/^The line parts the net\. Faded is the smaller side, \d+ of \d+ faces\.$/)
    .waitFor();
  await sheet.press('Escape');
  await sheet.waitFor({ state: 'detached' });
  expect(await draw.evaluate((element) => element === document.activeElement)).toBe(true);
  await section().getByRole('button', { name: 'Cut', exact: true }).press('Enter');
  await visit.page.getByText(/It has 2 pieces\./).waitFor();
  await expect.poll(vertices).toBeGreaterThan(whole);
});

test('on a phone a finger draws, and two fingers move the view without drawing', async () => {
  visit = await share({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  ({ script } = visit);
  await script.open({ recipe: SHAPE });
  await script.settled();
  await visit.page.getByRole('button', { name: 'Controls' }).click();
  await visit.page.locator('summary', { hasText: /^Change the net$/ }).click();
  const session = await visit.page.context().newCDPSession(visit.page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', touchPoints: { x: number; y: number }[]) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints });
  await takePen();
  const ends = async () => [await placeAt(0, 0.35), await placeAt(1, 0.75)] as const;
  const width = ([left, right]: readonly { x: number; y: number }[]) =>
    Math.hypot(right!.x - left!.x, right!.y - left!.y);

  const before = await ends();
  const [left, right] = before;
  await touch('touchStart', [left]);
  await touch('touchStart', [left, right]);
  for (const k of [1, 2, 3]) await touch('touchMove', [left, { x: right.x + 10 * k, y: right.y }]);
  await touch('touchEnd', []);
  await expect.poll(async () => width(await ends())).toBeGreaterThan(1.1 * width(before));
  await section()
    .getByText(/^Draw on the net:/)
    .waitFor();

  const [from, to] = await ends();
  const [start, end] = [beyond(to, from), beyond(from, to)];
  await touch('touchStart', [start]);
  for (const k of [1, 2, 3, 4])
    await touch('touchMove', [{ x: start.x + ((end.x - start.x) * k) / 4, y: start.y + ((end.y - start.y) * k) / 4 }]);
  await touch('touchEnd', []);
  await section()
    .getByText(/^The line parts the net\./)
    .waitFor();
  await visit.page.screenshot({ path: join(OUTPUT, 'change-phone.png') });
  await press('Keep the larger side');
  await visit.page.getByText(/^The net has [\d,]+ vertices now\./).waitFor();
});
