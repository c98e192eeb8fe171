/** Panels, made of elements that need no browser. */
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import type { App } from '../../web/src/app/app';
import { newRun, type Run, type RunPlan } from '../../web/src/compare/run';
import type { ChebnetDocument, HandleData, Vec3 } from '../../web/src/document/document';
import type { HistoryView } from '../../web/src/document/undo';
import { FIGURES } from '../../web/src/experiments/figures';
import type { NewNetResponse } from '../../web/src/experiments/new_net_protocol';
import { texts } from '../../web/src/experiments/texts';
import type { Choice, HandleCommands } from '../../web/src/handles/commands';
import type { Snapping } from '../../web/src/handles/snapping';
import { dialogWords } from '../../web/src/language/dialogs';
import { panelWords } from '../../web/src/language/panels';
import { DrapeCreases } from '../../web/src/dialogs/drape_creases';
import { type CutEvents, DrapeCuts } from '../../web/src/dialogs/drape_cuts';
import { DrapeMaker } from '../../web/src/dialogs/drape_maker';
import { Hints } from '../../web/src/learn/hints';
import { words } from '../../web/src/language/language';
import { MapEnds } from '../../web/src/overlay/map_ends';
import { Messages } from '../../web/src/overlay/messages';
import { OpeningNotice } from '../../web/src/overlay/opening_notice';
import { PartNotice } from '../../web/src/overlay/part_notice';
import { RunNotice } from '../../web/src/overlay/run_notice';
import { SelectionBar } from '../../web/src/overlay/selection_bar';
import { SharpNotice } from '../../web/src/overlay/sharp_notice';
import { StuckNotice } from '../../web/src/overlay/stuck_notice';
import { Title } from '../../web/src/overlay/title';
import { Toolbar } from '../../web/src/overlay/toolbar';
import type { PanelEvents } from '../../web/src/panels';
import { ChangePanel } from '../../web/src/sidebar/change_panel';
import { DragPanel } from '../../web/src/sidebar/drag_panel';
import { HandleGroupRow } from '../../web/src/sidebar/handle_group_row';
import { hasNewNet, NewNetTrial } from '../../web/src/sidebar/new_net_trial';
import { SolverPanel } from '../../web/src/sidebar/solver_panel';
import { Softness } from '../../web/src/sidebar/softness';
import { StepPanel } from '../../web/src/sidebar/step_panel';
import { describe as describeNet } from '../../web/src/worker/opened_net';
import type { FrameData } from '../../web/src/worker/protocol';
import { load } from '../wasm/load';
import { type DocumentHere, documentHere } from './elements_here';

// It asks the browser for colours.
vi.mock('../../web/src/view/theme', () => ({}));

const SILENT = new Proxy({}, { get: () => () => {} });

const core = await load();
const net = describeNet(core.openRecipe('sheet:vertices=121'));
const handle = (vertex: number): HandleData => ({ vertex, target: [0, 0, 0], anchor: false });
const choose = (...selection: number[]): Choice => ({
  selection,
  selecting: false,
  mode: 'translate',
  onBoundary: false,
  lines: 2,
});

let page: DocumentHere;
beforeEach(() => {
  page = documentHere();
  vi.stubGlobal('addEventListener', () => {});
});
afterEach(() => vi.unstubAllGlobals());

