/** Where things stand on a desk and on a phone, in each engine. */
import { expect, test } from 'vitest';
import type { Visitor } from './visitor';
import { visitors } from './visitor';

const { arrive } = visitors();

/** Between a menu and the edge of the page. */
const GAP = 8;

const isMenuOpen = (visitor: Visitor) =>
  visitor.run(() => document.querySelector('#export-menu')!.matches(':popover-open'));

const placeOfMenu = (visitor: Visitor) =>
  visitor.run((gap) => {
    const menu = document.querySelector('#export-menu')!.getBoundingClientRect();
    const button = document.querySelector('[popovertarget=export-menu]')!.getBoundingClientRect();
    return {
      inside: menu.left >= gap && menu.top >= gap && menu.right <= innerWidth - gap && menu.bottom <= innerHeight - gap,
      beside:
        menu.left <= button.left &&
        button.left < menu.right &&
        (menu.top >= button.bottom || menu.bottom <= button.top),
      overflow: Math.max(0, document.documentElement.scrollWidth - innerWidth),
    };
  }, GAP);

test('on a desk and, the window made narrow, on a phone the menu stands beside its button and nothing is too wide', async () => {
  const visitor = await arrive();
  // Its lines come after the first picture.
  await expect.poll(() => visitor.run(() => document.querySelector('#export-menu .line') !== null)).toBe(true);
  for (const [name, width, height] of [
    ['desk', 1280, 800],
    ['phone', 390, 844],
  ] as const) {
    await visitor.driver.resize(width, height);
    await visitor.clickOn('Export');
    await expect
      .poll(() => placeOfMenu(visitor), { message: name })
      .toEqual({ inside: true, beside: true, overflow: 0 });
    await visitor.picture(`menu-${name}`);
    await visitor.press('Escape');
    await expect.poll(() => isMenuOpen(visitor)).toBe(false);
  }
});
