/** Where the browser keeps nothing of it, the net that is open is not lost without a word. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { App } from '../../web/src/app/app';
import { freshScene } from '../../web/src/document/defaults';
import { writeProject } from '../../web/src/document/project';
import type { Project } from '../../web/src/document/project';
import { UndoHistory } from '../../web/src/document/undo';
import { keptWords } from '../../web/src/language/kept';
import type { Action } from '../../web/src/panels';
import { Projects } from '../../web/src/projects/projects';
import { documentAt } from './nets';

const LINK = '#v2=x';
const snapshot = () => documentAt(new Float64Array(3));
const project: Project = { entries: [{ name: ['newNet'], state: snapshot() }], present: 0, view: snapshot().view };

vi.mock('../../web/src/projects/kept', () => ({
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

beforeEach(() => {
  history = new UndoHistory();
  [action, offered, opened, died] = [undefined, [], [], null];
  reload = vi.fn();
  vi.stubGlobal('location', { hash: '', pathname: '/', search: '', reload });
  vi.stubGlobal('localStorage', { getItem: () => died, setItem: () => {}, removeItem: () => {} });
  vi.stubGlobal('addEventListener', () => {});
  vi.stubGlobal('document', { addEventListener: () => {} });
});
afterEach(() => void vi.unstubAllGlobals());

async function start(keeps: boolean): Promise<Projects> {
  const app = {
    on: () => {},
    start: async () => {},
    settled: async () => {},
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
    openProject: async () => void opened.push('project'),
    say: (_: string, offer?: Action) => (action = offer),
    offer: (why: string) => offered.push(why),
    report: (error: unknown) => expect.fail(String(error)),
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
