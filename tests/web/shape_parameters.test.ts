/** Sliders of a shape that are moved faster than its nets open. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { ShapeInfo } from '../../wasm/chebnet';
import { ShapeParameters } from '../../web/src/sidebar/shape_parameters';
import { type DocumentHere, documentHere, type ElementHere } from './elements_here';

const parameter = (name: string) => ({ name, value: 4, smallest: 0, largest: 200, sentence: '' });
const shapes: ShapeInfo[] = ['vault', 'dome'].map((name) => ({
  name,
  title: name,
  sentence: '',
  parameters: [parameter('rise'), parameter('span')],
  offered: name,
}));

let page: DocumentHere;
let sliders: ShapeParameters;
let rise: ElementHere;
let span: ElementHere;
let asked: string[];
let ends: () => void;

const afterwards = () => new Promise((resolve) => setTimeout(resolve));
const open = (recipe: string) => sliders.setRecipe(recipe, shapes);

function slider(name: string): ElementHere {
  return page.all('input').find(({ dataset }) => dataset['parameter'] === name)!;
}

function move(input: ElementHere, to: number): void {
  input.focus();
  input.value = String(to);
  input.tell('input');
  input.tell('change');
}

beforeEach(() => {
  page = documentHere();
  asked = [];
  sliders = new ShapeParameters((recipe) => {
    asked.push(recipe);
    return new Promise((resolve) => (ends = resolve));
  });
  open('vault');
  [rise, span] = [slider('rise'), slider('span')];
});
afterEach(() => vi.unstubAllGlobals());

test('the one that keys move stays ahead of nets that open meanwhile', async () => {
  move(rise, 10);
  move(rise, 20);
  open('vault:rise=10');
  expect(rise.value).toBe('20');
  open('vault:rise=20');
  ends();
  await afterwards();
  expect(rise.value).toBe('20');
  // Undo takes it along again.
  open('vault:rise=10');
  expect(rise.value).toBe('10');
});

test('one that is in hand again stays there when the net before is open', async () => {
  move(rise, 10);
  rise.value = '20';
  rise.tell('input');
  open('vault:rise=10');
  ends();
  await afterwards();
  expect(rise.value).toBe('20');
  rise.tell('change');
  expect(asked).toEqual(['vault:rise=10', 'vault:rise=20']);
  ends();
  await afterwards();
  // Let go, it is of the net that is open.
  expect(rise.value).toBe('10');
  rise.value = '15';
  rise.tell('input');
  rise.tell('pointerup');
  open('vault:rise=20');
  expect(rise.value).toBe('20');
});

test('another one is asked for with what was asked for before', () => {
  move(rise, 10);
  move(span, 20);
  expect(asked).toEqual(['vault:rise=10', 'vault:rise=10,span=20']);
});

test('one whose net was refused goes back', async () => {
  move(rise, 10);
  ends();
  await afterwards();
  expect(rise.value).toBe('4');
});

test('of another shape there are others; one of the same name keeps the focus', () => {
  rise.focus();
  open('dome');
  expect(page.activeElement).not.toBe(rise);
  expect(page.activeElement?.dataset['parameter']).toBe('rise');
  sliders.setRecipe(null, shapes);
  expect(sliders.element.hasChildNodes()).toBe(false);
});
