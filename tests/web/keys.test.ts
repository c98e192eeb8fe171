import { expect, test } from 'vitest';
import { chordOf } from '../../web/src/elements/keys';
import { PAGE_KEYS } from '../../web/src/keys';

type Held = Partial<Record<'ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey', true>>;

function chord(key: string, held: Held = {}, code = ''): string {
  return chordOf({
    key,
    code,
    ctrlKey: false,
    metaKey: false,
    shiftKey: false,
    altKey: false,
    ...held,
  } as KeyboardEvent);
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

test('a keyboard of another script has the letters where others have them, a Latin one where it writes them', () => {
  expect(chord('я', { ctrlKey: true }, 'KeyZ')).toBe('Ctrl+Z');
  expect(chord('Ζ', { metaKey: true, shiftKey: true }, 'KeyZ')).toBe('⌘+Shift+Z');
  expect(chord('ж', {}, 'Semicolon')).not.toBe('G');
  expect(chord('z', { ctrlKey: true }, 'KeyW')).toBe('Ctrl+Z'); // French
  expect(chord('?', { shiftKey: true }, 'Digit7')).toBe('?'); // Russian
});

test('no key does two things', () => {
  const keys = PAGE_KEYS.flatMap((row) => row.keys);
  expect(new Set(keys).size).toBe(keys.length);
});
