/** Settings of a drag: how far from the dragged handles the net moves and other handles follow, whether they are kept to where it
 *  can follow, and what they snap to. */
import type { ChebnetDocument, HandleData } from '../document/document';
import type { Choice, HandleCommands } from '../handles/commands';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import { make, makeSection, makeSwitch } from '../elements/dom';
import type { Panel } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { RadiusSlider } from './radius_slider';
import { type Present, SnapControls } from './snap_controls';

const TEXT = panelWords.drag;

export class DragPanel implements Panel {
  readonly element: HTMLElement;
  readonly #locality: RadiusSlider;
  readonly #influence: RadiusSlider;
  readonly #snap: SnapControls;
  readonly #present: Present = { net: null, positions: null, handles: [], selection: [] };

  /** @param say tells the visitor what cannot be done. */
  constructor(commands: HandleCommands, say: (message: string) => void, failed: (error: unknown) => void) {
    const locality = { label: TEXT.locality, hint: TEXT.localityHint, none: TEXT.everything };
    this.#locality = new RadiusSlider('locality', locality, false, {
      preview: (radius) => commands.previewLocality(radius),
      choose: (radius) => commands.setLocality(radius),
    });
    const influence = { label: TEXT.influence, hint: TEXT.influenceHint, none: TEXT.none };
    this.#influence = new RadiusSlider('influence', influence, true, {
      preview: (radius) => commands.previewInfluence(radius),
      choose: (radius) => commands.setInfluence(radius),
    });
    const within = makeSwitch(TEXT.within, (on) => commands.setKeepWithin(on));
    within.row.title = TEXT.withinHint;
    within.box.checked = true;
    this.#snap = new SnapControls(commands, this.#present, say, failed);
    const reach = makeSwitch(TEXT.showReach, (on) => commands.setShowReach(on));
    reach.row.title = TEXT.showReachHint;
    const axes = make('p', { class: 'quiet' }, TEXT.axes);
    const sliders = [this.#locality.row, this.#influence.row];
    const rows = [...sliders, within.row, reach.row, ...this.#snap.rows, axes];
    this.element = makeSection(words.sections.drag, false, ...rows);
  }

  setNet(net: OpenedNet): void {
    this.#present.net = net;
    this.#locality.setSize(net.info.vertices);
    this.#influence.setSize(net.info.vertices);
    this.#snap.setNet(net);
  }

  onFrame({ positions, lengthScale }: FrameData): void {
    this.#present.positions = positions;
    this.#snap.setLengthScale(lengthScale);
  }

  setHandles(handles: readonly HandleData[], { selection }: Choice): void {
    Object.assign(this.#present, { handles, selection });
  }

  setDocument({ locality, influence, guide }: ChebnetDocument): void {
    this.#snap.setGuide(guide);
    this.#locality.update(locality);
    this.#influence.update(influence);
  }
}
