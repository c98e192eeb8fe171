/** What the page opens with when nothing else is asked for. */
import type { ChebnetDocument, NetSource, Scene, SolverOptions, UpAxis, ViewState } from './document';

/** Every parameter is named: a link to it must not change when a default does. */
const DEFAULT_RECIPE = 'dome:vertices=2000,reach=55';
/** The method that brings a net to rest, as long as a hand can wait for it; beyond so many vertices, edges keep their
 *  lengths. */
export const METHOD_AT_REST = 'equilibrium';
const METHOD_OF_LARGE_NETS = 'projection';
/** k_most_vertices_at_rest of core/solve/method.h, as are both methods: a scene has its method before the core is loaded. */
export const MOST_VERTICES_AT_REST = 12_000;
export const DEFAULT_INITIALISATION = 'naive';

export const DEFAULT_VIEW: ViewState = { camera: null, field: 'deviation', colourMap: 'paper', showFaces: true };

/** What a view says of it. */
export function turned(upAxis: UpAxis | undefined): Pick<ViewState, 'upAxis'> {
  return upAxis === 'y' ? { upAxis } : {};
}

/** Settings for a net that is seen with this axis up: weight acts downwards. */
export function weighed({ y_up: _, ...options }: SolverOptions, upAxis: UpAxis | undefined): SolverOptions {
  return upAxis === 'y' && Number(options.gravity) > 0 ? { ...options, y_up: true } : options;
}

/** A state in which weight acts downwards as the net is seen: not at rest where it did not. */
export function hanging<State extends { options: SolverOptions; settled: boolean }>(
  state: State,
  upAxis: UpAxis | undefined,
): State {
  const options = weighed(state.options, upAxis);
  return options.y_up === state.options.y_up ? state : { ...state, options, settled: false };
}

/** What a net is solved with unless somebody chooses otherwise. */
export function usualMethod(net: NetSource): string {
  return vertexCount(net) > MOST_VERTICES_AT_REST ? METHOD_OF_LARGE_NETS : METHOD_AT_REST;
}

/** Of a recipe: the vertices asked for. */
function vertexCount(net: NetSource): number {
  if ('recipe' in net) return Number(/\bvertices=(\d+)/.exec(net.recipe)?.[1] ?? 0);
  return 'mesh' in net ? net.mesh.positions.length / 3 : (net.obj.match(/^v\s/gm) ?? []).length;
}

/** Settings for a net as it was made: how long edges are is of the net that they were changed of. */
export function asMade({ length_scale: _, ...options }: SolverOptions): SolverOptions {
  return options;
}

/** The document with a net that was made of its own, as that stood, and is new: nobody has solved it yet. */
export function remade(document: ChebnetDocument, net: NetSource, handles: Scene['handles']): Scene {
  return {
    ...document,
    net,
    numbering: undefined,
    handles,
    options: asMade(document.options),
    positions: null,
    settled: true,
    ending: undefined,
    experiment: undefined,
    compare: undefined,
  };
}

/** A net as it comes: at rest, with the handles its recipe suggests. */
export function freshScene(net: NetSource): Scene {
  return {
    net,
    handles: 'recipe' in net ? 'suggested' : [],
    method: usualMethod(net),
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
