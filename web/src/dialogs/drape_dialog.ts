/** A net being laid on a surface: the seed is dragged in the picture, the rest is set at the side, and the net follows.
 *  Cancel ends it at any time, and so does Escape, which ends what is being drawn first. */
import type { Mesh, Point, RemeshOptions } from '../../../wasm/chebnet';
import type { GuideSource, UpAxis } from '../document/document';
import { createPicture } from '../drape/drape_picture';
import type { Picture } from '../drape/drape_picture';
import type {
  DrapedNet,
  DrapeRequest,
  DrapeSettings,
  Proposal,
  RemeshedNet,
  Seed,
  ShownNet,
  ShownSurface,
  SurfaceSource,
} from '../drape/drape_protocol';
import { Draping } from '../drape/draping';
import type { DrapeWorkerLike } from '../drape/draping';
import { make, makeButton, setText } from '../elements/dom';
import { proposedHandles } from '../handles/proposal';
import { dialogWords } from '../language/dialogs';
import { words } from '../language/language';
import type { DraperLike, TakenNet } from './file_opener';
import { DrapeArms } from './drape_arms';
import { DrapeCreases } from './drape_creases';
import { DrapeCuts } from './drape_cuts';
import { DrapeForm } from './drape_form';
import { DrapeMaker } from './drape_maker';
import { DrapeProposals } from './drape_proposals';
import { DrapeResults } from './drape_results';
import { DrapeSingular } from './drape_singular';
import { netName } from './taken_scene';
import './dialog.css';
import './pictured.css';
import './drape_dialog.css';

const TEXT = dialogWords.drape;
/** Of our own surfaces. */
const FIRST = 'shell';
/** Of a normal, degrees: from farther a net is seen at a flat angle, and a mark hardly at all. */
const [SEED_SEEN_WITHIN, MARK_SEEN_WITHIN] = [60, 78];

/** A surface that a visitor brings, by the name of its file. */
export interface GivenSurface {
  name: string;
  mesh: Mesh;
}

interface DrapeDialogParts {
  /** The visitor wants to bring a surface in a file; without it there is no such button. */
  fileWanted?: () => void;
  spawnWorker(): DrapeWorkerLike;
  /** Of the surface that the visitor brings. */
  upAxis: UpAxis;
}

