/** The core for a first net: the same as the whole one, but for what it leaves out. */
import { afterEach, beforeEach, expect, test } from 'vitest';
import type { Editor } from '../../wasm/chebnet';
import { failure, firstEdit, load, loadFirst } from './load';

const RECIPE = 'dome:vertices=300';
const SQUARE = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n';

const [first, whole] = await Promise.all([loadFirst(), load()]);

let editor: Editor;
beforeEach(() => {
  editor = first.openRecipe(RECIPE);
});
afterEach(() => editor.dispose());

test('has all tables', () => {
  expect(first.methods()).toEqual(whole.methods());
  expect(first.shapes()).toEqual(whole.shapes());
  expect(first.initialisations()).toEqual(whole.initialisations());
  expect(first.formats()).toEqual(whole.formats());
  expect(first.options()).toEqual(whole.options());
});

const LEFT_OUT = ['wave', 'scroll', 'vase', 'teddy', 'rabbit', 'horse', 'jug', 'shirt'];

test('leaves out shapes that are relaxed, and some that are not asked for first', () => {
  for (const recipe of [...LEFT_OUT, 'elephant:smooth=1', 'jack:smooth=1'])
    expect(failure(() => first.openRecipe(recipe)).code).toBe('left_out');
});

const shapes = first.shapes().map(({ name }) => name);
test.each(shapes.filter((name) => !LEFT_OUT.includes(name)))(
  'edits the %s as the whole core does, to the last bit',
  (name) => {
    const [positions, expected] = [first, whole].map((core) => {
      const each = core.openRecipe(`${name}:vertices=300`);
      each.setHandles(firstEdit(each));
      expect(['converged', 'exact']).toContain(each.solve().status);
      const result = each.positions();
      each.dispose();
      return result;
    });
    expect(positions).toEqual(expected);
  },
);

test.each([
  '300',
  '+300',
  '3e2',
  '.3E+3',
  '300.',
  '0300',
  '300.5',
  '3e999',
  '-300',
  '0x12c',
  '3_00',
  ' 300',
  '',
  '.',
  '+',
  '+-300',
  '3e',
  'many',
])('takes "%s" for the number that the whole core takes it for', (text) => {
  const [here, there] = [first, whole].map((core) => {
    try {
      const each = core.openRecipe(`dome:vertices=${text}`);
      each.dispose();
      return each.info.vertices;
    } catch (error) {
      return (error as Error).message;
    }
  });
  expect(here).toBe(there);
});

test.each([0.1 + 0.2, 1 / 3, 5e-324, 1e-6, 12345.67890123456])('keeps every bit of the option %d', (value) => {
  editor.setOption('switch_deviation', value);
  expect(editor.options().switch_deviation).toBe(value);
});

test('knows the method it begins with, and refuses those left out without a change', () => {
  const has = ({ name }: { name: string }) => {
    const method = editor.method;
    try {
      editor.setMethod(name);
      return true;
    } catch (error) {
      expect(error).toMatchObject({ code: 'left_out' });
      expect(editor.method).toBe(method);
      return false;
    }
  };
  expect(
    first
      .methods()
      .filter(has)
      .map(({ name }) => name),
  ).toEqual(['equilibrium']);
});

test('leaves files out, and still says what is wrong with a name', () => {
  expect(failure(() => first.openObj(SQUARE)).code).toBe('left_out');
  expect(failure(() => editor.toObj()).code).toBe('left_out');
  expect(failure(() => editor.toFile('ply')).code).toBe('left_out');
  expect(failure(() => editor.toFile('dwg' as never)).code).toBe('bad_option');
  expect(failure(() => editor.setMethod('magic')).code).toBe('bad_option');
});

test('leaves surfaces out, also as guides', () => {
  const surface = whole.ownSurface('hemisphere');
  expect(failure(() => first.ownSurface('hemisphere')).code).toBe('left_out');
  expect(failure(() => editor.setGuide(surface)).code).toBe('left_out');
  editor.setGuide(null);
  surface.dispose();
});
