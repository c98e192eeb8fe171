/** How the solve is going: the numbers of the moment, and the record of convergence. */
import type { ChebnetDocument, HandleData } from '../document/document';
import { makeSection } from '../elements/dom';
import { words } from '../language/language';
import type { Tables } from '../net/tables';
import type { Panel } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { ConvergencePlot } from './convergence_plot';
import { LiveNumbers } from './live_numbers';
import { StageNames } from './stage_names';

export class ConvergencePanel implements Panel {
  readonly #numbers = new LiveNumbers();
  readonly #plot = new ConvergencePlot();
  readonly element = makeSection(words.sections.convergence, true, this.#numbers.element, this.#plot.element);
  readonly #stages = new StageNames();
  #usualThreshold = 1e-6;

  setTables({ options, methods }: Tables): void {
    this.#stages.setTables({ methods });
    this.#usualThreshold = options.find(({ name }) => name === 'threshold')?.value ?? this.#usualThreshold;
  }

  setDocument({ options }: ChebnetDocument): void {
    this.#plot.setThreshold(Number(options.threshold ?? this.#usualThreshold));
  }

  setNet(net: OpenedNet): void {
    this.#numbers.setNet(net);
    this.#plot.clear();
  }

  setHandles(handles: readonly HandleData[]): void {
    this.#numbers.setHandles(handles.length);
  }

  onFrame({ trace, method }: FrameData): void {
    this.#plot.add(trace, (stage) => this.#stages.of(method, stage));
  }

  setFrame(frame: FrameData, framesPerSecond: number, solving: boolean): void {
    this.#numbers.setFrame(frame, this.#stages.of(frame.method, frame.stage), framesPerSecond, solving);
    this.#plot.refresh();
  }
}
