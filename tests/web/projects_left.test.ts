/** Where the browser keeps nothing of it, the net that is open is not lost without a word. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { App } from '../../web/src/app/app';
import { freshScene } from '../../web/src/document/defaults';
import { writeProject } from '../../web/src/document/project';
import type { Project } from '../../web/src/document/project';
import { UndoHistory } from '../../web/src/document/undo';
import { Failure } from '../../web/src/failure';
import { keptWords } from '../../web/src/language/kept';
import type { Action } from '../../web/src/panels';
import { Projects } from '../../web/src/projects/projects';
import { documentAt } from './nets';

const LINK = '#v2=x';
const snapshot = () => documentAt(new Float64Array(3));
const project: Project = { entries: [{ name: ['newNet'], state: snapshot() }], present: 0, view: snapshot().view };

/** Locks of other tabs. */
const { elsewhere } = vi.hoisted(() => ({ elsewhere: new Set<string>() }));
vi.mock('../../web/src/projects/kept', () => ({
  heldLocks: async () => elsewhere,
  lockOf: (id: string) => id,
  claim: async () => true,
  findLast: async () => ({ id: 'last', project: writeProject(project, Infinity) }),
  isMadeOfLink: () => false,
  isOwn: () => false,
  keep: async () => Promise.reject(new Error('full')),
  newId: () => 'new',
  hasName: async () => false,
  release: () => {},
}));
vi.mock('../../web/src/projects/link', () => ({
  sceneOf: async () => freshScene({ recipe: 'vault' }),
  titleOf: () => null,
  hashOf: () => ({ hash: null }),
}));

let history: UndoHistory;
let action: Action | undefined;
let offered: string[];
let opened: string[];
let reload: ReturnType<typeof vi.fn<() => void>>;
/** The name of what the page was opening when it died; null: it did not. */
let died: string | null;
/** Where the page hears that it is left. */
let leaving: EventTarget;
/** When what has been opened has settled. */
let settling: Promise<void>;
/** How what is opened is refused; null: it is not. */
let fault: Error | null;

beforeEach(() => {
  history = new UndoHistory();
  [action, offered, opened, died] = [undefined, [], [], null];
  [settling, fault] = [Promise.resolve(), null];
  reload = vi.fn();
  vi.stubGlobal('location', { hash: '', pathname: '/', search: '', reload });
  vi.stubGlobal('localStorage', {
    getItem: () => died,
    setItem: (_: string, what: string) => (died = what),
    removeItem: () => (died = null),
  });
  leaving = new EventTarget();
  for (const name of ['addEventListener', 'removeEventListener'] as const)
    vi.stubGlobal(name, (...of: Parameters<EventTarget['addEventListener']>) => leaving[name](...of));
  vi.stubGlobal('document', { addEventListener: () => {} });
});
afterEach(() => {
  vi.unstubAllGlobals();
  elsewhere.clear();
});

async function start(keeps: boolean): Promise<Projects> {
  const app = {
    on: () => {},
    start: async () => {},
    settled: () => settling,
    isQuiet: true,
    history,
    get opening() {
      return opened.length > 0 ? {} : null;
    },
    project: () => ({ ...project, entries: history.entries(snapshot()) }),
    openScene: async () => {
      opened.push('scene');
      history.begin(project.entries, 0);
    },
    openProject: async () => {
      if (fault) throw fault;
      opened.push('project');
    },
    say: (_: string, offer?: Action) => (action = offer),
    offer: (why: string) => offered.push(why),
    report: (error: unknown) => {
      if (error !== fault) expect.fail(String(error));
    },
  };
  const projects = new Projects(app as unknown as App, keeps);
  await projects.start();
  return projects;
}

function edit(): void {
  history.record(snapshot(), ['solve']);
}

test.each([
  ['to what was kept, as is offered after a link', LINK, null],
  ['to what was kept, as is offered after the page died', '', 'last'],
])('%s', async (_, hash, flag) => {
  location.hash = hash;
  died = flag;
  await start(true);
  edit();
  action!.run();
  await vi.waitFor(() => expect(offered).toContain(keptWords.wouldBeLost));
  expect(opened).toEqual(['scene']);
  action!.run();
  await vi.waitFor(() => expect(opened).toEqual(['scene', 'project']));
});

test.each([
  ['where the browser refuses', true],
  ['in a frame', false],
])('to a reload, if it is too large for a link, %s', async (_, keeps) => {
  const projects = await start(keeps);
  edit();
  await projects.reload();
  expect(offered).toContain(keptWords.notKept);
  expect(reload).not.toHaveBeenCalled();
});

test('a page that is left in good order while what it opens is being solved has not died; one whose solver did has', async () => {
  settling = new Promise(() => {});
  await start(true);
  expect(died).toBe('last');
  leaving.dispatchEvent(new Event('pagehide'));
  expect(died).toBeNull();
  fault = new Failure('worker_lost', 'crashed');
  await start(true);
  leaving.dispatchEvent(new Event('pagehide'));
  expect(died).toBe('last');
});

test('what another tab is opening at the same time has not stopped it', async () => {
  died = 'last';
  elsewhere.add('opening last');
  await start(true);
  expect(opened).toEqual(['project']);
});
