/** The language a visitor chooses, kept from one load of the page to the next. */
import { afterEach, describe, expect, test, vi } from 'vitest';
import { chooseLanguage, preferredLanguage } from '../../web/src/language/choice';

describe('the language that a visitor chooses', () => {
  afterEach(() => vi.unstubAllGlobals());

  /** A page at an address whose browser stores what `storage` takes. */
  function visit(storage: Partial<Storage>): Location {
    const address = { href: 'https://host/#v2=x', search: '' };
    const replaceState = (_: null, __: string, url: URL): void =>
      void Object.assign(address, { href: url.href, search: url.search });
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
});
