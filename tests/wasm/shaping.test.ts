/** Soft handles, locality and reach, across the border. */
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import type { Axes, Editor, Handle, Point } from '../../wasm/chebnet';
import { type InHand, limitsOf, nearestInAll, translated } from '../../web/src/handles/reach';
import { failure, firstEdit, load } from './load';

const chebnet = await load();

let editor: Editor;
let handles: Handle[];
let dragged: Handle;
beforeEach(() => {
  editor = chebnet.openRecipe('elephant:vertices=900');
  handles = firstEdit(editor);
  dragged = handles.at(-1)!;
});
afterEach(() => editor.dispose());

const offTarget = ({ vertex, target }: Handle): number =>
  Math.hypot(
    ...editor
      .positions()
      .subarray(3 * vertex, 3 * vertex + 3)
      .map((x, axis) => x - target[axis]!),
  );

describe('soft handles', () => {
  test('come back with their weights; exact ones have none', () => {
    editor.setHandles([...handles.slice(0, -1), { ...dragged, weight: 0.5 }]);
    expect(editor.handles().at(-1)).toEqual({ ...dragged, weight: 0.5 });
    expect(editor.handles()[0]).toEqual(handles[0]);
  });

  test('pull the closer to their targets the heavier they are, and edges stay exact', () => {
    const distances = [0.01, 1, 100].map((weight) => {
      editor.reset();
      editor.setHandles([...handles.slice(0, -1), { ...dragged, weight }]);
      expect(editor.solve()).toMatchObject({ status: 'converged' });
      expect(Math.max(...editor.fields().deviation)).toBeLessThan(1e-6);
      return offTarget(dragged);
    });
    expect(distances[0]).toBeGreaterThan(distances[1]!);
    expect(distances[1]).toBeGreaterThan(distances[2]!);
    expect(editor.handleError()).toBe(0);
  });

  test('are refused with a weight that is none, or by a method that knows none', () => {
    for (const weight of [0, -1, NaN, '1' as unknown as number]) {
      expect(failure(() => editor.setHandles([{ ...dragged, weight }])).code).toBe('bad_option');
    }
    editor.setMethod('li2022');
    expect(failure(() => editor.setHandles([{ ...dragged, weight: 1 }]))).toMatchObject({
      code: 'bad_option',
      message: expect.stringContaining('li2022'),
    });
  });
});

describe('handles that slide', () => {
  const target: [number, number, number] = [0, 0, 1.5];
  const crown: Handle = { vertex: 60, target };
  const foot = (vertex: number, slides: Axes): Handle => ({
    vertex,
    target: [...sheet.restPositions.slice(3 * vertex, 3 * vertex + 3)] as Point,
    slides,
  });
  const FEET = [5, 55, 65, 115];
  let sheet: Editor;
  beforeEach(() => {
    sheet = chebnet.openRecipe('sheet:vertices=121');
  });
  afterEach(() => sheet.dispose());

  test('come back with their axes, at targets that have followed them on the ground, which they do not leave', () => {
    sheet.setHandles([...FEET.map((vertex) => foot(vertex, 'xy')), crown]);
    expect(sheet.solve()).toMatchObject({ status: 'converged' });
    const positions = sheet.positions();
    const handles = sheet.handles();
    for (const [i, vertex] of FEET.entries()) {
      const [x, y, z] = positions.subarray(3 * vertex, 3 * vertex + 3);
      expect(handles[i]).toEqual({ vertex, target: [x, y, z], slides: 'xy' });
      expect(z).toBe(0);
      expect(Math.hypot(x!, y!)).toBeLessThan(Math.hypot(...foot(vertex, 'xy').target) - 0.05);
    }
    expect(sheet.unreachablePairs()).toEqual([]);
    const other = chebnet.openRecipe('sheet:vertices=121');
    other.setState(sheet.state());
    expect(other.state()).toEqual(sheet.state());
    other.dispose();
  });

  test('are refused along all axes or none by name, and if they are soft', () => {
    for (const slides of ['', 'xyz', 'yx', 3, null]) {
      expect(failure(() => sheet.setHandles([{ ...crown, slides: slides as Axes }])).code).toBe('bad_option');
    }
    expect(failure(() => sheet.setHandles([{ ...crown, slides: 'x', weight: 1 }]))).toMatchObject({
      code: 'bad_option',
      message: expect.stringContaining('only exact handles slide'),
    });
  });
});

