/** The language a visitor chooses, kept from one load of the page to the next. */
import { afterEach, describe, expect, test, vi } from 'vitest';
import type { App } from '../../web/src/app/app';
import type { ShareParts } from '../../web/src/dialogs/share_dialog';
import { chooseLanguage, preferredLanguage } from '../../web/src/language/choice';
import { linkTo } from '../../web/src/projects/link';
import { share } from '../../web/src/projects/sharing';
import { documentAt } from './nets';

/** What the last dialog that shares was given. */
let sharing: ShareParts;
vi.mock('../../web/src/dialogs/share_dialog', () => ({
  ShareDialog: class {
    constructor(_: unknown, parts: ShareParts) {
      sharing = parts;
    }
  },
}));

describe('the language that a visitor chooses', () => {
  afterEach(() => vi.unstubAllGlobals());

  /** A page at an address whose browser stores what `storage` takes. */
  function visit(storage: Partial<Storage>): Location {
    const address = { href: 'https://host/#v2=x', search: '', pathname: '/' };
    const replaceState = (_: null, __: string, url: URL | string): void => {
      const { href, search } = new URL(url, address.href);
      Object.assign(address, { href, search });
    };
    vi.stubGlobal('location', address);
    vi.stubGlobal('history', { replaceState });
    vi.stubGlobal('localStorage', storage);
    return address as Location;
  }

  test('is stored, and leaves the address alone', () => {
    const stored = new Map<string, string>();
    const address = visit({
      getItem: (key) => stored.get(key) ?? null,
      setItem: (key, value) => stored.set(key, value),
    });
    chooseLanguage('zh');
    expect([preferredLanguage(), address.href]).toEqual(['zh', 'https://host/#v2=x']);
  });

  test('stands in the address where the browser stores nothing more, until it does', () => {
    let isFull = true;
    let stored: string | null = 'en';
    const setItem = (_: string, value: string): void => {
      if (isFull) throw new Error('full');
      stored = value;
    };
    const address = visit({ getItem: () => stored, setItem });
    chooseLanguage('zh');
    expect(preferredLanguage()).toBe('zh');
    isFull = false;
    chooseLanguage('en');
    expect([preferredLanguage(), address.search]).toEqual(['en', '']);
  });

  test('is kept in the address when a link is put there, but goes with no link', async () => {
    const address = visit({});
    const net = { restPositions: new Float64Array(3) };
    const app = { toShare: () => ({ document: documentAt(null), net, threshold: 0.01 }) } as unknown as App;
    chooseLanguage('zh');
    const made = linkTo(app);
    expect(made).toMatch(/^https:\/\/host\/#v2=/);
    share(app, {} as HTMLElement, () => expect.fail());
    const [exact] = await sharing.links(new AbortController().signal);
    expect(exact!.link).toBe(made);
    await sharing.copyLink(exact!, true);
    expect([preferredLanguage(), new URL(address.href).hash]).toEqual(['zh', new URL(made).hash]);
  });
});