describe('what goes while it has the focus leaves it to the picture:', () => {
  const events = { handles: SILENT, preview: () => {} } as unknown as PanelEvents;
  const leaves = (button: string, go: () => void): void => {
    page.button(button).focus();
    go();
    expect(page.activeElement).toBe(page.canvas);
  };

  test('the tools of what is selected', () => {
    const bar = new SelectionBar(events);
    bar.setHandles([handle(3)], choose(3));
    leaves(panelWords.selection.remove, () => bar.setHandles([], choose()));
  });

  test('what takes the first handles, once there are any', () => {
    const title = new Title(events, document.createElement('p'));
    title.setHandles([], choose());
    leaves(words.intro.propose, () => title.setHandles([handle(3)], choose()));
  });

  test('undo, once there is nothing left to undo', () => {
    const toolbar = new Toolbar(events);
    const history = { canUndo: true, canRedo: false } as HistoryView;
    toolbar.setHistory(history);
    leaves(words.toolbar.undo.label, () => toolbar.setHistory({ ...history, canUndo: false }));
  });

  test('undo and stop of the solver, where Enter once more would begin a solve', () => {
    const panel = new SolverPanel(events);
    panel.setHistory({ canUndo: true } as HistoryView);
    leaves(panelWords.solver.undo, () => panel.setHistory({ canUndo: false } as HistoryView));
    panel.setFrame({} as FrameData, 60, true);
    leaves(panelWords.solver.cancel, () => panel.setFrame({} as FrameData, 60, false));
  });

  test('the notice that a part is shown', () => {
    const notice = new PartNotice(events);
    notice.setHandles([], { ...choose(), part: {} as NonNullable<Choice['part']> });
    leaves(panelWords.selection.showWhole, () => notice.setHandles([], choose()));
  });

  test('the notice that a run is shown, which keeps it while it says of another', () => {
    const notice = new RunNotice(events);
    const [run, other] = ['run', 'other'].map((label): Run => newRun({ label } as RunPlan));
    notice.setRuns(run!, []);
    const back = page.button(panelWords.comparison.ofRuns.back);
    back.focus();
    notice.setRuns(other!, []);
    expect(page.activeElement).toBe(back);
    leaves(panelWords.comparison.ofRuns.back, () => notice.setRuns(null, []));
  });

  test('the ways out of a net that is stuck', () => {
    const document = { method: 'equilibrium', options: {}, locality: 3 } as unknown as ChebnetDocument;
    const notice = new StuckNotice(
      { ...events, mark: () => {}, screenPositions: () => [] } as unknown as PanelEvents,
      String,
    );
    const frame = {
      status: 'max_iterations',
      maxDeviation: 1,
      positions: net.restPositions,
      fields: { deviation: new Float32Array(net.edges.length / 2) },
      unreachable: [],
      handles: [],
    } as unknown as FrameData;
    notice.setNet(net);
    notice.setDocument(document);
    notice.setFrame(frame, 60, false);
    expect(page.button(panelWords.stuck.widen).isSeen).toBe(true);
    leaves(panelWords.stuck.widen, () => notice.setDocument({ ...document, locality: undefined }));
  });

  test('the notice that a net is being opened', () => {
    const notice = new OpeningNotice(() => {});
    notice.setOpening(true, true);
    leaves(words.opening.cancel, () => notice.setOpening(false, false));
  });

  test('messages, whose time is not up while they have it', () => {
    vi.useFakeTimers();
    vi.stubGlobal('window', { setTimeout });
    const messages = new Messages();
    messages.say('wrong', 'error');
    leaves('×', () => page.button('×').tell('click'));
    expect(messages.element.textContent).toBe('');
    messages.offer('A new version is here.', 'Load it', () => {});
    messages.offer('A new version is here.', 'Load it', () => {});
    expect(messages.element.textContent).toBe('A new version is here.Load it×');
    leaves('×', () => page.button('×').tell('click'));
    messages.setNet();
    messages.say('wrong', 'error');
    leaves('×', () => messages.setNet());
    messages.say('gone', 'info', { label: 'Undo', run: () => {} });
    page.button('Undo').focus();
    vi.advanceTimersByTime(60_000);
    expect(page.activeElement).toBe(page.button('Undo'));
    leaves('Undo', () => page.button('Undo').tell('click'));
    messages.say('gone', 'info', { label: 'Undo', run: () => {} });
    vi.advanceTimersByTime(60_000);
    expect(messages.element.textContent).toBe('');
    vi.useRealTimers();
  });

  test('the notice that a net came with nearly closed quads', () => {
    const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 1.999, 0.02, 0, 0.999, 0.02, 0);
    const mesh = { positions, faceStart: Int32Array.of(0, 4), faceVertices: Int32Array.of(0, 1, 2, 3) };
    const sharp = describeNet(core.openMesh(mesh));
    const notice = new SharpNotice(events);
    notice.setDocument({ method: 'equilibrium', options: { shear_limit: 30 } } as unknown as ChebnetDocument);
    const open = () => {
      notice.setNet(sharp);
      const moved = positions.map((x) => x + 1);
      notice.setFrame({ positions: moved, handles: [] } as unknown as FrameData, 60, false);
    };
    open();
    leaves(panelWords.sharp.accept, () => page.button(panelWords.sharp.accept).tell('click'));
    open();
    leaves(panelWords.sharp.accept, () => notice.setNet(sharp));
  });

  test('hints, of which the last leaves it, and each before to the next', () => {
    vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => {} });
    const app = { opening: null, history: { inGesture: false }, isQuiet: true, on: () => {} };
    const hints = new Hints(app as unknown as App, page.createElement('h1') as unknown as Element);
    const done = page.button(panelWords.hints.done);
    done.focus();
    done.tell('click');
    expect(page.activeElement).toBe(done);
    leaves(panelWords.hints.done, () => hints.done('share'));
  });

  test('not what has it elsewhere', () => {
    const notice = new OpeningNotice(() => {});
    notice.setOpening(true, true);
    const elsewhere = page.createElement('button');
    elsewhere.focus();
    notice.setOpening(false, false);
    expect(page.activeElement).toBe(elsewhere);
  });
});

