/** The page: makes the app, opens what the address asks for, and listens to keys, dropped files and the address. */
import { App } from './app';
import { linkAdvice } from './document/share';
import { equalizedScene, subjectOfNet } from './equalize/subject';
import type { Subject } from './equalize/subject';
import { embed, isEmbedded } from './embed/embed';
import { download } from './files/download';
import { fileNameOf, typeOf } from './files/export';
import type { FileKind } from './files/export';
import { FileOpener, pickFile } from './files/import';
import { translateDocument, words } from './language/language';
import { keepOffline } from './offline/offline';
import type { GizmoMode } from './handles/wishes';
import { EqualizeDialog } from './panels/equalize_dialog';
import { FileDialog } from './panels/file_dialog';
import { createPanels } from './panels/sidebar';
import { Projects } from './projects/projects';
import { createScripting } from './scripting';
import { createView } from './view/scene';

translateDocument(document);

/** As in other programs for shapes: grab, rotate, scale. */
const MODE_KEYS: Record<string, GizmoMode> = { g: 'translate', r: 'rotate', s: 'scale' };

const app = new App(
  {
    createView: (events) => createView(element('view'), events),
    createBeside: (events) => createView(element('beside'), events),
    createPanels: (events) => createPanels(element('panels'), events),
    spawnWorker: () => new Worker(new URL('./worker/worker.ts', import.meta.url), { type: 'module' }),
  },
  {
    pickFile: () => attempt(pickAndOpen),
    newNet: () => attempt(() => projects.newNet()),
    saveProject: () => projects.save(),
    restoreLast: () => attempt(() => projects.restoreLast()),
    equalize: () => attempt(equalizeNet),
    copyLink: () => attempt(copyLink),
    exportFile: (kind) => attempt(() => exportFile(kind)),
  },
);
// What is done inside of another page is no work of the visitor's own.
const projects = new Projects(app, !isEmbedded());
const opener = new FileOpener({
  spawnWorker: () => new Worker(new URL('./files/file_worker.ts', import.meta.url), { type: 'module' }),
  createDialog: (name) => new FileDialog(element('panels'), name),
  createEqualizer,
  open: (net) => app.openNet(net),
});
const ready = projects.start();
window.chebnet = createScripting(app, ready);
if (isEmbedded()) embed(element('view'), app, window.chebnet);
// Once the first net is there: until then the network is busy enough.
else void ready.then(() => keepOffline((accept) => app.offer(words.offline.newVersion, words.offline.reload, accept)));

addEventListener('hashchange', () => attempt(followLink));
addEventListener('keydown', pressKey);
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  attempt(() => openFile(event.dataTransfer?.files[0] ?? null));
});

function element(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no element "${id}"`);
  return found;
}

function attempt(doing: () => Promise<void>): void {
  doing().catch((error: unknown) => app.report(error));
}

async function followLink(): Promise<void> {
  if (location.hash.length <= 1) return;
  await ready;
  await projects.followLink();
}

async function copyLink(): Promise<void> {
  const shared = app.share();
  const advice = linkAdvice(shared) ?? '';
  if (shared.hash === null) return app.say(advice);
  const link = new URL(shared.hash, location.href).href;
  try {
    await navigator.clipboard.writeText(link);
    app.say(words.link.copied(advice));
  } catch {
    history.replaceState(null, '', link);
    app.say(words.link.inAddressBar(advice));
  }
}

async function exportFile(kind: FileKind): Promise<void> {
  const net = app.opening?.document.net;
  if (net === undefined) return;
  const content = kind === 'png' ? await app.picture() : await app.exported(kind);
  download(fileNameOf(net, kind), content, typeOf(kind));
}

async function pickAndOpen(): Promise<void> {
  await openFile(await pickFile());
}

async function openFile(file: File | null): Promise<void> {
  if (file === null) return;
  if (projects.isProject(file)) await projects.openFile(file);
  else await opener.open(file);
}

function createEqualizer(subject: Subject): EqualizeDialog {
  return new EqualizeDialog(element('panels'), subject, {
    spawnWorker: () => new Worker(new URL('./equalize/equalize_worker.ts', import.meta.url), { type: 'module' }),
    createView,
    upAxis: app.opening?.document.view.upAxis,
  });
}

async function equalizeNet(): Promise<void> {
  if (app.opening === null) return;
  const { document, net } = app.opening;
  const obj = await createEqualizer(subjectOfNet(document, net)).result;
  if (obj !== null) await app.openScene(equalizedScene(document, obj));
}

function pressKey(event: KeyboardEvent): void {
  // Keys are for a dialog alone while it is open, wherever the focus is.
  const busy = document.querySelector('dialog:modal') !== null;
  if (event.defaultPrevented || busy) return;
  const command = fileCommandOf(event) ?? (isTyping(event) ? null : commandOf(event));
  if (command === null) return;
  event.preventDefault();
  command();
}

function fileCommandOf({ key, ctrlKey, metaKey, shiftKey, altKey }: KeyboardEvent): (() => void) | null {
  if (!(ctrlKey || metaKey) || shiftKey || altKey) return null;
  const letter = key.toLowerCase();
  if (letter === 's') return () => projects.save();
  return letter === 'o' ? () => attempt(pickAndOpen) : null;
}

function commandOf({ key, ctrlKey, metaKey, shiftKey, altKey }: KeyboardEvent): (() => void) | null {
  const letter = key.toLowerCase();
  if (altKey) return null;
  if (ctrlKey || metaKey) {
    if (letter === 'a' && !shiftKey) return () => app.handles.selectAll();
    if (letter === 'z') return () => (shiftKey ? app.redo() : app.undo());
    return letter === 'y' && ctrlKey ? () => app.redo() : null;
  }
  if (key === 'Delete' || key === 'Backspace') return () => app.handles.removeSelected();
  if (key === 'Escape') return () => app.handles.select([]);
  const mode = shiftKey ? undefined : MODE_KEYS[letter];
  return mode ? () => app.handles.setMode(mode) : null;
}

/** In a field for text the keys belong to the text, in a list of choices those without Ctrl do. */
function isTyping({ target, ctrlKey, metaKey }: KeyboardEvent): boolean {
  if (target instanceof HTMLInputElement) return !['checkbox', 'radio', 'range', 'button'].includes(target.type);
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLSelectElement && !ctrlKey && !metaKey);
}
