/** Entry point: makes the app, opens what the address asks for, and listens to keys, dropped files and the address. */
import { App } from './app/app';
import type { AppServices } from './app/app';
import type { WantedChange } from './change/subject';
import { download } from './files/download';
import { dragged } from './files/dragged';
import { fileNameOf } from './files/file_name';
import type { SaveRequest } from './export/kinds';
import { filmExtension, filmType } from './export/film_type';
import { pickFile } from './files/pick_file';
import { commandOf, PAGE_KEYS } from './keys';
import { chooseLanguage } from './language/choice';
import { translateDocument, words } from './language/language';
import type { Hint } from './learn/hints';
import { keepOffline } from './offline/offline';
import { createPanels } from './sidebar/sidebar';
import { lazy } from './lazy';
import { Projects } from './projects/projects';
import { createScripting } from './scripting';
import type { Scripting } from './scripting';
import { createView } from './view/scene';
import { readTheme } from './view/theme';
import { newName, whenEnded } from './worker/life';

/** How long after the first net the hints are loaded: what is needed to drag it comes first. */
const HINTS_MS = 400;

translateDocument(document);

/** Inside of another page; see embed/protocol.ts. */
const embedded = new URLSearchParams(location.search).has('embed');
document.documentElement.classList.toggle('embed', embedded);

const services: AppServices = {
  pickFile: () => attempt(pickAndOpen),
  newNet: () => attempt(() => projects.newNet()),
  saveProject,
  chooseProject: () => attempt(() => projects.choose(element('panels'))),
  restoreLast: () => attempt(() => projects.restoreLast()),
  equalize: () => attempt(() => openDialog(openers(), (all) => all.equalizeNet())),
  drape: () => attempt(() => openDialog(openers(), (all) => all.drapeNet())),
  changeNet: (wanted) => attempt(() => changeNet(wanted)),
  share: () => attempt(share),
  save: (request) => attempt(() => saveAs(request)),
  record: () => attempt(record),
  chooseLanguage: (language) => {
    chooseLanguage(language);
    reload();
  },
  showKeys: () => attempt(showKeys),
  showLesson: (lesson) => attempt(async () => (await teacher()).show(lesson)),
};
const app = new App(
  {
    createView: (events) => createView(element('view'), events, reload),
    createBeside: (events, place) => createView(element(`beside-${place + 1}`), events, reload),
    createPanels: (events) => createPanels(element('panels'), events),
    spawnWorker: spawnSolver,
  },
  services,
);
// In a frame of another page nothing is stored: it is not the visitor's own work.
const projects = new Projects(app, !embedded);
const openers = lazy(async () => new (await import('./dialogs/openers')).Openers(app, element('panels')));
const teacher = lazy(async () => new (await import('./learn/teacher')).Teacher(app));
const saving = lazy(() => import('./export/save'));
const filming = lazy(() => Promise.all([import('./export/recording'), import('./overlay/recording_notice')]));
const sharing = lazy(() => import('./projects/sharing'));
const keySheet = lazy(() => import('./dialogs/key_sheet'));
const lateKeys = lazy(() => import('./sidebar/late_keys'));
const dropPlace = lazy(async () =>
  (await import('./overlay/drop_place')).watchForFiles(element('panels'), () => app.formats),
);
const embedding = lazy(() => import('./embed/embed'));
const hints = lazy(async () => new (await import('./learn/hints')).Hints(app, document.querySelector('.title h1')!));
/** Leads to the end of the video that is being recorded; null: none is. */
let showRecording: (() => void) | null = null;
const ready = projects.start();
window.chebnet = createScripting(app, ready);
// Before the listener for keys below: Escape also gives wheel and touch back to the host.
if (embedded) await embed(window.chebnet).catch((error: unknown) => app.report(error));
// After the first net has been opened, so as not to compete for the network.
else {
  void ready
    .then(() => new Promise((done) => setTimeout(done, HINTS_MS)))
    .then(hints)
    .catch(() => {}); // Nobody misses a hint that could not be loaded.
  void ready.then(() => keepOffline(offerVersion, reload));
}

