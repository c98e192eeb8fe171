/** How the solve is going: the numbers of the moment, and the record of convergence. */
import type { ChebnetDocument, HandleData } from '../document/document';
import { makeSection } from '../elements/dom';
import { words } from '../language/language';
import type { Tables } from '../net/tables';
import type { Panel } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { ConvergencePlot } from './convergence_plot';
import { LiveNumbers } from './live_numbers';

export class ConvergencePanel implements Panel {
  readonly #numbers = new LiveNumbers();
  readonly #plot = new ConvergencePlot();
  readonly element = makeSection(words.sections.convergence, true, this.#numbers.element, this.#plot.element);
  #usualThreshold = 1e-6;

  showTables({ options }: Tables): void {
    this.#usualThreshold = options.find(({ name }) => name === 'threshold')?.value ?? this.#usualThreshold;
  }

  showDocument({ options }: ChebnetDocument): void {
    this.#plot.setThreshold(Number(options.threshold ?? this.#usualThreshold));
  }

  showNet(net: OpenedNet): void {
    this.#numbers.showNet(net);
    this.#plot.clear();
  }

  showHandles(handles: readonly HandleData[]): void {
    this.#numbers.showHandles(handles.length);
  }

  takeFrame({ trace }: FrameData): void {
    this.#plot.add(trace);
  }

  showFrame(frame: FrameData, framesPerSecond: number): void {
    this.#numbers.showFrame(frame, framesPerSecond);
    this.#plot.refresh();
  }
}
