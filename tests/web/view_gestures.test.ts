/** Gestures, their events in the hands of the test. */
import { setMaxListeners } from 'node:events';
import { PerspectiveCamera } from 'three';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { DragReport } from '../../web/src/view/drag';
import { type GestureContext, Gestures } from '../../web/src/view/gestures';

/** Where a handle is, and where a part of the gizmo. */
const [HANDLE, GIZMO, FREE] = [10, 50, 90];

// As many listeners as gestures have would be a leak on a server.
setMaxListeners(20);

let above: EventTarget;
let canvas: object;
let said: string[];
let report: DragReport;
let gestures: Gestures;

/** Of a mouse, on the canvas, unless it is said. */
function point(type: string, x: number, buttons: number, of: Partial<PointerEvent> = {}): Event {
  const event = new Event(type);
  const how = { pointerId: 1, pointerType: 'mouse', isPrimary: true, button: 0, buttons, clientX: x, clientY: 0 };
  Object.defineProperty(event, 'target', { value: canvas });
  above.dispatchEvent(Object.assign(event, how, of));
  return event;
}

beforeEach(() => {
  vi.stubGlobal('window', new EventTarget());
  for (const name of ['requestAnimationFrame', 'cancelAnimationFrame']) vi.stubGlobal(name, () => {});
  above = new EventTarget();
  canvas = Object.assign(new EventTarget(), {
    parentElement: above,
    style: {},
    getBoundingClientRect: () => ({ left: 0, top: 0, width: 100, height: 100 }),
    setPointerCapture: () => {},
  });
  said = [];
  report = new DragReport({
    dragStart: () => said.push('start') > 0,
    dragMove: () => void said.push('move'),
    dragEnd: (cancelled) => void said.push(cancelled ? 'cancel' : 'end'),
  });
  const camera = new PerspectiveCamera();
  gestures = new Gestures({
    canvas,
    camera: () => camera,
    orbit: { touches: {} },
    gizmo: {
      takes: ({ x }: { x: number }) => x === (2 * GIZMO) / 100 - 1,
      setEnabled: () => {},
      release: () => said.push('released'),
    },
    markers: {
      at: (_: unknown, x: number) => (x === HANDLE ? 7 : null),
      isLocked: () => false,
      point: () => ({ clone: () => camera.position.clone().setZ(-1) }),
    },
    report,
    events: { select: () => said.push('select'), failed: () => {} },
    data: () => null,
    selection: () => [],
    selecting: () => false,
    moving: () => [7],
    projection: () => null,
    grab: (vertices: number[]) => report.begin(vertices),
    carry: () => report.move([]),
    axes: () => new Promise(() => {}),
    outline: () => {},
    hovered: () => {},
  } as unknown as GestureContext);
});
afterEach(() => {
  gestures.dispose();
  vi.unstubAllGlobals();
});

test('a handle is taken along, and let go', () => {
  point('pointerdown', HANDLE, 1);
  point('pointermove', FREE, 1);
  point('pointerup', FREE, 0);
  expect(said).toEqual(['start', 'move', 'end']);
});

test('an arrow whose release the page was not told of is let go with the next move', () => {
  point('pointerdown', GIZMO, 1);
  report.begin([7]);
  report.move([]);
  point('pointermove', FREE, 0);
  expect(said).toEqual(['start', 'move', 'released', 'end']);
  point('pointermove', HANDLE, 0);
  expect(report.isUnderWay).toBe(false);
});

test.each([GIZMO, FREE])('of two fingers, the first at %s, the camera hears every move', (first) => {
  const [one, other] = [1, 2].map((pointerId) => ({ pointerId, pointerType: 'touch', isPrimary: pointerId === 1 }));
  point('pointerdown', first, 1, one);
  point('pointerdown', FREE, 1, other);
  for (let step = 1; step <= 10; ++step) {
    point('pointermove', first - 5 * step, 1, one);
    // What is stopped does not reach the canvas.
    expect(point('pointermove', FREE + 5 * step, 1, other).cancelBubble, `step ${step}`).toBe(false);
  }
});

test('what is in hand when its net goes is given up: the pointer moves nothing more, and its release is no click', () => {
  point('pointerdown', HANDLE, 1);
  point('pointermove', FREE, 1);
  gestures.giveUp();
  expect(said).toEqual(['start', 'move', 'released', 'cancel']);
  point('pointermove', HANDLE, 1);
  point('pointerup', HANDLE, 0);
  expect(said).toEqual(['start', 'move', 'released', 'cancel']);
});
