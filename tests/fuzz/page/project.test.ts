/** Projects: what is written comes back; anything else is refused with an error that says what is wrong. */
import fc from 'fast-check';
import { expect } from 'vitest';
import { Failure } from '../../../web/src/failure';
import { netAsText } from '../../../web/src/document/codec';
import { parseProject, projectText, readProject, writeProject } from '../../../web/src/document/project';
import type { Project } from '../../../web/src/document/project';
import { attack, attacks } from './attack';
import { changed, changes, checkFinite, document, guideFile, source, view } from './scenes';

const project: fc.Arbitrary<Project> = fc
  .record({
    documents: fc.array(fc.tuple(document, source, fc.option(guideFile)), { minLength: 1, maxLength: 4 }),
    name: fc.string({ maxLength: 50 }),
    present: fc.nat(),
    view,
  })
  .map(({ documents, name, present, view: seen }) => ({
    entries: documents.map(([{ view: _, ...state }, net, guide]) => ({
      name,
      state: { ...state, net, ...(guide ? { guide } : {}) },
    })),
    present: present % documents.length,
    view: seen,
  }));

function withText({ entries, ...rest }: Project): Project {
  return {
    ...rest,
    entries: entries.map(({ name, state }) => ({ name, state: { ...state, net: netAsText(state.net) } })),
  };
}

function checkParsed(text: string): void {
  try {
    checkFinite(parseProject(text));
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    expect(error.message).not.toBe('');
  }
}

const forged = fc
  .tuple(project, changes)
  .map(([given, list]) => JSON.stringify(changed(JSON.parse(projectText(given)), list)));

const projects = { folder: 'project', holds: (file: Uint8Array) => checkParsed(Buffer.from(file).toString()) };

attacks('projects', projects, {
  'a project comes back': attack(project, (given) => {
    expect(parseProject(projectText(given))).toEqual(withText(given));
    expect(readProject(writeProject(given, Infinity))).toEqual(given);
  }),
  'a forged project': attack(forged, checkParsed),
  'any JSON': attack(fc.json(), checkParsed),
  'any text': attack(fc.string(), checkParsed),
});
