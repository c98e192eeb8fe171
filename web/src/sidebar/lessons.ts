/** What a Chebyshev net is and how it is solved, with the net in the picture for a figure. */
import { make, makeButton, setText } from '../elements/dom';
import { learnWords as TEXT } from '../language/learn';
import { worstRatio } from '../net/energy';
import { type Lesson, type PanelEvents, TAUGHT_METHOD } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { EnergyGraph } from './energy_graph';
import { withFormulas } from './formulas';
import './lessons.css';

export class Lessons {
  readonly content: HTMLElement[];
  readonly #graph = new EnergyGraph();
  readonly #now = make('p', { class: 'quiet' });
  /** In both lessons that go step by step. */
  readonly #waits = [0, 1].map(() => make('p', { class: 'quiet', role: 'status' }));
  readonly #stages = TEXT.stageTexts.map((text) => make('li', {}, ...withFormulas(text)));

  constructor(events: PanelEvents) {
    const lesson = (name: Lesson, ...more: Node[]): HTMLElement => {
      const { title, text, show } = TEXT.lessons[name];
      const button = makeButton(TEXT.showMe, () => events.showLesson(name), {
        title: show,
        'aria-label': `${TEXT.showMe} ${show}`,
      });
      return make(
        'section',
        { class: 'lesson' },
        make('h3', {}, title),
        make('p', {}, ...withFormulas(text)),
        ...more,
        button,
      );
    };
    const licences = make('a', { href: './licences.txt', target: '_blank', rel: 'noopener' }, TEXT.licences);
    this.content = [
      lesson('net'),
      lesson('deviation'),
      lesson('energy', this.#graph.element, this.#now, this.#waits[0]!),
      lesson('stages', make('ol', {}, ...this.#stages), this.#waits[1]!),
      make('p', { class: 'quiet' }, licences),
    ];
  }

  /** @param p the exponent of the moment. */
  update(net: OpenedNet, frame: FrameData, p: number, solving: boolean): void {
    const ratio = worstRatio(net, frame);
    this.#graph.update(p, ratio);
    setText(this.#now, TEXT.now(p, ratio.toPrecision(5)));
    const isTaught = frame.method === TAUGHT_METHOD && frame.status === 'running';
    const waits = isTaught && !solving && frame.iterations > 0;
    for (const each of this.#waits) setText(each, waits ? TEXT.waits : '');
    this.#stages.forEach((each, i) => {
      if (isTaught && frame.stage === i + 1) each.setAttribute('aria-current', 'step');
      else each.removeAttribute('aria-current');
    });
  }
}
