/** What is being edited, as plain data: everything a link, a file or undo must bring back. */

export type Vec3 = [number, number, number];

export type NetSource = { recipe: string } | { obj: string; name: string };

export interface HandleData {
  vertex: number;
  target: Vec3;
  /** Anchors are drawn apart and are not dragged by accident; to the solver both are the same. */
  anchor: boolean;
}

/** Options of core/solve/options.h that differ from their defaults. */
export type SolverOptions = Record<string, number | boolean>;

export type Field = 'deviation' | 'angle';
export type ColourMap = 'paper' | 'log';

export interface ViewState {
  camera: { position: Vec3; target: Vec3 } | null;
  field: Field;
  colourMap: ColourMap;
  showFaces: boolean;
}

export interface ChebnetDocument {
  net: NetSource;
  handles: HandleData[];
  method: string;
  options: SolverOptions;
  view: ViewState;
  /** Positions to start from, 3 numbers a vertex; null: the rest positions. */
  positions: Float64Array | null;
}
