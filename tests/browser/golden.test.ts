/** What earlier pages kept in the browser, where they kept it, is there again; see tests/web/golden.test.ts. */
import { expect, test } from 'vitest';
import type { Project } from '../../web/src/document/project';
import { goldens, keptRecord } from '../web/golden_files';
import { visits } from './page';

const { open } = visits();

test.each(goldens('kept.json').filter(({ name }) => name.endsWith('/lesson')))('$name', async ({ text, expected }) => {
  const { entries, present } = expected as Project;
  const { page, script } = await open('licences.txt');
  await page.evaluate(keep, keptRecord(text));
  await page.goto(new URL('.', page.url()).href);
  await script.waitForNet();
  await expect
    .poll(() => page.locator('[role=status]').allInnerTexts())
    .toContainEqual(expect.stringMatching(/as you left it/));
  expect(await script.positions()).toEqual(entries[present]!.state.positions);
  await page.locator('summary', { hasText: 'History' }).click();
  await expect.poll(() => page.locator('.history').getByRole('button').count()).toBe(entries.length);
});

/** As those pages do it, of which a browser knows nothing else. */
async function keep(project: unknown): Promise<void> {
  const opening = indexedDB.open('chebnet');
  opening.onupgradeneeded = () => opening.result.createObjectStore('projects');
  await new Promise((resolve) => (opening.onsuccess = resolve));
  const writing = opening.result.transaction('projects', 'readwrite');
  writing.objectStore('projects').put(project, 'abc-123');
  writing.objectStore('projects').put(['abc-123'], 'index');
  await new Promise((resolve) => (writing.oncomplete = resolve));
  opening.result.close();
}
