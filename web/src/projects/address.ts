/** The address is that of the net that is open: it has the link by which that came, also after undo or redo, or none. */
import type { App } from '../app/app';
import type { NetSource } from '../document/document';
import type { Autosave } from './autosave';
import { sceneOf } from './link';

export class Address {
  readonly #app: App;
  readonly #autosave: Autosave;
  readonly #links = new WeakMap<NetSource, string>();
  #net: NetSource | undefined;

  constructor(app: App, autosave: Autosave) {
    this.#app = app;
    this.#autosave = autosave;
    app.on('changed', () => this.#follow());
  }

  /** Opens what is linked to in the address. */
  async open(hash: string): Promise<void> {
    await this.#app.openScene(await sceneOf(hash), { name: ['link'], key: null });
    this.note(hash);
  }

  /** What is open came by this link in the address, or has been made of it. */
  note(hash: string): void {
    const net = this.#app.opening?.document.net;
    // Where the browser keeps nothing, a reload is to lead back to it.
    if (net === undefined || this.#autosave.keepsNothing) return;
    this.#net = net;
    this.#links.set(net, hash);
  }

  #follow(): void {
    const before = this.#linkOf(this.#net);
    const net = this.#app.opening?.document.net;
    if (net === this.#net) return;
    this.#net = net;
    // Not where a link is in the address whose net is still on its way.
    if (location.hash === before)
      history.replaceState(null, '', this.#linkOf(net) || location.pathname + location.search);
  }

  #linkOf(net: NetSource | undefined): string {
    return (net && this.#links.get(net)) ?? '';
  }
}
