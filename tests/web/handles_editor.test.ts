/** The editor of handles over a document on the desk and a solver that takes everything. */
import { beforeEach, describe, expect, test } from 'vitest';
import type { Handle } from '../../wasm/chebnet';
import type { Opening } from '../../web/src/worker/opening';
import type { HandleData, Vec3 } from '../../web/src/document/document';
import { type Snapshot, UndoHistory } from '../../web/src/document/undo';
import { DragGuide } from '../../web/src/handles/drag_guide';
import { HandleEditor } from '../../web/src/handles/handle_editor';
import { shareAt } from '../../web/src/handles/influence';
import { Along } from '../../web/src/handles/along';
import { Snapping } from '../../web/src/handles/snapping';
import type { Client } from '../../web/src/worker/client';
import { describe as describeNet } from '../../web/src/worker/opened_net';
import { load } from '../wasm/load';
import { documentAt, grid } from './nets';

const flat = grid(5, 3);
const net = describeNet((await load()).openMesh({ ...flat, positions: flat.restPositions }));
let opening: Opening;
let history: UndoHistory;
let editor: HandleEditor;
let asked: Handle[][];
let said: string[];
let returning: boolean;
let refuses: boolean;
/** Another net is being opened. */
let isOpening: boolean;
let readout: string;
/** What the solver was told of the hand. */
let handSays: Parameters<Client['drag']>[2];
/** What is shown of what follows. */
let shares: ReadonlyMap<number, number> | null;
/** How often the solver was told that the hand lets go. */
let released: number;

const at = (vertex: number): Vec3 => [vertex % 5, Math.floor(vertex / 5), 0];
const handle = (vertex: number, rest: Partial<HandleData> = {}): HandleData => ({
  vertex,
  target: at(vertex),
  anchor: false,
  ...rest,
});
const handles = () => opening.document.handles;
const vertices = () => handles().map(({ vertex }) => vertex);
const verticesAsked = () => asked.at(-1)!.map(({ vertex }) => vertex);
const tick = () => new Promise((resolve) => setTimeout(resolve));

function snapshot(): Snapshot {
  const { view: _, ...state } = opening.document;
  return state;
}

function undo() {
  const state = history.undo(snapshot());
  if (state) opening = { ...opening, document: { ...state, net: opening.document.net, view: opening.document.view } };
}

const change = (part: object) => void (opening = { ...opening, document: { ...opening.document, ...part } });

beforeEach(() => {
  [asked, said, history, returning, refuses, released, readout] = [[], [], new UndoHistory(), false, false, 0, ''];
  isOpening = false;
  const document = { ...documentAt(net.restPositions), handles: [handle(0), handle(2, { anchor: true }), handle(7)] };
  opening = { net, frame: { positions: net.restPositions }, document } as unknown as Opening;
  const take = async (targets: Handle[]) => {
    if (refuses) throw new Error('refused');
    asked.push(targets);
  };
  const client = {
    drag: (targets: Handle[], _inHand: boolean, hand: typeof handSays) => {
      handSays = hand;
      return take(targets);
    },
    release: async () => void (released += 1),
    setHandles: take,
    reach: async (of: number[]) => of.map(() => []),
    setLocality: async () => {},
    get returning() {
      return returning;
    },
  } as unknown as Client;
  editor = new HandleEditor(
    {
      opening: () => opening,
      before: snapshot,
      beforeIfAny: () => (isOpening ? null : snapshot()),
      change,
      restore: ({ handles: before }) => change({ handles: [...before] }),
      drag: (dragged) => change({ handles: dragged }),
      choiceChanged: () => {},
      say: (message) => said.push(message),
      attempt: (doing) => void doing.catch((error) => expect.fail(String(error))),
    },
    client,
    history,
    new DragGuide(client, {
      setRegion: () => {},
      setShares: (shown) => (shares = shown),
      setReach: () => {},
      setReadout: (text) => (readout = text),
    }),
  );
});

test('locked handles are neither turned nor removed, and this is said', async () => {
  editor.select([0, 2, 7]);
  editor.transform({ kind: 'move', by: [0, 0, 1] });
  await tick();
  expect(asked).toEqual([
    [
      { vertex: 7, target: [2, 1, 1] },
      { vertex: 0, target: [0, 0, 1] },
    ],
  ]);
  editor.remove([0, 2]);
  await tick();
  expect(vertices()).toEqual([2, 7]);
  expect(said).toHaveLength(1);
});

