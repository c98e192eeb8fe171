/** A net over a whole surface takes a while: the buttons that begin and stop it, and how far it is. */
import type { RemeshPhase } from '../../../wasm/chebnet';
import { partDone } from '../drape/phases';
import { make, makeButton, setText } from '../elements/dom';
import { setHidden } from '../elements/leave';
import { dialogWords } from '../language/dialogs';

const TEXT = dialogWords.drape;

interface MakerEvents {
  begun(): void;
  stopped(): void;
}

export class DrapeMaker {
  readonly #make: HTMLButtonElement;
  readonly #stop: HTMLButtonElement;
  readonly #words = make('label', { for: 'remesh-progress' });
  readonly #progress = make('progress', { id: 'remesh-progress', max: 1 });
  readonly #row = make('p', { class: 'progress', role: 'status', hidden: true }, this.#words, this.#progress);
  readonly element: HTMLElement;
  /** While there is no net: what the button does, and what will be seen then. */
  readonly lead = make('p', { class: 'quiet lead', role: 'status' });
  #isShown = false;
  #isBusy = false;
  #hasNet = false;

  constructor(events: MakerEvents) {
    this.#make = makeButton(TEXT.make, () => events.begun());
    this.#stop = makeButton(TEXT.stop, () => events.stopped(), { hidden: true });
    this.element = make('div', { class: 'maker', hidden: true }, this.#make, this.#stop, this.#row);
  }

  show(shown: boolean): void {
    this.#isShown = shown;
    this.element.hidden = !shown;
    this.#showLead();
  }

  /** Whether there is a surface to make a net on. */
  setReady(ready: boolean): void {
    this.#make.disabled = !ready;
  }

  /** Which net there is; `old`: of other settings. Unless there is a new one, to make it is what comes next. */
  setNet(net: 'none' | 'old' | 'new'): void {
    this.#make.classList.toggle('primary', net !== 'new');
    this.#hasNet = net !== 'none';
    this.#showLead();
  }

  setBusy(busy: boolean): void {
    this.#isBusy = busy;
    this.#showLead();
    const [comes, goes] = busy ? [this.#stop, this.#make] : [this.#make, this.#stop];
    comes.hidden = false;
    setHidden(goes, true, comes);
    this.#row.hidden = !busy;
    if (!busy) return;
    this.#progress.value = 0;
    setText(this.#words, TEXT.phases.triangles);
  }

  setProgress(phase: RemeshPhase, done: number): void {
    setText(this.#words, TEXT.phases[phase]);
    // What is tried again does not take it back.
    this.#progress.value = Math.max(this.#progress.value, partDone(phase, done));
  }

  #showLead(): void {
    const isIdle = this.#isShown && !this.#isBusy && !this.#hasNet;
    setText(this.lead, isIdle ? TEXT.noNetYet : '');
    this.lead.hidden = !isIdle;
  }
}
