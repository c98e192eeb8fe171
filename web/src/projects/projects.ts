/** What the page opens with, and projects: kept by the browser, saved as files, opened again. */
import type { App } from '../app/app';
import { defaultScene } from '../document/defaults';
import { download } from '../files/download';
import { asFileName, baseNameOf } from '../files/file_name';
import { words } from '../language/language';
import { lazy } from '../lazy';
import { isCancelled } from '../worker/client';
import { Autosave } from './autosave';
import { projectFormat } from './format';
import { claim, findLast, findNewest, isMadeOfLink, isOwn, newId, read, release } from './kept';
import type { KeptProject } from './kept';
import { linking } from './linking';
import { clearCrashFlag, hasCrashFlag, setCrashFlag, setLossFlag } from './crash_flag';
import { codeOf, Failure, messageOf } from '../failure';

const collection = lazy(() => import('./collection'));
const choosing = lazy(() => import('./choosing'));
const wording = lazy(async () => (await import('../language/kept')).keptWords);

export class Projects {
  readonly #app: App;
  readonly #autosave: Autosave;
  /** Looked up while the solver loads. */
  readonly #last: Promise<KeptProject | undefined>;
  #saidNotKept = false;
  /** The revision of the history that is in a file, in the link in the address, or as it was kept. */
  #savedRevision = -1;
  /** The revision that was offered to be saved before it is given up. */
  #offeredRevision = -1;
  /** The revision of the history at which the worker was lost; null: it was not, or not by this document. */
  #lostAt: number | null = null;

  /** @param keeps whether the browser keeps what is done here, and opens with what it kept. */
  constructor(app: App, keeps: boolean) {
    this.#app = app;
    this.#autosave = new Autosave(app, () => this.#sayNotKept(), keeps);
    this.#last = keeps ? findLast().catch(() => undefined) : Promise.resolve(undefined);
    app.on('restarted', () => this.#flagLoss());
    app.on('settled', () => this.#forgetLoss());
  }

  // ------------------------------------------------------------------------------------------------------------ the start

  /** Opens what this tab has made of the link in the address, else the link, else what was kept, else the first net. If something
   *  cannot be opened the user is told. */
  async start(): Promise<void> {
    const hash = location.hash.length > 1 ? location.hash : null;
    let after = (): void => {};
    try {
      await this.#app.start();
      const last = await this.#last;
      const goesOn = hash === null || (last && isMadeOfLink(last.id));
      after = goesOn ? await this.#startWithLast(last) : await this.#startWithLink(hash, last);
    } catch (error) {
      this.#app.report(error);
    }
    if (this.#app.opening === null) await this.#openFirst().catch((error: unknown) => this.#app.report(error));
    after();
  }

  /** These return the message to show once a net is open. */
  async #startWithLink(hash: string, last: KeptProject | undefined): Promise<() => void> {
    const open = (): Promise<void> => this.#openFlagged(hash, () => this.#openLink(hash));
    const hasDied = await hasCrashFlag(hash);
    if (!hasDied) await open();
    const text = await wording();
    if (hasDied) return () => this.#offer(text.diedLink, text.openAnyway, open);
    const { titleOf } = await linking();
    return () => {
      if (last) this.#offer(text.linkOpened(titleOf(hash)), text.restoreLast, () => this.#restoreInstead(last));
    };
  }

  async #startWithLast(last: KeptProject | undefined): Promise<() => void> {
    if (last === undefined) return () => {};
    const hasDied = (await hasCrashFlag(last.id)) || (await hasCrashFlag(location.hash));
    if (!hasDied) await this.#restore(last);
    const text = await wording();
    if (hasDied) return () => this.#offer(text.diedKept, text.openAnyway, () => this.#restoreInstead(last));
    return () => this.#offer(text.restored, text.startAfresh, () => this.newNet());
  }

  #offer(message: string, label: string, doing: () => Promise<unknown>): void {
    const run = (): void => void doing().catch((error: unknown) => this.#app.report(error));
    this.#app.say(message, { label, run });
  }

  // ----------------------------------------------------------------------------------------------------------- what is open

  async newNet(): Promise<void> {
    await this.#autosave.save();
    await this.#app.openScene(defaultScene(), { name: ['newNet'], key: null });
    await this.#keepAs(newId());
  }

  /** At once: after a reload the tab opens what it kept last. */
  #keepAs(id: string): Promise<void> {
    this.#autosave.begin(id, true);
    return this.#autosave.save();
  }

