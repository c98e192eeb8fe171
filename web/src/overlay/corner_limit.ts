/** The limit of corners that a document asks for. */
import { METHOD_AT_REST } from '../document/defaults';
import type { SolverSettings } from '../document/document';
import type { Tables } from '../net/tables';

export class CornerLimit {
  #usual = 0;

  setTables({ options }: Tables): void {
    this.#usual = options.find(({ name }) => name === 'shear_limit')?.value ?? 0;
  }

  /** In degrees; 0: the method heeds none. */
  of({ method, options }: SolverSettings): number {
    return method === METHOD_AT_REST ? Number(options['shear_limit'] ?? this.#usual) : 0;
  }
}