describe('a button of the dialog for draping that goes when it is pressed leaves the focus', () => {
  const TEXT = dialogWords.drape;
  const press = (button: string): void => {
    page.button(button).focus();
    page.button(button).tell('click');
  };
  const line = { points: [[0, 0, 0] as Vec3, [1, 0, 0] as Vec3], path: Float64Array.of(0, 0, 0, 1, 0, 0) };

  test('to the one in its place', () => {
    const maker = new DrapeMaker({ begun: () => maker.setBusy(true), stopped: () => maker.setBusy(false) });
    maker.show(true);
    press(TEXT.make);
    expect(page.activeElement).toBe(page.button(TEXT.stop));
    press(TEXT.stop);
    expect(page.activeElement).toBe(page.button(TEXT.make));
  });

  test('of cuts, to the one that draws others', () => {
    const cuts = new DrapeCuts(SILENT as CutEvents);
    const draw = page.button(TEXT.cuts.draw);
    press(TEXT.cuts.propose);
    expect(page.activeElement).toBe(draw);
    cuts.setProposed([line], [0, 1]);
    for (const button of ['undo', 'clear'] as const) {
      press(TEXT.cuts[button]);
      expect(page.activeElement).toBe(draw);
      press(TEXT.cuts.propose);
      cuts.setProposed([line], [0, 1]);
    }
  });

  test('of creases, to the one that draws others', () => {
    let revision = 0;
    const events = { traceWanted: (_: unknown, of: number) => (revision = of), drawingChanged() {}, shown() {} };
    const creases = new DrapeCreases(events);
    creases.show(true);
    press(TEXT.markedCreases.draw);
    for (const point of line.points) creases.add(point);
    creases.setTraced(line, revision);
    press(TEXT.markedCreases.end);
    expect(page.activeElement).toBe(page.button(TEXT.markedCreases.draw));
    press(TEXT.markedCreases.undo);
    expect(page.activeElement).toBe(page.button(TEXT.markedCreases.draw));
  });
});

test('what a change would do is shown no longer than what is selected stays so', () => {
  const shown: { preview: readonly number[]; faded: boolean } = { preview: [], faded: false };
  const events = {
    handles: { line: () => [3, 4] },
    previewAlone: (vertices: readonly number[]) => void (shown.preview = vertices),
    fade: (stays: Float32Array | null) => void (shown.faded = stays !== null),
  } as unknown as PanelEvents;
  const panel = new ChangePanel(events, (error) => expect.fail(String(error)));
  panel.setNet(net);
  const middle = choose(60);
  panel.setHandles([handle(60)], middle);
  page.button(panelWords.change.ways.keep_larger).tell('focusin');
  expect(shown.preview).not.toEqual([]);
  expect(shown.faded).toBe(true);
  // As with each frame of a drag.
  panel.setHandles([handle(60)], { ...middle });
  expect(shown.faded).toBe(true);
  panel.setHandles([handle(60)], choose());
  expect(shown).toEqual({ preview: [], faded: false });
});