  async followLink(): Promise<void> {
    const { hash } = location;
    await this.#openFlagged(hash, () => this.#openLink(hash));
    const { linkFollowed } = await wording();
    this.#app.say(linkFollowed((await linking()).titleOf(hash)));
  }

  /** What was kept before the present net. */
  async restoreLast(): Promise<void> {
    const last = await findNewest(this.#autosave.id).catch(() => undefined);
    const text = await wording();
    if (last === undefined) return this.#app.say(text.noOther);
    if (await this.#restoreInstead(last)) this.#app.say(text.lastRestored);
  }

  /** The projects that the browser keeps, to choose from. */
  async choose(root: HTMLElement): Promise<void> {
    const { chooseProject } = await choosing();
    await this.#autosave.save();
    chooseProject(root, {
      present: this.#autosave.id,
      open: (id) => this.#openKept(id),
      keepPresent: () => this.#keepAs(this.#autosave.id),
    });
  }

  /** Where another tab has it open, a copy. */
  async #openKept(id: string): Promise<void> {
    await this.#autosave.save();
    if (await this.#isToBeSaved()) return;
    const kept = await read(id);
    if (kept === undefined) return;
    const isFree = await claim(id);
    await this.#openProject(kept, isFree);
    await this.#keepAs(isFree ? id : newId());
    const { opened, copyOpened } = await wording();
    this.#app.say(isFree ? opened : copyOpened);
  }

  /** Reloads the page with the edited net rather than with the link it came from. Where the browser stores nothing, a new link
   *  carries the net over; one too large for that is to be saved first. */
  async reload(): Promise<void> {
    await this.#autosave.save();
    const { keepsNothing, id } = this.#autosave;
    if (!keepsNothing && isOwn(id)) return location.replace(location.pathname + location.search);
    if (keepsNothing && !(await this.#putIntoAddress()) && !this.#isInFile)
      return this.#offerToSave((await wording()).notKept);
    location.reload();
  }

  /** The browser stores nothing of it, and no file has it. */
  get #isUnsaved(): boolean {
    return this.#autosave.refused && !this.#isInFile;
  }

  /** As it is now, or in the address. */
  get #isInFile(): boolean {
    return this.#app.history.revision === this.#savedRevision;
  }

  /** Whether a project is not opened yet, as the present net and its history would be lost: asked again, it is. */
  async #isToBeSaved(): Promise<boolean> {
    const { revision } = this.#app.history;
    if (!this.#isUnsaved || this.#offeredRevision === revision) return false;
    this.#offeredRevision = revision;
    this.#offerToSave((await wording()).wouldBeLost);
    return true;
  }

  /** False: it is too large. */
  async #putIntoAddress(): Promise<boolean> {
    const { hash } = (await linking()).hashOf(this.#app);
    if (hash === null) return false;
    history.replaceState(null, '', hash);
    this.#savedRevision = this.#app.history.revision;
    return true;
  }

  /** Fails if it is too large. */
  async save(): Promise<void> {
    const { PROJECT_ENDING, checkSize, leastBytes, projectText } = await projectFormat();
    const project = this.#app.project();
    const { revision } = this.#app.history;
    if (project === null) return;
    const { net } = project.entries[project.present]!.state;
    const title = await this.#title();
    const name = (asFileName(title) || baseNameOf(net, this.#app.formats)) + PROJECT_ENDING;
    checkSize(name, leastBytes(project));
    const text = projectText({ ...project, title });
    checkSize(name, text.length);
    download(name, text, 'application/json');
    this.#savedRevision = revision;
  }

  /** Where the browser keeps nothing, nothing has a name. */
  async #title(): Promise<string> {
    try {
      return await (await collection()).nameOfProject(this.#autosave.id);
    } catch {
      return '';
    }
  }

  async #nameIt(id: string, title: string): Promise<void> {
    try {
      await (await collection()).renameProject(id, title);
    } catch {
      // Nor can it be kept, which is said.
    }
  }

  /** Whether a file is to be opened as a project, by its name. */
  isProject({ name }: File): boolean {
    return /\.json$/i.test(name);
  }

  async openFile(file: File): Promise<void> {
    await this.#autosave.save();
    if (await this.#isToBeSaved()) return;
    const { checkSize, parseProject } = await projectFormat();
    const text = await wording();
    checkSize(file.name, file.size);
    let title: string | undefined;
    try {
      const project = parseProject(await file.text());
      title = project.title;
      await this.#app.openProject(project);
    } catch (error) {
      if (isCancelled(error)) throw error;
      throw new Failure('bad_project', text.fault(file.name, messageOf(error)));
    }
    this.#savedRevision = this.#app.history.revision;
    const id = newId();
    if (title) await this.#nameIt(id, title);
    this.#autosave.begin(id, true);
    this.#app.say(text.opened);
  }

  async #openFirst(): Promise<void> {
    await this.#app.openScene(defaultScene());
    this.#autosave.begin(newId(), false);
  }

  async #openLink(hash: string): Promise<void> {
    const isFirst = this.#app.opening === null;
    const { sceneOf } = await linking();
    await this.#app.openScene(await sceneOf(hash), { name: ['link'], key: null });
    if (isFirst) this.#autosave.begin(newId(), false);
  }

  /** Opened at the start of the tab the project is kept already; opened later it is kept anew. */
  async #restore({ id, project }: KeptProject): Promise<void> {
    const isFirst = this.#app.opening === null;
    const goesOn = isFirst && isOwn(id) && (await claim(id));
    await this.#openProject({ id, project }, goesOn);
    this.#autosave.begin(goesOn ? id : newId(), !isFirst);
  }

  /** In place of the present net. False: that is to be saved first. */
  async #restoreInstead(last: KeptProject): Promise<boolean> {
    await this.#autosave.save();
    if (await this.#isToBeSaved()) return false;
    await this.#restore(last);
    return true;
  }

  /** One that is `claimed` for this tab is not any more if that fails. */
  async #openProject({ id, project }: KeptProject, claimed: boolean): Promise<void> {
    try {
      const { readProject } = await projectFormat();
      await this.#openFlagged(id, () => this.#app.openProject(readProject(project)));
      this.#savedRevision = this.#app.history.revision;
    } catch (error) {
      if (claimed) release(id);
      throw error;
    }
  }