addEventListener('hashchange', () => attempt(followLink));
addEventListener('keydown', pressKey);
// A dialog that began with no control of the page, as with a file that was dropped, gives the focus back to nothing.
addEventListener('close', () => setTimeout(focusSomething), true);
addEventListener('dragover', (event) => {
  event.preventDefault();
  attempt(dropPlace);
});
addEventListener('drop', (event) => {
  event.preventDefault();
  attempt(() => openFile(dragged(event)?.files[0] ?? null));
});

async function embed(script: Scripting): Promise<void> {
  (await embedding()).embed(element('view'), app, script, ready);
}

/** Browsers do not report the end of a worker: it is dispatched as an error here. */
function spawnSolver(): Worker {
  const name = newName();
  const worker = new Worker(new URL('./worker/worker.ts', import.meta.url), { type: 'module', name });
  // Called, not dispatched: WebKit dispatches nothing to a worker that has ended.
  whenEnded(worker, name, () => worker.onerror?.(new ErrorEvent('error', { message: words.solver.ended })));
  return worker;
}

function offerVersion(accept: () => void): void {
  app.offer(words.offline.newVersion, words.offline.reload, accept);
}

function element(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no element "${id}"`);
  return found;
}

function attempt(doing: () => Promise<unknown>): void {
  doing().catch((error: unknown) => app.report(error));
}

/** Once what it needs is loaded, and not over one that was asked for meanwhile: by the other half of a double click, for one. */
async function openDialog<T>(loading: Promise<T>, open: (loaded: T) => unknown): Promise<void> {
  const loaded = await loading;
  if (document.querySelector('dialog:modal') === null) await open(loaded);
}

async function followLink(): Promise<void> {
  if (location.hash.length <= 1) return;
  await ready;
  await projects.followLink();
}

async function share(): Promise<void> {
  followed('share');
  await openDialog(sharing(), (all) => all.share(app, element('panels'), spawnSolver));
}

function changeNet(wanted: WantedChange): Promise<boolean> {
  return app.awaitNet(openers().then((all) => all.changeNet(wanted)));
}

/** A hint is not needed any more. */
function followed(hint: Hint): void {
  if (!embedded)
    void hints()
      .then((all) => all.done(hint))
      .catch(() => {});
}

async function saveAs(request: SaveRequest): Promise<void> {
  followed('share');
  const { save } = await saving();
  await save(request, {
    app,
    theme: () => readTheme(document.body),
    spawnWorker: () => new Worker(new URL('./export/export_worker.ts', import.meta.url), { type: 'module' }),
    cutFlat: (then) => attempt(async () => (await changeNet({ way: 'cut_flat' })) && then()),
  });
}

/** Records the view as a video. One at a time: the end of another would take the background from the first. */
async function record(): Promise<void> {
  if (showRecording) return showRecording();
  showRecording = () => {}; // it is about to begin
  try {
    await recordUntilStopped();
  } finally {
    showRecording = null;
  }
}

async function recordUntilStopped(): Promise<void> {
  const net = app.opening?.document.net;
  const type = filmType();
  if (net === undefined || type === null) return;
  const [{ Recording }, { RecordingNotice }] = await filming();
  const film = await app.film();
  const recording = new Recording(film, type, (seconds) => notice.setSeconds(seconds));
  const notice = new RecordingNotice(element('panels'), () => recording.stop());
  showRecording = () => notice.focus();
  try {
    download(fileNameOf(net, filmExtension(type), app.formats), await recording.done, type);
  } finally {
    notice.remove();
  }
}

function reload(): void {
  attempt(() => projects.reload());
}

function saveProject(): void {
  attempt(() => projects.save());
}

async function pickAndOpen(): Promise<void> {
  await openFile(await pickFile(app.formats, 'any'));
}

async function openFile(file: File | null): Promise<void> {
  if (file === null) return;
  if (projects.isProject(file)) await projects.openFile(file);
  else await (await openers()).openFile(file);
}

function focusSomething(): void {
  if (document.activeElement === document.body) document.querySelector('canvas')?.focus();
}

function pressKey(event: KeyboardEvent): void {
  const command = commandOf(event);
  if (command === null) return;
  event.preventDefault();
  command(app, services);
}

function showKeys(): Promise<void> {
  return openDialog(Promise.all([keySheet(), lateKeys()]), ([{ showKeySheet }, { LATE_TABLES }]) =>
    showKeySheet(element('panels'), [{ where: 'page', rows: PAGE_KEYS }, ...LATE_TABLES]),
  );
}
