/** Nets with handles that have been moved. Every parameter of a recipe is named, and handles are numbers: an experiment must
 *  not change when a default does. */
import type { HandleSeed } from '../document/document';
import type { Edit } from './experiment';
import { mixedMesh } from './mixed_mesh';

type Pull = [vertex: number, x: number, y: number, z: number];

function anchor(vertex: number): HandleSeed {
  return { vertex, target: null, anchor: true };
}

function edit(recipe: string, anchors: number[], [vertex, x, y, z]: Pull): Edit {
  return { net: { recipe }, handles: [...anchors.map(anchor), { vertex, target: [x, y, z], anchor: false }] };
}

export const SMALL_VAULT = edit(
  'vault:vertices=1000,rise=0.3,aspect=1.4,waves=2,slope=30',
  [0, 26, 972, 998],
  [499, 1, 0.5, 1.97],
);
export const VAULT = edit(
  'vault:vertices=1500,rise=0.3,aspect=1.4,waves=2,slope=30',
  [0, 32, 1452, 1484],
  [742, 1.5, 1, 1.58],
);
export const LARGE_VAULT = edit(
  'vault:vertices=4000,rise=0.3,aspect=1.4,waves=2,slope=30',
  [0, 52, 3922, 3974],
  [1987, 1.5, 1, 1.51],
);
export const DOME = edit('dome:vertices=1500,reach=55', [0, 38, 1482, 1520], [760, 1.5, 1, 3.87]);
export const TUBE = edit('tube:vertices=1500,aspect=1.2,bend=30', [8, 17, 26], [1470, 3.29, 1, 7]);
export const TORUS = edit('torus:vertices=2000,thickness=0.35', [0, 19, 57], [1039, -1.89, 1.16, 2.18]);
export const JACK = edit('jack:vertices=4000,arm=1.2', [1980, 1981, 1911, 2051, 80], [3901, 2, 2, 8]);
export const ELEPHANT = edit('elephant:vertices=2000,legs=2.5,trunk=4.5', [44, 37, 126, 119], [518, 1.82, 3, 4.14]);

/** At rest, for a hand to drag. */
export const RESTING_TORUS: Edit = {
  net: TORUS.net,
  handles: TORUS.handles.map((handle) => ({ ...handle, target: null })),
};

/** A lattice of handles on a dome, where an earlier edit of it has left them. */
const LATTICE: Pull[] = [
  [0, -4.313, -4.313, 0],
  [11, -2.056, -4.213, 1.794],
  [22, 0.675, -4.252, 2.8],
  [33, 3.466, -4.535, 2.091],
  [44, 4.313, -4.313, 0],
  [495, -4.018, -2.225, 1.893],
  [506, -1.804, -2.105, 3.741],
  [517, 1.036, -1.813, 4.269],
  [528, 3.842, -2.202, 3.746],
  [539, 5.696, -2.386, 1.569],
  [990, -3.86, 0.492, 2.911],
  [1001, -1.346, 0.706, 4.276],
  [1012, 1.5, 1, 3.87],
  [1023, 4.187, 0.644, 4.253],
  [1034, 6.295, 0.349, 2.307],
  [1485, -4.232, 3.255, 2.118],
  [1496, -1.876, 3.495, 3.767],
  [1507, 0.986, 3.71, 4.269],
  [1518, 3.815, 3.468, 3.709],
  [1529, 5.881, 3.136, 1.724],
  [1980, -4.313, 4.313, 0],
  [1991, -2.184, 5.366, 1.621],
  [2002, 0.561, 5.875, 2.419],
  [2013, 3.371, 5.628, 1.845],
  [2024, 4.313, 4.313, 0],
];
const TOP = 1012;

export const MANY_HANDLES: Edit = {
  net: { recipe: 'dome:vertices=2000,reach=55' },
  handles: LATTICE.map(([vertex, x, y, z]) => ({ vertex, target: [x, y, z], anchor: vertex !== TOP })),
};

export const MIXED: Edit = {
  net: { obj: mixedMesh(), name: 'squares and triangles.obj' },
  handles: [...[0, 36, 1332, 1368].map(anchor), { vertex: 684, target: [0.14, -0.03, 3.09], anchor: false }],
};
