/** What stages of methods are called. */
import type { MethodInfo } from '../../../wasm/chebnet';
import { panelWords } from '../language/panels';
import type { Tables } from '../net/tables';

export class StageNames {
  #methods: readonly MethodInfo[] = [];

  setTables({ methods }: Pick<Tables, 'methods'>): void {
    this.#methods = methods;
  }

  /** @param stage by its number in a frame or a trace. */
  of(method: string, stage: number): string {
    const { start, named } = panelWords.stages;
    const name = this.#methods.find((each) => each.name === method)?.stages[stage - 1];
    return name === undefined ? start : named(name);
  }
}
