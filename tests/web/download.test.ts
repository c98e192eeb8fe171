import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { download } from '../../web/src/files/download';

beforeEach(() => vi.useFakeTimers());

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test('a file can be fetched while the browser asks where it is to go', () => {
  const kept = new Set<string>();
  vi.stubGlobal('document', { createElement: () => ({ click() {} }) });
  vi.stubGlobal('URL', {
    createObjectURL: () => {
      kept.add('blob:1');
      return 'blob:1';
    },
    revokeObjectURL: (address: string) => kept.delete(address),
  });
  download('net.obj', '', 'text/plain');
  vi.advanceTimersByTime(30_000);
  expect(kept).toContain('blob:1');
  vi.runAllTimers();
  expect(kept.size).toBe(0);
});
