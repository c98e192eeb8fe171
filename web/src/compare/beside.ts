/** Views of other nets beside the user's, with the same camera; nothing can be edited in them. */
import type { HandleData, Look, ViewState } from '../document/document';
import { LOOKING_ONLY } from '../view/view';
import type { View, ViewEvents } from '../view/view';
import type { FrameData, OpenedNet } from '../worker/protocol';

type Camera = NonNullable<ViewState['camera']>;

export class Beside {
  readonly #create: (events: ViewEvents, place: number) => View;
  readonly #cameraMoved: ViewEvents['cameraMoved'];
  #views: View[] = [];
  /** They are given another look, in which each may fit its net anew: that is no hand. */
  #areDressed = false;

  /** @param cameraMoved is told when a hand turns one of these views. */
  constructor(create: (events: ViewEvents, place: number) => View, cameraMoved: ViewEvents['cameraMoved']) {
    this.#create = create;
    this.#cameraMoved = cameraMoved;
  }

  /** One view for each frame. */
  show(net: OpenedNet, frames: readonly FrameData[], look: Look): void {
    for (const view of this.#views.splice(frames.length)) view.dispose();
    frames.forEach((frame, place) => {
      const view = (this.#views[place] ??= this.#open(place, net, frame, look));
      view.setFrame(frame);
      // All locked: they cannot be dragged here.
      const handles = frame.handles.map((handle): HandleData => ({ ...handle, anchor: true }));
      view.setHandles(handles, { selection: [], mode: 'translate', selecting: false });
    });
  }

  /** @param camera of the main view, which has that look already. */
  setAppearance(look: Look, camera: () => Camera): void {
    if (this.#views.length === 0) return;
    this.#areDressed = true;
    for (const view of this.#views) view.setAppearance(look);
    this.#areDressed = false;
    this.setCamera(camera());
  }

  setCamera(camera: Camera): void {
    for (const view of this.#views) view.setCamera(camera);
  }

  #open(place: number, net: OpenedNet, frame: FrameData, look: Look): View {
    const view = this.#create({ ...LOOKING_ONLY, cameraMoved: (camera) => this.#turned(view, camera) }, place);
    view.setAppearance(look);
    view.setNet(net, frame, look);
    return view;
  }

  #turned(turned: View, camera: Camera): void {
    // Not while it is being opened: it starts with the camera of the main view, which has yet to fit its smaller size.
    if (!this.#views.includes(turned) || this.#areDressed) return;
    for (const view of this.#views) if (view !== turned) view.setCamera(camera);
    this.#cameraMoved(camera);
  }
}