describe('of a net that stopped short of its handles the notice says why, and offers what helps:', () => {
  const { grow, widen, fellShort, localFellShort, tooNear, unreachable } = panelWords.stuck;
  const sheet = { method: 'equilibrium', options: {} } as unknown as ChebnetDocument;
  const held = [handle(0), handle(1), handle(120)];
  const good = {
    status: 'converged',
    iterations: 3,
    maxDeviation: 0,
    positions: net.restPositions,
    fields: { deviation: new Float32Array(net.edges.length / 2) },
    unreachable: [],
    handles: held,
  } as unknown as FrameData;
  const short = { ...good, fellShort: true };
  let scale: number;
  let document: ChebnetDocument;
  let notice: StuckNotice;

  beforeEach(() => {
    const adaptLengths = async (): Promise<number> => scale;
    const searchRest = async (): Promise<null> => null;
    const events = { handles: SILENT, adaptLengths, searchRest, mark: () => {}, screenPositions: () => [] };
    notice = new StuckNotice(events as unknown as PanelEvents, String);
    notice.setNet(net);
    notice.setHandles(held, choose());
    show(sheet, short);
  });
  const show = (of: ChebnetDocument, frame: FrameData): void => {
    document = of;
    notice.setDocument(document);
    notice.setFrame(frame, 60, false);
  };
  const stuckBy = (vertexA: number, vertexB: number, distance: number, reach: number): FrameData => {
    const unreachable = [{ vertexA, vertexB, distance, reach }];
    return { ...good, status: 'unreachable', maxDeviation: 0.5, unreachable } as unknown as FrameData;
  };
  const isOffered = (way: string): boolean => notice.element.hasChildNodes() && page.button(way).isSeen;

  test('edges that grow, of the whole net', () => {
    expect(notice.element.textContent).toContain(fellShort(null));
    expect([isOffered(grow), isOffered(widen)]).toEqual([true, false]);
  });

  test('with a locality, that the whole net moves', () => {
    show({ ...sheet, locality: 3 }, short);
    expect(notice.element.textContent).toContain(localFellShort);
    expect([isOffered(grow), isOffered(widen)]).toEqual([false, true]);
    show({ ...sheet, locality: 3 }, stuckBy(0, 120, 9, 8));
    expect([isOffered(grow), isOffered(widen)]).toEqual([false, true]);
  });

  test('of handles nearer than the edge between them is long, to move them apart', () => {
    show(sheet, stuckBy(0, 120, 9, 8));
    expect(notice.element.textContent).toContain(unreachable(0, 120, '9.00', '8.00'));
    expect(isOffered(grow)).toBe(true);
    show(sheet, stuckBy(0, 1, 0.5, 1));
    expect(notice.element.textContent).toContain(tooNear(0, 1, '0.500', '1.00'));
    expect(isOffered(grow)).toBe(false);
  });

  test('of a net that is crumpled, to relax it, and where that leads nowhere, that it does not', async () => {
    const { crumpled, noSmoother, rest } = panelWords.stuck;
    const { label, looking } = panelWords.relax;
    // One vertex far out of the sheet.
    const positions = net.restPositions.map((x, i) => (i === 3 * 60 + 2 ? x + 9 : x));
    const folded = { ...good, positions } as FrameData;
    const history = { revision: 1, names: [''], present: 0, forgotten: 0, inGesture: false } as unknown as HistoryView;
    notice.setHistory(history);
    show({ ...sheet, method: 'projection', net: { recipe: 'sheet:vertices=121' } }, folded);
    expect([isOffered(rest), isOffered(label)]).toEqual([true, false]);
    show(sheet, folded);
    expect(notice.element.textContent).toContain(crumpled);
    expect([isOffered(rest), isOffered(label)]).toEqual([false, true]);
    page.button(label).tell('click');
    expect(notice.element.textContent).toContain(looking(0, '0'));
    expect(isOffered(panelWords.stuck.stop)).toBe(true);
    await new Promise((done) => setTimeout(done));
    expect(notice.element.textContent).toContain(noSmoother);
    expect(isOffered(label)).toBe(false);
    // What a hand holds may yet unfold.
    notice.setHistory({ ...history, inGesture: true });
    show(sheet, folded);
    expect(notice.element.textContent).toBe('');
  });

  test('and of edges that have grown it is said for as long as they are so, in this net', async () => {
    const grownTo = async (to: number): Promise<string | null> => {
      scale = to;
      show(sheet, short);
      page.button(grow).tell('click');
      await new Promise((done) => setTimeout(done));
      show({ ...sheet, options: { length_scale: to } }, good);
      return notice.element.textContent;
    };
    expect(await grownTo(1)).toBe('');
    expect(await grownTo(1.25)).toContain(panelWords.stuck.grown('25.0'));
    notice.setNet(net);
    notice.setFrame(good, 60, false);
    expect(notice.element.textContent).toBe('');
  });
});

