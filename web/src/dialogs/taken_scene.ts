/** The scene of a net that has been taken from a dialog or a script, as it is seen beside what is open. */
import { freshScene, turned } from '../document/defaults';
import type { ChebnetDocument, Scene } from '../document/document';
import type { Opening } from '../worker/opening';
import type { TakenNet } from './file_opener';
import { sideOf } from './side_of_handle';

/** The part of the app that opens it. */
interface Opens {
  readonly opening: Opening | null;
  openScene(scene: Scene): Promise<void>;
  frameAll(from: 'here'): void;
}

/** Of a file for a net on a surface: not the name of the surface itself, which a saved net would overwrite. */
export function netName(surface: string): string {
  return `${surface.replace(/\.[^.]*$/, '')}-net.obj`;
}

export async function openTaken(app: Opens, taken: TakenNet): Promise<void> {
  const scene = takenScene(taken, app.opening?.document);
  await app.openScene(scene);
  // The camera only says from which side.
  if (scene.view.camera) app.frameAll('here');
}

function takenScene({ net, handles, guide, upAxis = 'z' }: TakenNet, present: ChebnetDocument | undefined): Scene {
  const { camera: _, behind: __, upAxis: ___, ...view } = present?.view ?? freshScene(net).view;
  return {
    ...freshScene(net),
    handles,
    ...(guide && { guide }),
    // What no handle holds stays as it was shown; a guide would draw it.
    settled: handles.length === 0,
    view: { ...view, ...turned(upAxis), ...('mesh' in net ? sideOf(net.mesh, handles, upAxis) : { camera: null }) },
  };
}