test('a move can be undone before the solver has taken it, and one that it refuses leaves no trace', async () => {
  const moving = editor.move([{ vertex: 0, target: [0, 0, 1] }]);
  expect(handles()[0]!.target).toEqual([0, 0, 1]);
  undo();
  await moving;
  expect(handles()[0]!.target).toEqual(at(0));
  expect(history).toMatchObject({ canUndo: false, canRedo: true });

  refuses = true;
  await expect(editor.move([{ vertex: 0, target: [0, 0, 2] }])).rejects.toThrow('refused');
  await expect(editor.set([handle(7)])).rejects.toThrow('refused');
  expect(vertices()).toEqual([0, 2, 7]);
  expect(handles()[0]!.target).toEqual(at(0));
  expect(history).toMatchObject({ canUndo: false, canRedo: true });
});

test('a move that a lost solver had not answered stays: the next one takes it from the document', async () => {
  [refuses, returning] = [true, true];
  await editor.move([{ vertex: 0, target: [0, 0, 2] }]);
  expect(handles()[0]!.target).toEqual([0, 0, 2]);
  expect(history.canUndo).toBe(true);
});

test('what is selected before the solver has taken a new handle stays so', async () => {
  editor.add(5);
  expect(editor.choice.selection).toEqual([5]);
  editor.select([7]);
  await tick();
  expect(vertices()).toContain(5);
  expect(editor.choice.selection).toEqual([7]);
});

test('a change that is refused late takes back nothing that was done since', async () => {
  refuses = true;
  const moving = editor.move([{ vertex: 0, target: [0, 0, 1] }]);
  refuses = false;
  await editor.set([handle(7)]);
  await expect(moving).rejects.toThrow('refused');
  expect(vertices()).toEqual([7]);
  expect(history.names).toHaveLength(3);
});

test('Escape ends selecting several, and only then the selection', () => {
  editor.select([0]);
  editor.toggleSelecting();
  expect(editor.choice.selecting).toBe(true);
  editor.escape();
  expect(editor.choice).toMatchObject({ selecting: false, selection: [0] });
  editor.escape();
  expect(editor.choice.selection).toEqual([]);
});

test('a gesture of many moves is one entry, and cancelled it is none', () => {
  editor.beginDrag();
  for (const z of [1, 2, 3])
    editor.drag([
      { vertex: 0, target: [0, 0, z] },
      { vertex: 7, target: [2, 1, z] },
    ]);
  editor.endDrag(false);
  expect(released).toBe(1);
  expect(handles()[2]!.target).toEqual([2, 1, 3]);
  editor.beginDrag();
  editor.drag([{ vertex: 0, target: [9, 9, 9] }]);
  editor.endDrag(true);
  // It goes back to the state before, which lets go.
  expect(released).toBe(1);
  expect(handles()[0]!.target).toEqual([0, 0, 3]);
  undo();
  expect(handles().map(({ target }) => target[2])).toEqual([0, 0, 0]);
  expect(history.canUndo).toBe(false);
});

test('a line of vertices is taken whole, its first vertex leads', async () => {
  editor.select([0]);
  expect(editor.choice).toMatchObject({ onBoundary: true, lines: 2 });
  editor.takeLine('boundary', 'Rim');
  await tick();
  expect(vertices()).toHaveLength(13);
  expect(editor.choice.selection).toHaveLength(12);
  expect(editor.choice.selection.at(-1)).toBe(0);
});

test('a patch has one name, also of handles in it that had none and are not locked, and is one step', async () => {
  editor.select([7]);
  editor.around((surroundings) => {
    surroundings.radius = 1;
    expect([...surroundings.patch()].sort((a, b) => a - b)).toEqual([2, 6, 7, 8, 12]);
    surroundings.takePatch();
  });
  await expect.poll(() => vertices()).toHaveLength(6);
  const named = handles().filter(({ name }) => name !== undefined);
  expect(named.map(({ vertex }) => vertex).sort((a, b) => a - b)).toEqual([6, 7, 8, 12]);
  expect(new Set(named.map(({ name }) => name)).size).toBe(1);
  expect(editor.choice.selection.at(-1)).toBe(7);
  expect(editor.choice.selection).toHaveLength(5);
  undo();
  expect(handles()).toEqual([handle(0), handle(2, { anchor: true }), handle(7)]);
});