  // ---------------------------------------------------------------------------------------------------------------- failures

  /** Sets the crash flag until the net has settled. An orderly refusal clears it: the next start may try again. */
  async #openFlagged(what: string, open: () => Promise<void>): Promise<void> {
    const clear = setCrashFlag(what);
    try {
      await open();
    } catch (error) {
      if (codeOf(error) === 'worker_lost') setLossFlag(what);
      else clear();
      throw error;
    }
    void this.#app.settled().then(clear);
  }

  #flagLoss(): void {
    this.#lostAt = this.#app.history.revision;
    setLossFlag(location.hash.length > 1 ? location.hash : this.#autosave.id);
  }

  /** Clears the crash flag if the document was changed since the worker was lost. */
  #forgetLoss(): void {
    if (this.#lostAt === null || this.#lostAt === this.#app.history.revision) return;
    this.#lostAt = null;
    clearCrashFlag();
  }

  #sayNotKept(): void {
    // The same listener each time.
    addEventListener('beforeunload', this.#warn);
    if (this.#saidNotKept) return;
    this.#saidNotKept = true;
    wording()
      .then(({ notKept }) => this.#offerToSave(notKept))
      .catch(() => (this.#saidNotKept = false));
  }

  #offerToSave(why: string): void {
    const save = (): void => void this.save().catch((error: unknown) => this.#app.report(error));
    this.#app.offer(why, words.projects.menu.save.title, save);
  }

  /** Has the browser ask whether to leave. */
  readonly #warn = (event: Event): void => {
    if (this.#isUnsaved) event.preventDefault();
  };
}