test('of edges that have grown, lengths are told in edges as they are now', () => {
  const set: (Snapping | null)[] = [];
  const commands = { setSnapping: (snapping: Snapping | null) => set.push(snapping) } as unknown as HandleCommands;
  const panel = new DragPanel(
    commands,
    () => {},
    () => {},
  );
  panel.setNet(net);
  const grown = { positions: net.restPositions, lengthScale: 1.25 } as unknown as FrameData;
  panel.onFrame({ ...grown, lengthScale: 1 });
  const row = page.all('label').find(({ textContent }) => textContent === panelWords.drag.toGrid)!;
  const grid = page.all('input').find((each) => row.contains(each))!;
  Object.assign(grid, { checked: true }).tell('change');
  expect(set.at(-1)?.step).toBeCloseTo(net.info.edgeLength);
  panel.onFrame(grown);
  expect(set.at(-1)?.step).toBeCloseTo(1.25 * net.info.edgeLength);

  const steps = new StepPanel(SILENT as PanelEvents, () => {});
  steps.setNet(net);
  const moved = net.restPositions.map((x, i) => (i === 0 ? x + 2.5 * net.info.edgeLength : x));
  const trace = [{ iteration: 1, stage: 1, p: 0, energy: 1, step: 1, freeVertices: 1 }];
  steps.onFrame({ ...grown, trace, stepFrom: net.restPositions, positions: moved } as unknown as FrameData);
  steps.setFrame();
  expect(page.all('dd')[0]!.textContent).toBe('2');
});

test('a locality between the steps of its slider is told as it is, with the focus and after it', () => {
  const previewed: unknown[] = [];
  const previewLocality = (radius?: number): void => void previewed.push(radius);
  const panel = new DragPanel(
    Object.assign(Object.create(SILENT), { previewLocality }) as HandleCommands,
    () => {},
    () => {},
  );
  panel.setNet(net);
  panel.setDocument({ locality: 30 } as ChebnetDocument);
  const [slider, output] = ['input', 'output'].map((tag) => page.all(tag).at(-1)!);
  const told = panelWords.drag.radius('30');
  expect(output!.value).toBe(told);
  slider!.focus();
  slider!.tell('focus');
  expect(output!.value).toBe(told);
  Object.assign(slider!, { value: '1' }).tell('input');
  expect(output!.value).not.toBe(told);
  page.canvas.focus();
  slider!.tell('blur');
  expect(output!.value).toBe(told);
  expect(previewed).toEqual([30, 11, undefined]);
});

