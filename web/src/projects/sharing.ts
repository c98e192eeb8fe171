/** "Share": makes the links to the present scene and offers them. Loaded on demand. */
import type { App } from '../app/app';
import { ShareDialog, type ShareLink } from '../dialogs/share_dialog';
import { linkAdvice } from '../document/link_advice';
import { encodeScene } from '../document/share';
import { QR_CAPACITY } from '../export/qr_code';
import { copyText } from '../files/clipboard';
import { panelWords } from '../language/panels';
import type { WorkerLike } from '../worker/client';
import { solvedLink, type SolvedLink } from './solved_link';

/** A link whose positions make it so much longer is worth the trial whether it does without. */
const WORTH_A_TRIAL = 1_000;

/** Edge lengths. Who gets a link sees no more of the difference than a few pixels, and chat programs cut long links: it is the
 *  one that is copied. */
const NEAR = 0.1;

/** @param root parent of the dialog. @param spawn starts a solver, to try whether a link does without positions. */
export function share(app: App, root: HTMLElement, spawn: () => WorkerLike): void {
  const exact = exactLink(app);
  if (exact === null) return;
  new ShareDialog(root, {
    links: async (unwanted) =>
      exact.link.length < WORTH_A_TRIAL ? [exact] : linksWith(exact, await solvedLink(app, spawn, unwanted)),
    copyLink,
  });
}

/** @param solved without positions; null: it needs them. */
function linksWith(exact: ShareLink, solved: SolvedLink | null): ShareLink[] {
  if (solved === null) return [exact];
  const { hash, aside, isSame } = solved;
  const link = linkOf(hash);
  const code = { link, positions: isSame };
  const short = { link, embedded: linkOf(hash, '?embed'), advice: '', code };
  if (isSame) return [{ kind: 'solved', ...short }, exact];
  const near: ShareLink = { kind: 'near', aside, ...short };
  return aside <= NEAR ? [near, exact] : [exact, near];
}

/** With all positions, if they are not too many; null: even without them it is too long, which is said. */
function exactLink(app: App): ShareLink | null {
  const present = app.toShare();
  if (present === null) return null;
  const { document, net, threshold } = present;
  const shared = encodeScene(document, net, threshold);
  const advice = linkAdvice(shared) ?? '';
  if (shared.hash === null) {
    app.say(advice);
    return null;
  }
  const small = encodeScene(document, net, threshold, QR_CAPACITY - linkOf('').length);
  return {
    kind: 'exact',
    link: linkOf(shared.hash),
    embedded: linkOf(shared.hash, '?embed'),
    advice,
    code: small.hash === null ? null : { link: linkOf(small.hash), positions: small.positions },
  };
}

function linkOf(hash: string, query = ''): string {
  return new URL(`${location.pathname}${query}${hash}`, location.href).href;
}

/** Resolves with a message about the result. Unless it was asked for, a refusal leaves the address alone: a browser wants a click
 *  just before, and making the link may take longer. */
async function copyLink({ link, advice }: ShareLink, isAsked: boolean): Promise<string> {
  if (await copyText(link)) return panelWords.link.copied(advice);
  if (!isAsked) return panelWords.link.made(advice);
  // The rest of the address stays: it may say the visitor's language.
  history.replaceState(null, '', new URL(link).hash);
  return panelWords.link.inAddressBar(advice);
}
