/** What the page opens with when nothing else is asked for. */
import type { NetSource, Scene, ViewState } from './document';

/** Every parameter is named: a link to it must not change when a default does. */
const DEFAULT_RECIPE = 'dome:vertices=2000,reach=55';
const DEFAULT_METHOD = 'equilibrium';
export const DEFAULT_INITIALISATION = 'naive';

export const DEFAULT_VIEW: ViewState = { camera: null, field: 'deviation', colourMap: 'paper', showFaces: true };

/** A net as it comes: at rest, with the handles its recipe suggests. */
export function freshScene(net: NetSource): Scene {
  return {
    net,
    handles: 'recipe' in net ? 'suggested' : [],
    method: DEFAULT_METHOD,
    initialisation: DEFAULT_INITIALISATION,
    options: {},
    view: DEFAULT_VIEW,
    positions: null,
    settled: false,
  };
}

export function defaultScene(): Scene {
  return freshScene({ recipe: DEFAULT_RECIPE });
}