test('there is no patch around nothing', async () => {
  editor.select([]);
  editor.around((surroundings) => surroundings.takePatch());
  await tick();
  expect(vertices()).toEqual([0, 2, 7]);
});

test('a part of the net is shown alone until it is shown whole, or another net is open; the document does not know', async () => {
  const before = opening.document;
  const isolate = async () => {
    editor.around((surroundings) => {
      surroundings.radius = 1;
      surroundings.isolate();
    });
    await tick();
  };
  editor.select([0]);
  await isolate();
  expect([...editor.choice.part!.hidden].flatMap((hidden, vertex) => (hidden ? [] : [vertex]))).toEqual([0, 1, 5, 6]);
  editor.selectAll();
  expect(editor.choice.selection).toEqual([0]);
  await isolate();
  expect(editor.choice.part).toBeUndefined();
  await isolate();
  editor.netChanged();
  expect(editor.choice.part).toBeUndefined();
  expect(opening.document).toBe(before);
  expect(history.canUndo).toBe(false);
});

test('while another net is being opened no drag begins', () => {
  isOpening = true;
  expect(editor.beginDrag()).toBe(false);
  expect(history.inGesture).toBe(false);
  isOpening = false;
  expect(editor.beginDrag()).toBe(true);
});

test('what has gone since the view took hold of it is not dragged', () => {
  editor.beginDrag();
  change({ handles: [handle(0), handle(2, { anchor: true })] });
  editor.drag([{ vertex: 7, target: [2, 1, 1] }]);
  expect(asked).toEqual([]);
  editor.drag([
    { vertex: 7, target: [2, 1, 1] },
    { vertex: 0, target: [0, 0, 1] },
  ]);
  expect(verticesAsked()).toEqual([0]);
});

describe('a drag that snaps', () => {
  const drag = (z: number) => editor.drag([{ vertex: 7, target: [2.4, 1.1, z] }]);

  test('goes to the grid, or level with another handle that is near; beside it is said where it is', () => {
    editor.setSnapping(new Snapping(0.5, true, 1));
    editor.beginDrag();
    drag(0.8);
    // Vertex 2 has the x of it, no handle its y or z.
    expect(handles()[2]!.target).toEqual([2.5, 1, 1]);
    expect(asked.at(-1)).toEqual([{ vertex: 7, target: [2.5, 1, 1] }]);
    expect(readout).toMatch(/^x 2\.5 · y 1 · z 1$/);
    drag(0.2);
    expect(handles()[2]!.target).toEqual([2.5, 1, 0]);
    expect(readout).toMatch(/^x 2\.5 · y 1 · z 0 \(.* 0\)$/);
    editor.endDrag(false);
    expect(readout).toBe('');
  });

  test('is free at once while snapping is suspended, and snaps again after', () => {
    const snapping = new Snapping(0.5, false, 1);
    editor.setSnapping(snapping);
    editor.beginDrag();
    drag(0.8);
    editor.setSnapping(null);
    expect(handles()[2]!.target).toEqual([2.4, 1.1, 0.8]);
    editor.setSnapping(snapping);
    expect(handles()[2]!.target).toEqual([2.5, 1, 1]);
    editor.endDrag(false);
    undo();
    expect(handles()[2]!.target).toEqual(at(7));
  });

  test('keeps to the axis along which it goes, and takes all that is in hand along', () => {
    editor.setSnapping(new Snapping(0.7, false, 1));
    editor.beginDrag();
    editor.drag([
      { vertex: 7, target: [2, 1, 0.5] },
      { vertex: 0, target: [0, 0, 0.5] },
    ]);
    expect(handles().map(({ target }) => target)).toEqual([
      [0, 0, 0.7],
      [2, 0, 0],
      [2, 1, 0.7],
    ]);
    editor.endDrag(false);
  });

  test('does so on both sides of a plane of symmetry', async () => {
    editor.setSymmetry({ axis: 'x', through: 'centre' });
    editor.add(5);
    await tick();
    editor.setSnapping(new Snapping(0.25, false, 1));
    editor.beginDrag();
    editor.drag([{ vertex: 9, target: [4.3, 1, 0.6] }]);
    const targets = new Map(handles().map(({ vertex, target }) => [vertex, target]));
    expect([targets.get(5), targets.get(9)]).toEqual([
      [-0.25, 1, 0.5],
      [4.25, 1, 0.5],
    ]);
    editor.endDrag(false);
  });

  test('that turns does not snap', () => {
    editor.setSnapping(new Snapping(0.5, true, 1));
    editor.beginDrag();
    const turned = [
      { vertex: 7, target: [1.1, 1, 0] as Vec3 },
      { vertex: 0, target: [0.9, 0, 0] as Vec3 },
    ];
    editor.drag(turned);
    expect(asked.at(-1)).toEqual(turned);
    editor.endDrag(false);
  });
});

