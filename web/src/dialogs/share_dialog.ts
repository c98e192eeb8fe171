/** The link that was just copied: to copy again, with or without the positions, as a QR code, or as code for a page. */
import { frameCode } from '../export/frame_code';
import { qrCode, type QrCode } from '../export/qr_code';
import { copyText } from '../files/clipboard';
import { messageOf } from '../failure';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import { make, makeButton, makeSvg, setText } from '../elements/dom';
import './dialog.css';
import './share_dialog.css';

export interface ShareLink {
  /** `solved`: without positions, for which whoever opens it solves; they come out the same. `near`: they do not. */
  kind: 'solved' | 'near' | 'exact';
  /** Of a `near` one: how far a vertex comes out from where it stands, at most, in edge lengths. */
  aside?: number;
  link: string;
  /** The same for a frame in another page. */
  embedded: string;
  /** What to tell the user about it, if anything. */
  advice: string;
  /** For a QR code: the link, without the positions if need be; null: it is too long. */
  code: { link: string; positions: boolean } | null;
}

export interface ShareParts {
  /** To choose from; the first is copied. Once `unwanted` is aborted nobody waits for more than there is at once. */
  links(unwanted: AbortSignal): Promise<ShareLink[]>;
  /** Copies a link, as the visitor has `asked` or by itself, and says how that went. */
  copyLink(link: ShareLink, asked: boolean): Promise<string>;
}

export class ShareDialog {
  readonly #dialog: HTMLDialogElement;
  readonly #said = make('p', { role: 'status' }, panelWords.share.making);
  readonly #choice = make('fieldset', { class: 'lengths', hidden: true }, make('legend', {}, panelWords.share.choice));
  readonly #code = make('figure', { class: 'qr' });
  readonly #snippet = make('textarea', {
    readonly: true,
    rows: 3,
    'aria-label': panelWords.share.embed,
    spellcheck: 'false',
  });
  readonly #copyLink: ShareParts['copyLink'];
  readonly #dontWait = makeButton(panelWords.share.dontWait, () => this.#unwanted.abort(), { autofocus: true });
  /** Until there is a link there is nothing to copy. */
  readonly #again = makeButton(panelWords.share.copy, () => this.#copy(true), { class: 'primary', disabled: true });
  readonly #embed = makeButton(panelWords.share.copyEmbed, () => this.#copySnippet(), { disabled: true });
  readonly #unwanted = new AbortController();
  #isClosed = false;
  #chosen: ShareLink | null = null;

  constructor(root: HTMLElement, { links, copyLink }: ShareParts) {
    this.#copyLink = copyLink;
    const heading = make('h2', { id: 'share-title' }, words.toolbar.link.label);
    this.#snippet.addEventListener('focus', () => this.#snippet.select());
    this.#dialog = make(
      'dialog',
      { class: 'file share', 'aria-labelledby': heading.id },
      heading,
      make(
        'div',
        { class: 'body' },
        this.#choice,
        this.#said,
        this.#code,
        make('div', { class: 'embed' }, make('h3', {}, panelWords.share.embed), this.#embed),
        this.#snippet,
      ),
      make(
        'div',
        { class: 'buttons' },
        this.#dontWait,
        this.#again,
        makeButton(panelWords.share.close, () => this.#dialog.close()),
      ),
    );
    // The page's shortcuts are off while the dialog is open.
    this.#dialog.addEventListener('keydown', (event) => event.stopPropagation());
    this.#dialog.addEventListener('close', () => {
      this.#isClosed = true;
      this.#unwanted.abort();
      this.#dialog.remove();
    });
    root.append(this.#dialog);
    this.#dialog.showModal();
    links(this.#unwanted.signal)
      .then((all) => this.#offer(all))
      .catch((error: unknown) => setText(this.#said, messageOf(error)));
  }

  #offer(links: ShareLink[]): void {
    // By now the clipboard may hold something else.
    if (this.#isClosed) return;
    const chosen = links[0]!;
    this.#choice.append(...links.map((link) => this.#option(link, link === chosen)));
    this.#choice.hidden = links.length < 2;
    this.#dontWait.hidden = true;
    for (const button of [this.#again, this.#embed]) button.disabled = false;
    this.#again.focus();
    this.#choose(chosen);
  }

  #option(link: ShareLink, isChosen: boolean): HTMLElement {
    const radio = make('input', { type: 'radio', name: 'share-link', checked: isChosen });
    radio.addEventListener('change', () => this.#choose(link));
    const { label, about } = panelWords.share[link.kind];
    const size = link.link.length.toLocaleString(words.locale);
    const aside = (link.aside ?? 0).toLocaleString(words.locale, { maximumSignificantDigits: 1 });
    return make('label', {}, radio, make('span', {}, label, make('small', {}, about(size, aside))));
  }

  #choose(link: ShareLink): void {
    this.#chosen = link;
    this.#snippet.value = frameCode(link.embedded);
    this.#showCode(link.code);
    this.#copy(false);
  }

  /** `asked`: by a button. */
  #copy(asked: boolean): void {
    if (this.#chosen) this.#tell(this.#copyLink(this.#chosen, asked));
  }

  #copySnippet(): void {
    const { embedCopied, clipboardClosed } = panelWords.share;
    this.#tell(copyText(this.#snippet.value).then((isCopied) => (isCopied ? embedCopied : clipboardClosed)));
  }

  /** What came of it, or why nothing did. */
  #tell(doing: Promise<string>): void {
    void doing.catch(messageOf).then((said) => setText(this.#said, said));
  }

  #showCode(code: ShareLink['code']): void {
    this.#code.replaceChildren(...(code ? [drawn(qrCode(code.link))] : []));
    if (!code?.positions)
      this.#code.append(make('figcaption', {}, code ? panelWords.share.qrWithoutShape : panelWords.share.qrTooLong));
  }
}

/** Dark on light in any theme: not every reader accepts inverted codes. */
function drawn({ size, path }: QrCode): SVGSVGElement {
  const paper = makeSvg('path', { d: `M0 0h${size}v${size}H0z`, class: 'paper' });
  const picture = {
    viewBox: `0 0 ${size} ${size}`,
    'shape-rendering': 'crispEdges',
    role: 'img',
    'aria-label': panelWords.share.qr,
  };
  return makeSvg('svg', picture, paper, makeSvg('path', { d: path }));
}
