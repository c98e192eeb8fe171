/** The contract between the handle editor and panels and keys: commands, and the state of the selection. */
import type { HandleData, Symmetry, Vec3 } from '../document/document';
import type { DrawnSurface } from '../worker/protocol';
import type { Part } from './part';
import type { Selection } from './selection';
import type { Snapping } from './snapping';
import type { Surroundings } from './surroundings';
import type { Motion } from './transform';

/** What the gizmo at the selection does. */
export type GizmoMode = 'translate' | 'rotate' | 'scale';
export const GIZMO_MODES: readonly GizmoMode[] = ['translate', 'rotate', 'scale'];

/** A line of vertices through the leading handle: the boundary loop, or one of its net lines. */
export type LineName = 'boundary' | number;

/** Properties of a handle that can be changed, apart from its target. */
export type HandleTraits = { [K in 'name' | 'hidden' | 'weight' | 'slides' | 'anchor']?: HandleData[K] | undefined };

export interface Choice {
  selection: Selection;
  /** Several are being selected: clicks and outlines add to the selection. */
  selecting: boolean;
  mode: GizmoMode;
  /** Of the leading handle: whether it lies on the boundary, and how many net lines go through it. */
  onBoundary: boolean;
  lines: number;
  /** Without one all of the net is shown. */
  part?: Part | undefined;
  /** What drags snap to, if anything. */
  snapping?: Snapping | null;
}

export interface HandleCommands {
  select(selection: Selection): void;
  /** Starts selecting several, or ends it. */
  toggleSelecting(): void;
  setMode(mode: GizmoMode): void;
  /** Makes a vertex a handle and selects it, and `also` others with it. */
  add(vertex: number, also?: Selection): void;
  /** Gives a net that has no handles some to begin with; see proposal.ts. */
  propose(): void;
  /** The vertices of a line through the leading handle. */
  line(name: LineName): readonly number[];
  /** Makes all of them handles and selects them. `title`: what they are called, beside the leading handle. */
  takeLine(name: LineName, title: string): void;
  /** Does something with what is around the selection. */
  around(doing: (surroundings: Surroundings) => void): void;
  remove(vertices: Selection): void;
  change(vertices: Selection, traits: HandleTraits): void;
  place(vertex: number, target: Vec3): void;
  /** Of the selection. */
  transform(motion: Motion): void;
  setSymmetry(symmetry: Symmetry | undefined): void;
  /** How far the net moves with what is dragged, in edge lengths; undefined: everywhere. */
  setLocality(locality: number | undefined): void;
  /** Shades what such a locality would fix; undefined: no longer. */
  previewLocality(locality: number | undefined): void;
  /** How far from what is dragged other handles follow it, in edge lengths; undefined: none do. */
  setInfluence(influence: number | undefined): void;
  /** Shows what would follow the selection; undefined: no longer. */
  previewInfluence(influence: number | undefined): void;
  /** Whether a drag is kept to where the net can follow. */
  setKeepWithin(on: boolean): void;
  /** What drags snap to, from now on, also one under way; null: nothing. */
  setSnapping(snapping: Snapping | null): void;
  /** The surface beside the net; null: there is none. */
  guide(): Promise<DrawnSurface | null>;
  /** Whether a drag always shows how far it can go. */
  setShowReach(on: boolean): void;
}
