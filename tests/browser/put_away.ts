/** Brings a page back to how it was at first, which takes a tenth of loading it again, so that tests can share one. */
import { readFile } from 'node:fs/promises';
import type { Page } from 'playwright-core';
import { vi } from 'vitest';
import { dropFile } from './drop_file';

/** A page as it was at first. */
export interface First {
  /** What is open, with its history. */
  project: string;
  size: { width: number; height: number };
  state: PageState;
}

export interface PageState {
  unfolded: string[];
  /** Methods that are chosen to be compared: no part of a project. */
  compared: string[];
  /** Fields with what is chosen in them, folded away or not. */
  fields: string[];
  /** Whatever can be operated that is seen. */
  seen: string[];
}

/** Once all sections of the sidebar are there. */
export async function asAtFirst(page: Page): Promise<First> {
  await page.locator('summary', { hasText: /^For research$/ }).waitFor({ state: 'attached' });
  await page.evaluate(() => window.chebnet.settled());
  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  const project = await readFile(await (await download).path(), 'utf8');
  return { project, size: page.viewportSize()!, state: await page.evaluate(stateOfPage) };
}

/** Whether the page is as it was at first again: its net and history, every field, and nothing more to be seen. */
export async function putAway(page: Page, { project, size, state: first }: First): Promise<boolean> {
  await page.setViewportSize(size);
  await page.mouse.move(0, 0);
  await page.evaluate(close, first);
  await dropFile(page, 'first.chebnet.json', project);
  await page.getByText('The project is open.').waitFor();
  await page.evaluate(() => window.chebnet.settled());
  const isBack = async () => isAsAtFirst(await page.evaluate(stateOfPage), first);
  // Numbers are brought up to date some times a second.
  return vi.waitUntil(isBack, { timeout: 1000 }).catch(() => false);
}

/** Whether every field has what it had, and nothing more is to be seen. */
export function isAsAtFirst(now: PageState, first: PageState): boolean {
  const [fields, seen] = [new Set(now.fields), new Set(first.seen)];
  return first.fields.every((each) => fields.has(each)) && now.seen.every((each) => seen.has(each));
}

/** Runs in the page: ends dialogs, menus, messages and comparisons, and folds sections. */
export function close({ unfolded, compared }: PageState): void {
  for (const dialog of document.querySelectorAll('dialog')) dialog.requestClose();
  for (const menu of document.querySelectorAll<HTMLElement>(':popover-open')) menu.hidePopover();
  for (const line of document.querySelectorAll('.message')) line.remove();
  document.querySelector<HTMLElement>('.fold[aria-expanded=true]')?.click();
  document.querySelector<HTMLElement>('.comparison:not([hidden]) > header > button:last-child')?.click();
  for (const method of document.querySelectorAll<HTMLInputElement>('fieldset.methods input'))
    if (method.checked !== compared.includes(method.value)) method.click();
  for (const section of document.querySelectorAll('details'))
    section.open = unfolded.includes(section.querySelector('summary')?.textContent ?? '');
  (document.activeElement as HTMLElement).blur();
}

/** Runs in the page. */
export function stateOfPage(): PageState {
  const all = <E extends Element>(selector: string) => [...document.querySelectorAll<E>(selector)];
  const fields = all<HTMLInputElement | HTMLSelectElement>('input, select').map((field) =>
    [field.ariaLabel ?? field.labels?.[0]?.textContent, 'checked' in field && field.checked, field.value].join(' '),
  );
  const seen = all<HTMLButtonElement>('button, input, select, summary, a, dialog')
    .filter((each) => each.checkVisibility() && each.closest('.message') === null)
    .map((each) => [each.ariaLabel, each.textContent, each.disabled, each.ariaPressed].join(' '));
  const unfolded = all<HTMLElement>('details[open] > summary').map(({ textContent }) => textContent);
  const compared = all<HTMLInputElement>('fieldset.methods input:checked').map(({ value }) => value);
  return { unfolded, compared, fields, seen };
}
