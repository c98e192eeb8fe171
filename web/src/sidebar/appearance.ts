/** What the colours mean and whether faces are drawn. */
import type { ColourMap, Field, UpAxis, ViewState } from '../document/document';
import { words } from '../language/language';
import { makeSelect, makeSwitch, setValue } from '../elements/dom';
import type { PanelEvents } from '../panels';

export class Appearance {
  readonly content: HTMLElement[];
  private readonly field: HTMLSelectElement;
  private readonly map: HTMLSelectElement;
  private readonly mapRow: HTMLElement;
  private readonly faces: HTMLInputElement;
  private readonly up: HTMLSelectElement;

  constructor(events: PanelEvents) {
    const fields = [
      { value: 'deviation', text: words.appearance.deviation },
      { value: 'angle', text: words.appearance.angle },
      { value: 'longer', text: words.appearance.longer },
    ];
    const maps = [
      { value: 'paper', text: words.appearance.paper },
      { value: 'log', text: words.appearance.log },
    ];
    const axes = [
      { value: 'z', text: 'z' },
      { value: 'y', text: 'y' },
    ];
    const field = makeSelect(words.appearance.colourBy, fields, (value) => events.setView({ field: value as Field }));
    const map = makeSelect(words.appearance.colours, maps, (value) =>
      events.setView({ colourMap: value as ColourMap }),
    );
    const faces = makeSwitch(words.appearance.faces, (showFaces) => events.setView({ showFaces }));
    const up = makeSelect(words.appearance.upAxis, axes, (value) => events.setView({ upAxis: value as UpAxis }));
    [this.field, this.map, this.mapRow] = [field.select, map.select, map.row];
    [this.faces, this.up] = [faces.box, up.select];
    this.content = [field.row, map.row, faces.row, up.row];
  }

  show({ field, colourMap, showFaces, upAxis }: ViewState): void {
    setValue(this.field, field);
    setValue(this.map, colourMap);
    // The others have one map of their own.
    this.mapRow.hidden = field !== 'deviation';
    this.faces.checked = showFaces;
    setValue(this.up, upAxis ?? 'z');
  }
}
