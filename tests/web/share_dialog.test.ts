/** The dialog of a link, with elements that do nothing but be opened and closed. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { ShareDialog, type ShareLink } from '../../web/src/dialogs/share_dialog';

class Element extends EventTarget {
  append(): void {}
  remove(): void {}
  replaceChildren(): void {}
  setAttribute(): void {}
  toggleAttribute(): void {}
  focus(): void {}
  showModal(): void {}
  close(): void {
    this.dispatchEvent(new Event('close'));
  }
}

const LINK: ShareLink = { kind: 'exact', link: 'page#v2=', embedded: 'page?embed#v2=', advice: '', code: null };
const copyLink = vi.fn(async () => 'copied');
let closed: AbortSignal;

/** A link is being made; what gives it to the dialog, and the dialog. */
function begin(): { give(): Promise<void>; dialog: Element } {
  let made = (_links: ShareLink[]): void => {};
  let dialog = new Element();
  const root = { append: (each: Element) => (dialog = each) };
  new ShareDialog(root as unknown as HTMLElement, {
    links: (signal) => {
      closed = signal;
      return new Promise((resolve) => (made = resolve));
    },
    copyLink,
  });
  const give = () => {
    made([LINK]);
    return new Promise<void>((done) => setTimeout(done));
  };
  return { give, dialog };
}

beforeEach(() => {
  copyLink.mockClear();
  const create = () => new Element();
  vi.stubGlobal('document', { createElement: create, createElementNS: create });
});
afterEach(() => vi.unstubAllGlobals());

test('the link is copied as soon as it is there', async () => {
  const { give } = begin();
  await give();
  expect(copyLink).toHaveBeenCalledWith(LINK, false);
  expect(closed.aborted).toBe(false);
});

test('what was closed before puts nothing into the clipboard, and needs no link any more', async () => {
  const { give, dialog } = begin();
  dialog.close();
  expect(closed.aborted).toBe(true);
  await give();
  expect(copyLink).not.toHaveBeenCalled();
});
