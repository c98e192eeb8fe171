/** What the colours mean and whether faces are drawn. */
import type { ColourMap, Field, UpAxis, ViewState } from '../document/document';
import { makeSelect, makeSwitch, setValue } from './dom';
import type { PanelEvents } from './panels';

export class Appearance {
  readonly content: HTMLElement[];
  private readonly field: HTMLSelectElement;
  private readonly map: HTMLSelectElement;
  private readonly mapRow: HTMLElement;
  private readonly faces: HTMLInputElement;
  private readonly up: HTMLSelectElement;

  constructor(events: PanelEvents) {
    const fields = [
      { value: 'deviation', text: 'Deviation of edges' },
      { value: 'angle', text: 'Corner angles' },
    ];
    const maps = [
      { value: 'paper', text: 'Blue and red' },
      { value: 'log', text: 'Logarithmic' },
    ];
    const axes = [
      { value: 'z', text: 'z' },
      { value: 'y', text: 'y' },
    ];
    const field = makeSelect('Colour by', fields, (value) => events.setView({ field: value as Field }));
    const map = makeSelect('Colours', maps, (value) => events.setView({ colourMap: value as ColourMap }));
    const faces = makeSwitch('Faces', (showFaces) => events.setView({ showFaces }));
    const up = makeSelect('Up axis', axes, (value) => events.setView({ upAxis: value as UpAxis }));
    [this.field, this.map, this.mapRow] = [field.select, map.select, map.row];
    [this.faces, this.up] = [faces.box, up.select];
    this.content = [field.row, map.row, faces.row, up.row];
  }

  show({ field, colourMap, showFaces, upAxis }: ViewState): void {
    setValue(this.field, field);
    setValue(this.map, colourMap);
    // Angles have one map of their own.
    this.mapRow.hidden = field === 'angle';
    this.faces.checked = showFaces;
    setValue(this.up, upAxis ?? 'z');
  }
}
