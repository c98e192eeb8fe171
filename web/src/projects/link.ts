/** The scene as a link, and back. Loaded when there is a link to make or to read. */
import type { App } from '../app/app';
import type { Scene } from '../document/document';
import { decodeScene, encodeScene } from '../document/share';
import type { Shared } from '../document/share';
import { experimentScene, experimentTitle, isExperimentLink } from '../experiments/links';
import { Failure } from '../failure';
import { addressForOthers } from '../language/choice';
import { panelWords } from '../language/panels';

/** The present scene as the hash of a link of at most so many characters. */
export function hashOf(app: App, largest?: number): Shared {
  const present = app.toShare();
  return present === null ? { hash: null } : encodeScene(present.document, present.net, present.threshold, largest);
}

/** The address of the present scene. Throws a Failure if the scene is too large for one. */
export function linkTo(app: App): string {
  const { hash } = hashOf(app);
  if (hash === null) throw new Failure('too_large', panelWords.link.tooLarge);
  return new URL(hash, addressForOthers()).href;
}

/** The scene of a hash. Throws a Failure. */
export async function sceneOf(hash: string): Promise<Scene> {
  return isExperimentLink(hash) ? experimentScene(hash) : decodeScene(hash);
}

/** What a hash opens, by its name; null: it has none. */
export function titleOf(hash: string): string | null {
  return isExperimentLink(hash) ? experimentTitle(hash) : null;
}