test.each([
  ['of an input method takes what it offers', { isComposing: true, keyCode: 229 }, true],
  ['of one in Safari, which has ended composing by then, likewise', { isComposing: false, keyCode: 229 }, true],
  ['alone ends it', { isComposing: false, keyCode: 13 }, false],
])('while handles are renamed, Enter %s', (_, key, goesOn) => {
  const row = new HandleGroupRow({ select() {}, change() {}, remove() {} });
  const [field] = page.all('input');
  field!.hidden = false;
  row.update([handle(3)], false);
  field!.focus();
  field!.dispatchEvent(Object.assign(new Event('keydown'), { key: 'Enter', ...key }));
  expect(page.activeElement === field).toBe(goesOn);
});

test('the ends of colours take decimal commas as they are typed, and as they stand', () => {
  const setView = vi.fn<PanelEvents['setView']>();
  const typed = vi.fn();
  Object.assign(page, { execCommand: typed });
  new MapEnds({ setView });
  const [high, low] = page.all('input');
  high!.dispatchEvent(Object.assign(new Event('beforeinput', { cancelable: true }), { data: ',' }));
  expect(typed).toHaveBeenCalledWith('insertText', false, '.');
  high!.dispatchEvent(Object.assign(new Event('beforeinput'), { data: '1,' })); // an input method's
  expect(typed).toHaveBeenCalledTimes(1);
  [low!.value, high!.value] = ['1,5e-7', '1.250'];
  high!.tell('change');
  expect(setView).toHaveBeenCalledWith({ ends: { deviation: [1.5e-7, 1.25] } });
});

test('the weight of a handle is told as it is set, also with the focus, but not while it is being moved', () => {
  const chosen: unknown[] = [];
  const softness = new Softness(({ weight }) => chosen.push(weight));
  const [output] = page.all('output');
  const [, slider] = page.all('input');
  const shown = () => [slider!.valueAsNumber, output!.textContent];
  softness.setWeight(10);
  slider!.focus();
  Object.assign(slider!, { value: '2' }).tell('input');
  softness.setWeight(10);
  expect(shown()).toEqual([2, '100']);
  slider!.tell('change');
  softness.setWeight(100);
  softness.setWeight(10); // undone
  expect(shown()).toEqual([1, '10']);
  Object.assign(slider!, { value: '0' }).tell('input');
  slider!.tell('blur');
  expect(shown()).toEqual([1, '10']);
  expect(chosen).toEqual([100]);
});

test('while thousands of handles are dragged, none is looked for among all of them', () => {
  const SIZE = 2000;
  let reads = 0;
  const handles = Array.from({ length: SIZE }, (_, vertex): HandleData => {
    return {
      ...handle(vertex),
      get vertex() {
        reads += 1;
        return vertex;
      },
    };
  });
  const panel = new DragPanel(
    SILENT as HandleCommands,
    () => {},
    () => {},
  );
  panel.setDocument({} as ChebnetDocument);
  panel.setHandles(handles, choose(...handles.keys()));
  expect(reads).toBeLessThan(10 * SIZE);
});

describe('the trial of new nets', () => {
  let worker: Pick<Worker, 'onmessage'>;
  let trial: NewNetTrial;
  const end = () =>
    worker.onmessage!.call(null as never, { data: { type: 'ended' } as NewNetResponse } as MessageEvent);
  const [start, stop] = [() => page.button(texts.newNet.start), () => page.button(texts.newNet.stop)];

  beforeEach(() => {
    class WorkerHere {
      onmessage: Worker['onmessage'] = null;
      constructor() {
        worker = this;
      }
      postMessage(): void {}
      terminate(): void {}
    }
    vi.stubGlobal('Worker', WorkerHere);
    trial = new NewNetTrial(FIGURES.find(hasNewNet)!, String, () => {});
    start().focus();
    start().tell('click');
    expect(page.activeElement).toBe(stop());
  });

  test('leads on from its button at the end', () => {
    end();
    expect(page.activeElement).toBe(start());
    expect(page.scrolledTo).not.toBeNull();
  });

  test('leaves a visitor alone who is doing something else meanwhile', () => {
    page.canvas.focus();
    end();
    expect(page.activeElement).toBe(page.canvas);
    expect(page.scrolledTo).toBeNull();
  });

  test('stopped, leads back to its start', () => {
    trial.stop();
    expect(page.activeElement).toBe(start());
  });
});
