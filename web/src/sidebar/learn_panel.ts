/** What a Chebyshev net is and how it is solved, with the net in the picture for a figure. */
import { worstRatio } from '../net/energy';
import { words } from '../language/language';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { make, makeButton, makeSection, setText } from '../elements/dom';
import { EnergyGraph } from './energy_graph';
import type { Lesson, Panel, PanelEvents } from '../panels';
import './learn_panel.css';

const TEXT = words.learn;

export class LearnPanel implements Panel {
  readonly element: HTMLDetailsElement;
  private readonly graph = new EnergyGraph();
  private readonly now = make('p', { class: 'quiet' });
  private readonly stages = TEXT.stageTexts.map((text) => make('li', {}, text));
  private net: OpenedNet | null = null;
  private frame: FrameData | null = null;
  /** Of the last iteration that had one. */
  private p = 2;

  constructor(events: PanelEvents) {
    const lesson = (name: Lesson, ...more: Node[]): HTMLElement => {
      const { title, text, show } = TEXT.lessons[name];
      const button = makeButton(TEXT.showMe, () => events.showLesson(name), {
        title: show,
        'aria-label': `${TEXT.showMe} ${show}`,
      });
      return make('section', { class: 'lesson' }, make('h3', {}, title), make('p', {}, text), ...more, button);
    };
    this.element = makeSection(
      TEXT.title,
      false,
      lesson('net'),
      lesson('deviation'),
      lesson('energy', this.graph.element, this.now),
      lesson('stages', make('ol', {}, ...this.stages)),
      make(
        'p',
        { class: 'quiet' },
        make('a', { href: './licences.txt', target: '_blank', rel: 'noopener' }, TEXT.licences),
      ),
    );
    this.element.addEventListener('toggle', () => {
      if (this.element.open) this.element.scrollIntoView({ block: 'start' });
      this.showFrame();
    });
  }

  showNet(net: OpenedNet): void {
    this.net = net;
  }

  takeFrame(frame: FrameData): void {
    this.frame = frame;
    this.p = frame.trace.filter(({ p }) => p > 0).at(-1)?.p ?? this.p;
  }

  showFrame(): void {
    const { net, frame, p } = this;
    if (!this.element.open || net === null || frame === null) return;
    const ratio = worstRatio(net, frame);
    this.graph.show(p, ratio);
    setText(this.now, TEXT.now(p, ratio.toPrecision(5)));
    this.stages.forEach((each, i) => {
      if (frame.status === 'running' && frame.stage === i + 1) each.setAttribute('aria-current', 'step');
      else each.removeAttribute('aria-current');
    });
  }
}
