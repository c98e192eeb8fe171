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
  of(settings: SolverSettings): number {
    return settings.method === METHOD_AT_REST ? this.asked(settings) : 0;
  }

  /** Whether or not the method heeds it. */
  asked({ options }: SolverSettings): number {
    return Number(options['shear_limit'] ?? this.#usual);
  }
}