test('rows and columns cross at an inner vertex; the boundary does not come by', () => {
  editor.select([7]);
  expect(editor.choice).toMatchObject({ onBoundary: false, lines: 2 });
  const ascending = ([...line]: readonly number[]) => line.sort((a, b) => a - b);
  expect([editor.line(0), editor.line(1)].map(ascending).sort(([a = 0], [b = 0]) => a - b)).toEqual([
    [2, 7, 12],
    [5, 6, 7, 8, 9],
  ]);
  expect(editor.line('boundary')).toEqual([]);
});

test('a line that closes takes each of its vertices once', async () => {
  const torus = (await load()).openRecipe('torus:vertices=300');
  opening = { ...opening, net: describeNet(torus) };
  editor.select([0]);
  const line = editor.line(0);
  expect(line.length).toBeGreaterThan(3);
  expect(new Set(line).size).toBe(line.length);
  torus.dispose();
});

test('traits are undone; only softness concerns the solver', async () => {
  editor.change([0, 7], { name: 'Rim', hidden: true });
  expect(asked).toEqual([]);
  editor.change([0], { weight: 2 });
  await tick();
  expect(asked).toHaveLength(1);
  expect(handles()[0]).toMatchObject({ name: 'Rim', hidden: true, weight: 2 });
  undo();
  undo();
  expect(handles()[0]).toEqual(handle(0));
});

describe('with symmetry', () => {
  beforeEach(() => editor.setSymmetry({ axis: 'x', through: 'centre' }));

  test('a handle comes with its mirror image, moves with it and goes with it', async () => {
    editor.add(5);
    await tick();
    expect(vertices()).toEqual([0, 2, 7, 5, 9]);
    editor.beginDrag();
    editor.drag([{ vertex: 5, target: [-1, 1, 2] }]);
    editor.endDrag(false);
    expect(asked.at(-1)).toEqual([
      { vertex: 5, target: [-1, 1, 2] },
      { vertex: 9, target: [5, 1, 2] },
    ]);
    editor.remove([9]);
    await tick();
    expect(vertices()).toEqual([0, 2, 7]);
  });

  test('is itself undone', () => {
    undo();
    expect(opening.document.symmetry).toBeUndefined();
  });
});

describe('a solver that comes in the place of one that was lost', () => {
  const lifted = [{ vertex: 7, target: [2, 1, 1] as Vec3 }];

  test('is told once where the hand is, and not again until it moves', () => {
    editor.beginDrag();
    editor.drag(lifted);
    for (let i = 0; i < 2; ++i) editor.resumeDrag();
    expect(asked).toEqual([lifted, lifted]);
    editor.drag(lifted);
    editor.resumeDrag();
    expect(asked).toEqual([lifted, lifted, lifted, lifted]);
  });

  test('is told what was let go while it was on its way', () => {
    editor.beginDrag();
    editor.drag(lifted);
    returning = true;
    editor.endDrag(false);
    change({ handles: [handle(7)] });
    editor.resumeDrag();
    expect(asked).toEqual([lifted, lifted]);
    expect(released).toBe(1);
    expect(handles()).toEqual([handle(7, { target: [2, 1, 1] })]);
  });

  test.each([
    ['let go before', () => editor.endDrag(false)],
    [
      'cancelled',
      () => {
        returning = true;
        editor.endDrag(true);
      },
    ],
    ['of another net', () => editor.netChanged()],
  ])('is not told of a drag that was %s', (_, end) => {
    editor.beginDrag();
    editor.drag(lifted);
    end();
    editor.resumeDrag();
    expect(asked).toEqual([lifted]);
  });
});

