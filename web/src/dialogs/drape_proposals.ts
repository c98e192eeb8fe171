/** Where a net would begin well, as pictures to choose from. */
import type { UpAxis } from '../document/document';
import type { Proposal } from '../drape/drape_protocol';
import { make, makeButton } from '../elements/dom';
import { drawThumbnail, type Wireframe } from '../elements/thumbnail';
import { dialogWords } from '../language/dialogs';
import { Space } from '../view/space';
import { percentWords } from './file_words';

const TEXT = dialogWords.drape;

function wordsOf({ covered, muchSheared, meanDistance }: Proposal): string[] {
  return TEXT.proposed(percentWords(covered), percentWords(muchSheared), meanDistance.toFixed(3));
}

export class DrapeProposals {
  readonly element = make('div', { class: 'proposals', role: 'group', 'aria-label': TEXT.proposals });
  readonly #chosen: (proposal: Proposal) => void;

  constructor(chosen: (proposal: Proposal) => void) {
    this.#chosen = chosen;
  }

  /** The best first. */
  set(proposals: readonly Proposal[], up?: UpAxis): void {
    const canvases = proposals.map(() => make('canvas'));
    this.element.replaceChildren(
      ...proposals.map((proposal, i) => {
        const how = wordsOf(proposal);
        // Apart by spaces, as in the name of the button: who speaks what they read is understood.
        const caption = make('small', {}, ...how.flatMap((line) => [make('span', {}, line), ' ']));
        const picture = make('span', {}, canvases[i]!, caption);
        return makeButton(picture, () => this.#chosen(proposal), { 'aria-label': TEXT.proposal(i + 1, how) });
      }),
    );
    this.setStale(false);
    // Their size is that of the elements, once these are in the page.
    proposals.forEach(({ wireframe }, i) => drawThumbnail(canvases[i]!, upright(wireframe, up)));
  }

  /** Whether what stands below the pictures is of other settings than are chosen now. */
  setStale(isStale: boolean): void {
    this.element.classList.toggle('stale', isStale);
  }
}

/** As the scene shows it. */
function upright({ edges, positions }: Wireframe, up?: UpAxis): Wireframe {
  const space = new Space(Float64Array.from(positions), up);
  const place = { x: 0, y: 0, z: 0 };
  const turned = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    space.toScene(place, [positions[i]!, positions[i + 1]!, positions[i + 2]!]);
    turned.set([place.x, place.y, place.z], i);
  }
  return { edges, positions: turned };
}
