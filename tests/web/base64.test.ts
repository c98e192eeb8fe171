import { expect, test } from 'vitest';
import { fromBase64, toBase64 } from '../../web/src/document/base64';

test.each([0, 1, 2, 8191, 8192, 8193, 100_000])(
  '%i bytes become the base64 that others write, and the same bytes again',
  (length) => {
    const bytes = Uint8Array.from({ length }, (_, i) => (i * 2654435761) >>> 13);
    const text = toBase64(bytes);
    expect(text).toBe(Buffer.from(bytes).toString('base64'));
    expect(Buffer.from(fromBase64(text)).equals(bytes)).toBe(true);
  },
);

test('what is no base64 is refused', () => {
  expect(() => fromBase64('no base64!')).toThrow();
});
