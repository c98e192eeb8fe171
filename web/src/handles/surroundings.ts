/** What is around the selection, along the net. Loaded when it is first wanted. */
import { panelWords } from '../language/panels';
import type { OpenedNet } from '../worker/protocol';
import { verticesAround } from './around';
import type { Selection } from './selection';

/** The part of the handle editor that it uses. */
export interface SurroundingsHost {
  net(): OpenedNet | null;
  selection(): Selection;
  /** Makes vertices handles and selects them, the last one leads. */
  take(vertices: readonly number[], name: string): void;
}

export class Surroundings {
  /** How far it is around, in edge lengths. */
  radius = 3;
  readonly #host: SurroundingsHost;

  constructor(host: SurroundingsHost) {
    this.#host = host;
  }

  /** The vertices around the leading handle, itself last; none if nothing is selected. */
  patch(): readonly number[] {
    const vertex = this.#host.selection().at(-1);
    const net = this.#host.net();
    if (vertex === undefined || net === null) return [];
    return verticesAround(net, [vertex], this.radius).reverse();
  }

  /** Makes them handles of one name. */
  takePatch(): void {
    const vertices = this.patch();
    if (vertices.length > 0) this.#host.take(vertices, panelWords.selection.patch);
  }
}
