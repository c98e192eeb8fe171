/** What a drag carries, as browsers tell it. */
import { expect, test } from 'vitest';
import { dragged } from '../../web/src/files/dragged';

test('what is dragged is known, but for what the browser keeps to itself', () => {
  const files = { types: ['Files'] };
  const kept = {
    get types(): string[] {
      throw new Error('Permission denied to access property "types"');
    },
  };
  const drag = (dataTransfer: unknown) => dragged({ dataTransfer } as DragEvent);
  expect(drag(files)).toBe(files);
  expect(drag(kept)).toBeNull();
  expect(drag(null)).toBeNull();
});