export class DrapeDialog implements DraperLike {
  /** null: the visitor has given up. */
  readonly result: Promise<TakenNet | null>;
  readonly #dialog: HTMLDialogElement;
  readonly #given: GivenSurface | null;
  readonly #givenUp: UpAxis;
  readonly #draping: Draping;
  readonly #picture: Picture;
  readonly #form: DrapeForm;
  readonly #results = new DrapeResults();
  readonly #proposals = new DrapeProposals((proposal) => this.#begin(proposal));
  readonly #maker = new DrapeMaker({ begun: () => this.#remesh(), stopped: () => this.#stop() });
  readonly #arms = new DrapeArms({
    drawingChanged: (drawing) => {
      if (drawing) this.#cuts.setCutting(false);
      this.#setDrawing(drawing);
    },
    shown: (curve, points) => {
      if (!this.#form.isWhole) this.#picture.setCurves(curve === null ? [] : [curve], points);
    },
    traceWanted: (points, revision) => this.#draping.trace('arms', points, revision),
    changed: () => this.#drape(),
  });
  readonly #cuts = new DrapeCuts({
    cuttingChanged: (cutting) => {
      if (cutting) this.#arms.stopDrawing();
      this.#setDrawing(cutting);
    },
    shown: (cuts, points) => this.#picture.setCuts(cuts, points),
    traceWanted: (points, revision) => this.#draping.trace('cuts', points, revision),
    shortestWanted: (from, cuts, revision) => this.#draping.findShortestCut(from, cuts, revision),
    seed: () => this.#seedShown(),
    changed: () => this.#drape(),
    proposalsWanted: () => this.#draping.proposeCuts({ ...this.#settings(), seed: this.#seedShown() }),
  });
  readonly #singular = new DrapeSingular({
    shown: (marks) => this.#picture.setMarks(marks),
    pointingChanged: (pointing) => {
      if (pointing) this.#creases.setDrawing(false);
      this.#picture.setCutting(pointing);
    },
    placeWanted: (at, mark, revision) => this.#draping.place(at, mark, revision),
    edgeLength: () => this.#form.read().length,
    faced: (place) => this.#picture.face(place, MARK_SEEN_WITHIN),
  });
  readonly #creases = new DrapeCreases({
    drawingChanged: (drawing) => {
      if (drawing) this.#singular.rest();
      this.#picture.setCutting(drawing);
    },
    shown: (creases, points) => {
      if (this.#form.isWhole) this.#picture.setCurves(creases, points);
    },
    traceWanted: (points, revision) => this.#draping.trace('creases', points, revision),
  });
  readonly #howTo = make('figcaption', { class: 'quiet' }, TEXT.howTo);
  readonly #take = makeButton(TEXT.take, () => this.#takeNet(), { class: 'primary', disabled: true });
  /** The surface that is shown. */
  #surface: GuideSource;
  /** Its name. */
  #name: string;
  /** Where the net is wanted to begin, until another seed is. */
  #seed: DrapeSettings['seed'] = [0, 0, 0];
  #shown: DrapedNet | RemeshedNet | null = null;
  /** Settings of the net over the whole that is shown, and of the one that is being made. */
  #madeWith: RemeshOptions = {};
  #makesWith: RemeshOptions = {};
  #best: Proposal | null = null;
  #proposedFor = '';
  /** The net is the first one of its proposal. */
  #isFirst = true;
  #isMaking = false;
  /** The net that is being laid is to be taken. */
  #isTaking = false;
  #finish!: (net: TakenNet | null) => void;

  constructor(root: HTMLElement, given: GivenSurface | null, parts: DrapeDialogParts) {
    this.#given = given;
    this.#givenUp = parts.upAxis;
    this.#surface = given ?? { own: FIRST };
    this.#name = given?.name ?? FIRST;
    const picture = make('div', { class: 'picture' });
    const heading = make('h2', { id: 'drape-title' }, TEXT.title);
    this.#form = new DrapeForm(given?.name ?? null, this.#arms.element, {
      surfaceChosen: (own) => this.#open(own),
      kindChanged: () => this.#changeKind(),
      changed: () => this.#change(),
      shearChanged: (shown) => this.#picture.setShear(shown),
    });
    const figure = make('figure', {}, picture, this.#howTo, this.#proposals.element, this.#results.element);
    const side = make(
      'div',
      { class: 'side' },
      this.#results.prospect,
      this.#results.numbers,
      this.#form.element,
      this.#cuts.element,
      this.#creases.element,
      this.#singular.element,
    );
    this.#dialog = make(
      'dialog',
      { class: 'file pictured drape', 'aria-labelledby': heading.id },
      heading,
      make('div', { class: 'body' }, figure, side),
      make(
        'div',
        { class: 'buttons' },
        this.#maker.element,
        this.#take,
        ...(parts.fileWanted ? [makeButton(TEXT.fromFile, parts.fileWanted)] : []),
        makeButton(TEXT.cancel, () => this.close()),
        this.#maker.lead,
      ),
    );
    // The way back on a phone is no key.
    this.#dialog.addEventListener('cancel', (event) => {
      if (this.#abandonDrawing()) event.preventDefault();
    });
    root.append(this.#dialog);
    this.#dialog.showModal();
    this.#picture = createPicture(picture, TEXT.picture, {
      seedMoved: (ray) => this.#drapeFrom(ray),
      turned: (direction) => this.#turn(direction),
      seedBack: ({ position, direction }) => this.#turn(direction, position),
      pointed: (at) => (this.#drawn === null ? this.#singular.point(at) : this.#drawn.add(at)),
      cutEnded: () => this.#drawn?.end(),
      cutAbandoned: () => this.#abandonDrawing(),
      cutUndone: () => (this.#drawn ?? this.#singular).undo(),
      cutMoved: (to) => this.#creases.move(to),
      markChosen: (mark) => this.#singular.choose(mark),
      markTaken: () => this.#singular.begin(),
      markMoved: (mark, at) => this.#singular.move(mark, at),
      markBack: () => this.#singular.back(),
      markRemoved: () => this.#singular.remove(),
    });
    this.#picture.focus();
    this.#draping = new Draping(() => parts.spawnWorker(), {
      opened: (surface, length) => this.#onOpened(surface, length),
      proposed: (proposals) => this.#onProposed(proposals),
      traced: (line, revision) => {
        this.#cuts.setTraced(line, revision);
        this.#arms.setTraced(line, revision);
        this.#creases.setTraced(line, revision);
      },
      cutFound: (cut, revision) => this.#cuts.setFound(cut, revision),
      placed: (place, mark, revision) => this.#singular.setPlace(place, mark, revision),
      cutsProposed: (cuts, coverage) => this.#cuts.setProposed(cuts, coverage),
      draped: (net) => this.#onDraped(net),
      missed: () => this.#onMissed(),
      measured: (report, milliseconds) => {
        this.#results.setReport(report, milliseconds);
        if (this.#form.isWhole) this.#form.showMadeLength(report.length);
      },
      progressed: (phase, done) => this.#maker.setProgress(phase, done),
      remeshed: (net) => this.#onRemeshed(net),
      refused: ({ message }, request) => this.#onRefused(message, request),
    });
    this.result = this.#untilFinished();
    this.#open(given === null ? FIRST : null);
  }

  close(): void {
    this.#finish(null);
  }

  /** Of the surface that is shown: z of our own, whatever is up in the one beside them. */
  get #up(): UpAxis {
    return this.#surface === this.#given ? this.#givenUp : 'z';
  }

  /** What is drawn by points; null: points are singular vertices. */
  get #drawn(): DrapeArms | DrapeCuts | DrapeCreases | null {
    if (this.#form.isWhole) return this.#creases.isDrawing ? this.#creases : null;
    return this.#arms.isDrawing ? this.#arms : this.#cuts;
  }

  /** Whether presses on the surface set points of a line. */
  #setDrawing(drawing: boolean): void {
    this.#picture.setCutting(drawing);
    setText(this.#howTo, drawing ? TEXT.pointing : TEXT.howTo);
  }

  /** False: nothing is drawn. */
  #abandonDrawing(): boolean {
    return [this.#arms, this.#cuts, this.#creases, this.#singular].some((each) => each.abandon());
  }

  async #untilFinished(): Promise<TakenNet | null> {
    const net = await new Promise<TakenNet | null>((resolve) => {
      this.#finish = resolve;
      this.#dialog.addEventListener('close', () => resolve(null));
    });
    this.#draping.close();
    this.#picture.dispose();
    this.#dialog.close();
    this.#dialog.remove();
    return net;
  }

  #open(own: string | null): void {
    const source: SurfaceSource = own === null ? { mesh: this.#given!.mesh } : { own };
    this.#surface = own === null ? this.#given! : { own };
    this.#name = own ?? this.#given!.name;
    if (this.#isMaking) this.#stop();
    this.#setNet(null);
    this.#best = null;
    this.#maker.setReady(false);
    this.#results.setSurface(null);
    this.#proposals.set([]);
    this.#draping.open(source);
  }

  #onOpened(surface: ShownSurface, length: number): void {
    this.#picture.setSurface(surface, this.#up);
    this.#arms.reset();
    this.#cuts.reset(surface.report.boundaryLoops);
    this.#creases.reset();
    this.#singular.reset(surface);
    this.#results.setSurface(surface.report);
    this.#form.setSurface(surface.report, length);
    this.#maker.setReady(true);
    if (!this.#form.isWhole) this.#results.expectNet();
    this.#proposedFor = this.#proposable();
    // In the best direction: that of the form is of the net before.
    const { direction: _, ...settings } = this.#form.read();
    this.#draping.propose(settings);
  }

  #onProposed(proposals: Proposal[]): void {
    this.#proposals.set(proposals, this.#up);
    this.#best = proposals[0]!;
    if (!this.#form.isWhole) this.#begin(this.#best);
  }

  /** The net stays, and is of the seed that is shown: what is set next is tried there. */
  #onMissed(): void {
    this.#isTaking &&= this.#draping.isLaying;
    this.#seed = this.#seedShown();
    this.#results.keepNet();
  }

  /** @param request that is refused; null: what has been asked for is lost. */
  #onRefused(message: string, request: DrapeRequest['type'] | null): void {
    if (request === null || request === 'remesh') this.#setMaking(false);
    if (request === null) this.#maker.setReady(false);
    this.#isTaking &&= this.#draping.isLaying;
    this.#arms.giveUp();
    this.#cuts.giveUp();
    this.#creases.giveUp();
    this.#results.setFault(words.core.sentence(message));
    this.#showStanding();
  }

  // ------------------------------------------------------------------------------------------- a net over the whole of it

  #changeKind(): void {
    const { isWhole } = this.#form;
    if (this.#isMaking) this.#stop();
    if (isWhole) this.#arms.stopDrawing();
    if (isWhole) this.#cuts.rest();
    this.#maker.show(isWhole);
    this.#proposals.element.hidden = isWhole;
    this.#cuts.element.hidden = isWhole;
    this.#singular.show(isWhole);
    this.#creases.show(isWhole);
    this.#howTo.hidden = isWhole;
    this.#setNet(null);
    this.#picture.removeNet();
    this.#results.setKind(isWhole ? 'whole' : 'piece');
    if (!isWhole && this.#best !== null) this.#begin(this.#best);
  }

  #remesh(): void {
    if (!this.#form.isAllowed()) return;
    this.#setMaking(true);
    this.#results.expectWholeNet();
    this.#makesWith = this.#form.readWhole();
    this.#draping.remesh({ ...this.#makesWith, ...this.#singular.read(), ...this.#creases.read() });
  }

  /** A net that was made before is there again. */
  #stop(): void {
    this.#draping.stop(this.#shown && meshOf(this.#shown));
    this.#cuts.giveUp();
    this.#results.keepNet();
    this.#setMaking(false);
  }

  #setMaking(making: boolean): void {
    this.#isMaking = making;
    this.#maker.setBusy(making);
    this.#singular.setBusy(making);
    this.#creases.setBusy(making);
    this.#showStanding();
  }

  #onRemeshed(net: RemeshedNet): void {
    this.#madeWith = this.#makesWith;
    this.#setMaking(false);
    this.#setNet(net);
    this.#picture.setNet(net, null);
    this.#results.setNet(net, TEXT.againstFolds[this.#form.wayAgainstFolds]);
    this.#singular.setNet(net);
    this.#creases.setNet(net);
  }

  // ---------------------------------------------------------------------------------------------- one piece from a seed

  #begin({ seed, direction }: Proposal): void {
    this.#isFirst = true;
    this.#turn(direction, seed);
  }

  #onDraped(net: DrapedNet): void {
    if (this.#form.isWhole) return;
    if (this.#isFirst) this.#picture.face(net.seed, SEED_SEEN_WITHIN);
    this.#isFirst = false;
    this.#setNet(net);
    this.#picture.setNet(net, net.seed);
    this.#results.setNet(net);
    this.#form.setSeed(net.seed);
    this.#form.setTurnable(net.arms !== 'curve');
    this.#arms.setShown(net.arms);
    this.#seed = net.seed.position;
    if (this.#isTaking) this.#takeNet();
  }

  #setNet(net: DrapedNet | RemeshedNet | null): void {
    this.#shown = net;
    this.#isTaking &&= net !== null;
    this.#showStanding();
  }

  /** Over the whole surface only a net of the settings in sight can be opened, or one is to be made first. A single piece follows
   *  them at once; what is drawn and pinned is said to hold for the next net. */
  #showStanding(): void {
    const hasNet = this.#shown !== null;
    const isOld = hasNet && this.#form.isWhole && !isSame(this.#form.readWhole(), this.#madeWith);
    this.#take.disabled = !hasNet || this.#isMaking || isOld;
    this.#maker.setNet(!hasNet ? 'none' : isOld ? 'old' : 'new');
    this.#results.setOutdated(isOld && !this.#isMaking);
  }

  #drapeFrom(seed: DrapeSettings['seed']): void {
    this.#seed = seed;
    this.#drape();
  }

  #turn(direction: Point, seed: Seed['position'] | null = null): void {
    if (seed !== null) this.#seed = seed;
    this.#form.setDirection(direction);
    this.#drape();
  }

  #change(): void {
    if (this.#form.isWhole) return this.#changeWhole();
    this.#proposals.setStale(this.#proposable() !== this.#proposedFor);
    this.#drape();
  }

  /** On what of the form it hangs how proposals lie. */
  #proposable(): string {
    return JSON.stringify({ ...this.#form.read(), direction: null });
  }

  /** A net that is being made is not of the settings any more. */
  #changeWhole(): void {
    if (this.#isMaking) this.#stop();
    this.#showStanding();
  }

  #drape(): void {
    if (this.#form.isWhole) return;
    this.#results.expectNet();
    this.#draping.drape(this.#settings());
  }

  /** Where the net that is shown begins: a wanted seed may be beside the surface. */
  #seedShown(): Point {
    return this.#shown !== null && 'seed' in this.#shown ? this.#shown.seed.position : [0, 0, 0];
  }

  #settings(): DrapeSettings {
    return { ...this.#form.read(), ...this.#arms.read(), seed: this.#seed, cuts: this.#cuts.read() };
  }

  /** A net of other settings than are in sight is not opened without a word: one that is still being laid, once it is there. */
  #takeNet(): void {
    if (!this.#form.isAllowed()) return;
    this.#isTaking = this.#draping.isLaying;
    if (!this.#isTaking) this.#finish(this.#taken());
  }

  #taken(): TakenNet | null {
    if (this.#shown === null) return null;
    return {
      net: { mesh: meshOf(this.#shown), name: netName(this.#name) },
      handles: proposedHandles(this.#shown.net),
      guide: this.#surface,
      upAxis: this.#up,
    };
  }
}

function meshOf({ net }: ShownNet): Mesh {
  const { restPositions: positions, faceStart, faceVertices } = net;
  return { positions, faceStart, faceVertices };
}

function isSame(settings: RemeshOptions, others: RemeshOptions): boolean {
  return JSON.stringify(settings) === JSON.stringify(others);
}
