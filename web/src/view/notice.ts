/** A message in place of the view where nothing can be drawn. */
import { words } from '../language/language';
import { makeButton } from '../elements/dom';
import type { View } from './view';
import { Failure } from '../failure';

/** @param wayOut a button with a remedy. */
export function createNotice(container: HTMLElement): {
  show(text: string, wayOut?: { label: string; run(): void }): void;
  hide(): void;
  remove(): void;
} {
  const element = document.createElement('p');
  element.className = 'view-notice';
  element.setAttribute('role', 'alert');
  element.hidden = true;
  container.append(element);
  return {
    show(text, wayOut) {
      element.replaceChildren(text);
      if (wayOut) element.append(' ', makeButton(wayOut.label, wayOut.run, { class: 'plain link' }));
      element.hidden = false;
    },
    hide: () => (element.hidden = true),
    remove: () => element.remove(),
  };
}

/** What kind of WebGL there is. In software, multisampling would halve the frame rate; lines are antialiased by their shader. */
export function probeGraphics(): 'none' | 'software' | 'card' {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return 'none';
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name) ? 'software' : 'card';
}

/** A substitute where there is no WebGL: shows a message, and lets the rest of the page work. */
export function createBlankView(container: HTMLElement): View {
  const notice = createNotice(container);
  notice.show(words.view.noGraphics);
  const nowhere = { position: [0, -1, 0] as [number, number, number], target: [0, 0, 0] as [number, number, number] };
  const refuse = () => Promise.reject(new Failure('no_picture', words.view.noGraphics));
  return {
    behind: false,
    framed: true,
    setNet() {},
    setFrame() {},
    setHandles() {},
    setGuide() {},
    setSymmetry() {},
    setRegion() {},
    setReach() {},
    setReadout() {},
    setPreview() {},
    setMarks() {},
    takePen: refuse,
    setAppearance() {},
    setStepArrows() {},
    setShares() {},
    frameAll() {},
    camera: () => nowhere,
    heading: () => null,
    unframed: () => null,
    setCamera() {},
    picture: refuse,
    film: refuse,
    framesPerSecond: () => 0,
    screenPositions: (vertices) => vertices.map(() => ({ x: 0, y: 0 })),
    dispose: () => notice.remove(),
  };
}
