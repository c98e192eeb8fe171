/** Whether the camera goes back to all of the net when its edges grow. */
import { beforeEach, expect, test } from 'vitest';
import type { ChebnetDocument } from '../../web/src/document/document';
import { Growth } from '../../web/src/overlay/growth';
import type { FrameData, OpenedNet } from '../../web/src/worker/protocol';

const PICTURE = { left: 0, top: 0, right: 100, bottom: 100 };

let growth: Growth;
/** Where the net ends in the picture. */
let end: number;
let framed: boolean;
let reframed: number;

const ask = (scale: number) => growth.setDocument({ options: { length_scale: scale } } as unknown as ChebnetDocument);
const frame = (lengthScale: number, solving = false) => growth.setFrame({ lengthScale } as FrameData, 60, solving);

beforeEach(() => {
  [end, framed, reframed] = [50, false, 0];
  growth = new Growth({ getBoundingClientRect: () => PICTURE } as HTMLElement, {
    frameAll: () => void (reframed += 1),
    isFramed: () => framed,
    screenPositions: (vertices) => vertices.map((vertex) => ({ x: vertex === 0 ? 10 : end, y: 50 })),
  });
  ask(1);
  growth.setNet({ info: { vertices: 2 } } as OpenedNet);
  frame(1);
});

test('what has left the picture is shown once the net is at rest', () => {
  ask(1.2);
  // The numbers of before, which come late.
  frame(1);
  end = 120;
  frame(1.2, true);
  ask(1.3);
  expect(reframed).toBe(0);
  frame(1.3);
  expect(reframed).toBe(1);
});

test('a detail that was being looked at stays in sight', () => {
  end = 500;
  ask(1.01);
  frame(1.01);
  expect(reframed).toBe(0);
});

test('what grows on while the camera is on its way to all of it is shown', () => {
  [end, framed] = [120, true];
  ask(1.2);
  frame(1.2);
  expect(reframed).toBe(1);
});

test('what stays in the picture, or becomes shorter, moves no camera', () => {
  ask(1.2);
  frame(1.2);
  ask(1.1);
  end = 120;
  frame(1.1);
  expect(reframed).toBe(0);
});