test('what is flipped has its handles where they are, and the rest elsewhere; unheld it cannot be', () => {
  editor.setHandles(handles);
  expect(editor.solve()).toMatchObject({ status: 'converged' });
  const before = editor.positions().slice();
  const flipped = editor.flipped();
  const place = (positions: Float64Array, vertex: number) => [...positions.subarray(3 * vertex, 3 * vertex + 3)];
  for (const { vertex, target } of handles) expect(place(flipped, vertex)).toEqual([...target]);
  expect(flipped.length).toBe(before.length);
  expect(flipped).not.toEqual(before);
  editor.setHandles([]);
  expect(failure(() => editor.flipped())).toMatchObject({
    code: 'bad_option',
    message: expect.stringContaining('no exact handle'),
  });
});

describe('locality', () => {
  test.each([
    ['teddy', 12, ['converged']],
    // This part is rigid but for a few corners: it has its lengths, and comes to rest or not as rounding has it.
    ['elephant', 9, ['converged', 'exact']],
  ])('keeps what lies beyond exactly where it is: %s', (shape, radius, ends) => {
    editor.dispose();
    editor = chebnet.openRecipe(`${shape}:vertices=900`);
    handles = firstEdit(editor);
    dragged = handles.at(-1)!;
    const before = editor.positions();
    const mobility = editor.mobility(radius, [dragged.vertex]);
    editor.setHandles(
      handles.map(({ vertex }) => ({
        vertex,
        target: [...before.subarray(3 * vertex, 3 * vertex + 3)] as Handle['target'],
      })),
    );
    editor.setLocality(radius, [dragged.vertex]);
    const [x, y, z] = before.subarray(3 * dragged.vertex, 3 * dragged.vertex + 3);
    editor.moveHandle(dragged.vertex, [x!, y!, z! + editor.info.meanLength]);
    expect(ends).toContain(editor.solve().status);
    expect(Math.max(...editor.fields().deviation)).toBeLessThan(1e-6);
    const after = editor.positions();
    let moved = 0;
    for (let v = 0; v < mobility.length; v++) {
      const stays = [0, 1, 2].every((axis) => before[3 * v + axis] === after[3 * v + axis]);
      if (mobility[v] === 0) expect(stays).toBe(true);
      else if (!stays) moved += 1;
    }
    expect(moved).toBeGreaterThan(20);
  });

  test('is told as long as it holds', () => {
    expect(editor.state().locality).toBe(null);
    editor.setLocality(9, [dragged.vertex]);
    editor.setMethod('li2022');
    expect(editor.state().locality).toMatchObject({ radius: 9, origins: [dragged.vertex] });
    editor.setHandles(handles);
    expect(editor.state().locality).toBe(null);
  });

  test('is refused if it is no length or nowhere', () => {
    expect(failure(() => editor.setLocality(0, [1])).code).toBe('bad_option');
    expect(failure(() => editor.setLocality(5, [1e6])).code).toBe('index_out_of_range');
  });
});

describe('the reach', () => {
  const far: Handle['target'] = [1e3, 0, 500];
  const move = (inHand: readonly InHand[], translation: Handle['target']) =>
    inHand.forEach((each) => editor.moveHandle(each.vertex, translated(each, translation)));

  test.each([1, 3])(
    'of the last of the handles, %d together, ends where the core calls others unreachable',
    (count) => {
      editor.setHandles(handles);
      const others = handles.slice(0, -1).map(({ vertex }) => vertex);
      expect(others).toEqual(expect.arrayContaining(editor.reach(dragged.vertex).map(({ vertex }) => vertex)));
      const inHand = handles
        .slice(-count)
        .map(({ vertex, target }): InHand => ({ vertex, base: target, follows: [1, 1, 1] }));
      const limits = limitsOf(
        inHand,
        inHand.map(({ vertex }) => editor.reach(vertex)),
      );
      move(inHand, far);
      expect(editor.unreachablePairs()).not.toEqual([]);
      move(inHand, nearestInAll(limits, far));
      expect(editor.unreachablePairs()).toEqual([]);
    },
  );

  test('within a locality ends at its border too', () => {
    editor.setHandles(handles);
    const base = dragged.target;
    const inHand: InHand[] = [{ vertex: dragged.vertex, base, follows: [1, 1, 1] }];
    editor.setLocality(5, [dragged.vertex]);
    const held = nearestInAll(limitsOf(inHand, [editor.reach(dragged.vertex)]), far);
    expect(Math.hypot(...held)).toBeLessThan(10 * editor.info.meanLength);
    move(inHand, held);
    expect(editor.unreachablePairs()).toEqual([]);
  });
});
