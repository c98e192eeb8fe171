/** The link that was just copied: to copy again, as a QR code, or as code for a page. */
import { frameCode } from '../export/frame_code';
import type { QrCode } from '../export/qr_code';
import { copyText } from '../files/clipboard';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import { make, makeButton, makeSvg, setText } from '../elements/dom';
import './dialog.css';
import './share_dialog.css';

export interface ShareParts {
  /** For a QR code: the link in so many characters, without the positions if need be; null: it takes more. */
  linkWithin(characters: number): { link: string; positions: boolean } | null;
  /** The same for a frame in another page. */
  embedded: string;
  /** Copies the link and says how that went. */
  copyLink(): Promise<string>;
}

export class ShareDialog {
  readonly #dialog: HTMLDialogElement;
  readonly #said = make('p', { role: 'status' });
  readonly #code = make('figure', { class: 'qr' });

  constructor(root: HTMLElement, parts: ShareParts) {
    const { linkWithin, embedded, copyLink } = parts;
    const heading = make('h2', { id: 'share-title' }, words.toolbar.link.label);
    const copy = async (): Promise<void> => setText(this.#said, await copyLink());
    const snippet = make(
      'textarea',
      { readonly: true, rows: 3, 'aria-label': panelWords.share.embed, spellcheck: 'false' },
      frameCode(embedded),
    );
    snippet.addEventListener('focus', () => snippet.select());
    const copySnippet = async (): Promise<void> => {
      setText(
        this.#said,
        (await copyText(snippet.value)) ? panelWords.share.embedCopied : panelWords.share.clipboardClosed,
      );
    };
    this.#dialog = make(
      'dialog',
      { class: 'file share', 'aria-labelledby': heading.id },
      heading,
      make(
        'div',
        { class: 'body' },
        this.#said,
        this.#code,
        make(
          'div',
          { class: 'embed' },
          make('h3', {}, panelWords.share.embed),
          makeButton(panelWords.share.copyEmbed, copySnippet),
        ),
        snippet,
      ),
      make(
        'div',
        { class: 'buttons' },
        makeButton(panelWords.share.copy, copy, { class: 'primary', autofocus: true }),
        makeButton(panelWords.share.close, () => this.#dialog.close()),
      ),
    );
    // The page's shortcuts are off while the dialog is open.
    this.#dialog.addEventListener('keydown', (event) => event.stopPropagation());
    this.#dialog.addEventListener('close', () => this.#dialog.remove());
    root.append(this.#dialog);
    this.#dialog.showModal();
    void copy();
    void this.#showCode(linkWithin);
  }

  async #showCode(linkWithin: ShareParts['linkWithin']): Promise<void> {
    const { qrCode, QR_CAPACITY } = await import('../export/qr_code');
    const short = linkWithin(QR_CAPACITY);
    if (short) this.#code.append(drawn(qrCode(short.link)));
    if (!short?.positions)
      this.#code.append(make('figcaption', {}, short ? panelWords.share.qrWithoutShape : panelWords.share.qrTooLong));
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