describe('handles near a dragged one', () => {
  const targets = () => new Map(handles().map(({ vertex, target }) => [vertex, target]));
  const near = shareAt(1 / 3);
  const far = shareAt(2 / 3);

  async function follow(radius: number | undefined, held: HandleData[] = [5, 6, 7, 8, 9].map((each) => handle(each))) {
    change({ handles: held });
    editor.setInfluence(radius);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  const drag = (target: Vec3, vertex = 9, along: Along | null = null) => editor.drag([{ vertex, target }], along);

  test('follow it by their share, in one step to undo, and Escape gives all of it up', async () => {
    await follow(3);
    editor.beginDrag();
    drag([4, 1, 0.5]);
    drag([4, 1.5, 1]);
    expect(shares).toEqual(
      new Map([
        [9, 1],
        [8, near],
        [7, far],
      ]),
    );
    expect([...targets().values()]).toEqual([
      at(5),
      at(6),
      [2, 1 + far / 2, far],
      [3, 1 + near / 2, near],
      [4, 1.5, 1],
    ]);
    expect(verticesAsked()).toEqual([9, 7, 8]);
    editor.endDrag(false);
    expect(shares).toBeNull();
    undo();
    expect([...targets().values()]).toEqual([5, 6, 7, 8, 9].map(at));
    expect(opening.document.influence).toBe(3);
    editor.beginDrag();
    drag([4, 1, 5]);
    editor.endDrag(true);
    expect([...targets().values()]).toEqual([5, 6, 7, 8, 9].map(at));
    undo();
    expect(opening.document.influence).toBeUndefined();
    editor.beginDrag();
    drag([4, 1, 5]);
    expect(targets().get(8)).toEqual(at(8));
    editor.endDrag(false);
  });

  test('stay if they are locked, follow only across the axes on which they slide, and soft ones as others do', async () => {
    await follow(3, [
      handle(7, { weight: 0.5 }),
      handle(8, { slides: 'xy' }),
      handle(9),
      handle(14, { anchor: true }),
      handle(13, { slides: 'z' }),
    ]);
    editor.beginDrag();
    drag([4.5, 1, 1]);
    expect(targets().get(7)).toEqual([2 + far / 2, 1, far]);
    expect(targets().get(8)).toEqual([3, 1, near]);
    expect(targets().get(14)).toEqual(at(14));
    const share = shareAt(Math.SQRT2 / 3);
    expect(targets().get(13)).toEqual([expect.closeTo(3 + share / 2, 12), 2, 0]);
    editor.endDrag(false);
  });

  test('keep to the axis that keys say, and to the grid that the dragged one snaps to', async () => {
    await follow(3);
    editor.setSnapping(new Snapping(0.5, false, 1));
    editor.beginDrag();
    drag([4.3, 1.2, 0.8], 9, new Along('z', 1));
    expect(targets().get(9)).toEqual([4, 1, 1]);
    expect(targets().get(8)).toEqual([3, 1, expect.closeTo(near, 12)]);
    // What follows asks for nothing, and excuses the hand.
    expect(handSays).toEqual({ asked: [], along: 'z' });
    drag([4.3, 1.2, 0.8], 9, new Along('xy', 1));
    expect(targets().get(9)).toEqual([4.5, 1, 0]);
    expect(targets().get(7)).toEqual([expect.closeTo(2 + far / 2, 12), 1, 0]);
    editor.endDrag(false);
  });

  test('follow on both sides of a plane of symmetry, and beside it on it', async () => {
    await follow(3);
    editor.setSymmetry({ axis: 'x', through: 'centre' });
    editor.beginDrag();
    drag([4.3, 1, 0.6]);
    const close = (x: number, z: number) => [expect.closeTo(x, 12), 1, expect.closeTo(z, 12)];
    expect([...targets().values()]).toEqual([
      close(-0.3, 0.6),
      close(1 - 0.3 * near, 0.6 * near),
      close(2, 0.6 * far),
      close(3 + 0.3 * near, 0.6 * near),
      close(4.3, 0.6),
    ]);
    editor.endDrag(false);
  });

  test('go the way of the one in hand that is nearest where those turn', async () => {
    await follow(2);
    editor.beginDrag();
    editor.drag([
      { vertex: 9, target: [4, 1, 1] },
      { vertex: 5, target: [0, 1, -1] },
    ]);
    const half = shareAt(1 / 2);
    expect([targets().get(8), targets().get(6), targets().get(7)]).toEqual([[3, 1, half], [1, 1, -half], at(7)]);
    editor.endDrag(false);
  });
});
