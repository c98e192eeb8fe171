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
  expect(first.options()).toEqual(whole.options());
});

test.each(first.shapes().map(({ name }) => name))('edits the %s as the whole core does, to the last bit', (name) => {
  const [positions, expected] = [first, whole].map((core) => {
    const each = core.openRecipe(`${name}:vertices=300`);
    each.setHandles(firstEdit(each));
    expect(each.solve().status).toBe('converged');
    const result = each.positions();
    each.dispose();
    return result;
  });
  expect(positions).toEqual(expected);
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
  expect(first.methods().filter(has).map(({ name }) => name)).toEqual(['projection', 'gauss_newton', 'arap', 'local_global']);
});

test('leaves files out, and still says what is wrong with a name', () => {
  expect(failure(() => first.openObj(SQUARE)).code).toBe('left_out');
  expect(failure(() => editor.toObj()).code).toBe('left_out');
  expect(failure(() => editor.toFile('ply')).code).toBe('left_out');
  expect(failure(() => editor.toFile('dwg' as never)).code).toBe('bad_option');
  expect(failure(() => editor.setMethod('magic')).code).toBe('bad_option');
});
