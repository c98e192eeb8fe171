/** Draws the pictures into the gallery, which come after the first net. */
import { PICTURES, VIEW_BOX } from 'virtual:gallery_pictures';
import { makeSvg } from '../elements/dom';
import { LAYERS } from '../elements/thumbnail';
import type { Tables } from '../net/tables';
import type { Panel } from '../panels';

export class GalleryPictures implements Panel {
  /** @param element the section of shapes. */
  constructor(readonly element: HTMLElement) {}

  setTables({ shapes }: Tables): void {
    for (const { name } of shapes) {
      const picture = this.element.querySelector(`[data-shape=${name}] .picture`);
      picture?.setAttribute('viewBox', VIEW_BOX);
      picture?.replaceChildren(...LAYERS.map((opacity, layer) => makeLines(PICTURES[name]?.[layer] ?? '', opacity)));
    }
  }
}

function makeLines(path: string, opacity: number): SVGPathElement {
  return makeSvg('path', { d: path, opacity: String(opacity) });
}
