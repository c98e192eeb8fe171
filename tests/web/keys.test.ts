import { expect, test } from 'vitest';
import { chordOf } from '../../web/src/elements/keys';
import { PAGE_KEYS } from '../../web/src/keys';

function chord(key: string, held: Partial<Record<'ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey', true>> = {}): string {
  return chordOf({ key, ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...held } as KeyboardEvent);
}

test('a key is called as the sheet writes it', () => {
  expect(chord('z', { ctrlKey: true })).toBe('Ctrl+Z');
  expect(chord('Z', { ctrlKey: true, shiftKey: true })).toBe('Ctrl+Shift+Z');
  expect(chord('z', { metaKey: true })).toBe('⌘+Z');
  expect(chord('Escape')).toBe('Esc');
  expect(chord('g')).toBe('G');
  expect(chord('G', { shiftKey: true })).toBe('Shift+G');
});

test('a sign that needs Shift on some keyboards does not on others', () => {
  expect(chord('?', { shiftKey: true })).toBe('?');
  expect(chord('?')).toBe('?');
});

test('no key does two things', () => {
  const keys = PAGE_KEYS.flatMap((row) => row.keys);
  expect(new Set(keys).size).toBe(keys.length);
});
