/** The editor inside of another page, at `?embed`, loaded on demand: the net alone, which leaves wheel and touch to that page
 *  until a click. */
import type { App } from '../app/app';
import { embedWords } from '../language/embed';
import { make, makeButton } from '../elements/dom';
import { hashOf } from '../projects/link';
import type { Scripting } from '../scripting';
import { Host } from './host';
import type { Answer, News } from './protocol';
import './embed.css';

/** @param view the element that holds the picture.
 *  @param opened resolves when the first net is open, or could not be. */
export function embed(view: HTMLElement, app: App, script: Scripting, opened: Promise<void>): void {
  view.append(makeShield(view), makeWayOut(app));
  // Without an origin there are no workers, and nothing can be solved; no_origin.js tells the host.
  if (parent !== window && origin !== 'null') listenToHost(script, opened);
}

/** Lies over the picture until it is clicked, and again after Escape or a click outside of the frame. */
function makeShield(view: HTMLElement): HTMLElement {
  const canvas = view.querySelector('canvas');
  const shield = makeButton(make('span', {}, embedWords.activate), () => setActive(true), { class: 'shield' });
  const setActive = (active: boolean): void => {
    canvas?.toggleAttribute('inert', !active);
    shield.hidden = active;
    document.documentElement.classList.toggle('active', active);
    if (active) canvas?.focus();
  };
  addEventListener('blur', () => setActive(false));
  addEventListener('keydown', ({ key, defaultPrevented }) => {
    if (key !== 'Escape' || defaultPrevented || shield.hidden === false) return;
    setActive(false);
    shield.focus();
  });
  setActive(false);
  return shield;
}

/** Leads to the editor as a page of its own, with the scene as it is at that moment. */
export function makeWayOut(app: App): HTMLElement {
  const link = make(
    'a',
    { class: 'way-out', href: location.pathname, target: '_blank', rel: 'noopener' },
    embedWords.open,
  );
  let hash: string | null = null;
  const update = (event: MouseEvent): void => {
    // That of a large net takes a while, and was made when the pointer of the click went down; a click by a key has none.
    const isPointerUp = event.type.endsWith('click') && event.detail > 0;
    if (!isPointerUp) hash = hashOf(app).hash;
    link.href = location.pathname + (hash ?? '');
    if (hash !== null || event.type === 'pointerdown') return;
    event.preventDefault(); // it would lead to another net
    app.say(embedWords.tooLarge);
  };
  // By whatever button or menu it is opened or copied; a drag takes the address of when the pointer went down.
  for (const way of ['pointerdown', 'click', 'auxclick', 'contextmenu'] as const) link.addEventListener(way, update);
  return link;
}

function listenToHost(script: Scripting, opened: Promise<void>): void {
  let origin = '*';
  const post = (message: Answer | News): void => parent.postMessage(message, origin);
  const host = new Host(script, post);
  addEventListener('message', (event) => {
    if (event.source !== parent) return;
    // A host without an origin, e.g. a file, can only be addressed by `*`.
    origin = event.origin === 'null' ? '*' : event.origin;
    void host.receive(event.data);
  });
  // Calls are taken before, too; but what is asked as soon as this is heard is to be told of a net.
  void opened.then(() => post({ chebnet: 1, event: 'ready' }));
}
