/** A second net beside the user's, seen from the same place: for looking only. */
import type { HandleData, ViewState } from '../document/document';
import { LOOKING_ONLY } from '../view/view';
import type { View, ViewEvents } from '../view/view';
import type { FrameData, OpenedNet } from '../worker/protocol';

export class Beside {
  readonly #create: (events: ViewEvents) => View;
  readonly #cameraMoved: ViewEvents['cameraMoved'];
  #view: View | null = null;

  /** @param cameraMoved is told when a hand turns this view. */
  constructor(create: (events: ViewEvents) => View, cameraMoved: ViewEvents['cameraMoved']) {
    this.#create = create;
    this.#cameraMoved = cameraMoved;
  }

  show(net: OpenedNet, frame: FrameData, look: ViewState): void {
    if (this.#view === null) this.#view = this.#open(net, frame, look);
    this.#view.showFrame(frame);
    // Locked all: no hand takes hold of them here.
    const handles = frame.handles.map((handle): HandleData => ({ ...handle, anchor: true }));
    this.#view.showHandles(handles, { selection: [], mode: 'translate', selecting: false });
  }

  hide(): void {
    this.#view?.dispose();
    this.#view = null;
  }

  setAppearance(look: ViewState): void {
    this.#view?.setAppearance(look);
  }

  setCamera(camera: NonNullable<ViewState['camera']>): void {
    this.#view?.setCamera(camera);
  }

  #open(net: OpenedNet, frame: FrameData, look: ViewState): View {
    const view = this.#create({
      ...LOOKING_ONLY,
      // Not while it is being opened: it stands where the other does, which must still fit itself to half the room.
      cameraMoved: (camera) => this.#view && this.#cameraMoved(camera),
    });
    view.setAppearance(look);
    view.showNet(net, frame, look.camera);
    return view;
  }
}
