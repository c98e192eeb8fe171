/** What is around the selection, or between, along the net: taken as handles, or shown alone. Loaded when it is first wanted. */
import { panelWords } from '../language/panels';
import type { OpenedNet } from '../worker/protocol';
import { verticesAround } from './around';
import { type Part, partAround } from './part';
import type { Selection } from './selection';
import { wayThrough } from './way';

/** The part of the handle editor that it uses. */
export interface SurroundingsHost {
  net(): OpenedNet | null;
  selection(): Selection;
  /** Makes vertices handles of one name, and selects them. */
  take(vertices: readonly number[], name: string): void;
  /** What is shown alone; undefined: all of the net. */
  part(): Part | undefined;
  show(part: Part | undefined): void;
}

export class Surroundings {
  /** How far it is around, in edge lengths. */
  radius = 3;
  readonly #host: SurroundingsHost;

  constructor(host: SurroundingsHost) {
    this.#host = host;
  }

  /** The vertices around the leading handle, as far as they are shown; none if nothing is selected. */
  patch(): readonly number[] {
    const vertex = this.#host.selection().at(-1);
    const net = this.#host.net();
    const hidden = this.#host.part()?.hidden;
    if (vertex === undefined || net === null) return [];
    return verticesAround(net, [vertex], this.radius).filter((each) => !hidden?.[each]);
  }

  /** Makes them handles of one name. */
  takePatch(): void {
    const vertices = this.patch();
    if (vertices.length > 0) this.#host.take(vertices, panelWords.selection.patch);
  }

  /** The vertices on the shortest way through the selected handles, in their order, as far as they are shown. */
  way(): readonly number[] {
    const net = this.#host.net();
    const hidden = this.#host.part()?.hidden;
    return net === null ? [] : wayThrough(net, this.#host.selection()).filter((each) => !hidden?.[each]);
  }

  /** Makes them handles of one name. */
  takeWay(): void {
    const vertices = [...new Set(this.way())];
    if (vertices.length > 0) this.#host.take(vertices, panelWords.selection.way);
  }

  /** Shows only what is around all selected handles; or the whole net again. */
  isolate(): void {
    const net = this.#host.net();
    const selection = this.#host.selection();
    if (this.#host.part()) this.#host.show(undefined);
    else if (net && selection.length > 0) this.#host.show(partAround(net, selection, this.radius));
  }
}
