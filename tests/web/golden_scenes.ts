/** The scenes and histories that golden files are made of. The types of the tables see to it that every field a document can
 *  have is in one of them: a new field is added here, and the golden files that are missing are made (golden.test.ts). */
import type { Axes as AxesToSlide, Chebnet, RestLengths } from '../../wasm/chebnet';
import { DEFAULT_VIEW, freshScene } from '../../web/src/document/defaults';
import type {
  HandleSeed,
  NetSource,
  Replay,
  Scene,
  Section,
  Symmetry,
  UpAxis,
  Vec3,
  ViewState,
} from '../../web/src/document/document';
import type { ChangeName } from '../../web/src/document/naming';
import type { ColourMap, FieldName } from '../../web/src/fields/fields';
import { uneven } from './nets';

/** With all its fields, those of its fields, and so on. */
type Whole<T> = T extends Float64Array ? T : { [Key in keyof T]-?: Whole<Exclude<T[Key], undefined>> };

export interface GoldenLink {
  scene: Scene;
  /** How far its last handle is moved after it is open. */
  drag?: Vec3;
  /** It is shared before it is solved. */
  unsolved?: true;
  /** It is shared without its positions, with this drag to be made again. */
  replay?: Replay;
  /** Characters of the longest link allowed. */
  largest?: number;
}

// --------------------------------------------------------------------------------------------------------------- links

const VAULT = 'vault:vertices=120,rise=0.3,aspect=1.4,waves=2,slope=30';
export const SMALL = { obj: uneven(3, 3), name: 'small.obj' };
const CAMERA = { position: [1.5, -20.25, 3] as Vec3, target: [0, 0.125, -1e-3] as Vec3, aspect: 1.25 };
const SCREW: Vec3 = [0.3, -0.2, -0.4];

/** Which is soft, and so does not slide. */
const HANDLE: Whole<Omit<HandleSeed, 'slides'>> = {
  vertex: 58,
  target: [-1e-17, 0.1 + 0.2, 2.2],
  anchor: false,
  name: 'Krone 顶',
  hidden: true,
  weight: 0.1 + 0.2,
};
const HANDLES: HandleSeed[] = [
  { vertex: 0, target: null, anchor: true },
  { vertex: 8, target: [2.9 + 0.1 / 3, -5, 0.9092948597320053], anchor: true, hidden: false },
  { vertex: 108, target: null, anchor: false, name: '' },
  HANDLE,
  { vertex: 116, target: [2.8, 4.9, 0.95], anchor: false },
];

/** A sheet whose feet slide, and whose middle is raised. */
function sliding(slides: AxesToSlide): GoldenLink {
  const feet = [5, 55, 65, 115].map((vertex): HandleSeed => ({ vertex, target: null, anchor: false, slides }));
  const handles = [...feet, { vertex: 60, target: null, anchor: false }];
  return { scene: { ...freshScene({ recipe: 'sheet:vertices=121' }), handles }, drag: [0.1, 0, 0.7] };
}
const SLIDES: Record<AxesToSlide, GoldenLink> = {
  x: sliding('x'),
  y: sliding('y'),
  z: sliding('z'),
  xy: sliding('xy'),
  xz: sliding('xz'),
  yz: sliding('yz'),
};

/** But for drags made again, which stand in place of positions, and of which nothing is left once a scene is open. */
const EVERYTHING: Whole<Omit<Scene, 'handles' | 'positions' | 'replay'>> = {
  net: { recipe: VAULT },
  numbering: 0x2fe61a83,
  symmetry: { axis: 'y', through: 'centre' },
  locality: 7.5,
  influence: 3.25,
  guide: { own: 'hypar' },
  method: 'projection',
  initialisation: 'arap:3',
  options: { threshold: 1e-8, max_iterations: 150, adaptive_p: false },
  view: {
    camera: CAMERA,
    behind: true,
    field: 'angle',
    colourMap: 'log',
    ends: {
      deviation: [1e-9, 2.5e-4],
      angle: [60, 120.5],
      shear: [10, 45],
      fold: [0, 30],
      curvature: [-90, 180.5],
      force: [-2, 1.5],
      height: [-1, 0.25],
    },
    parallel: true,
    rods: 0.12,
    section: { axis: 'z', at: 0.625 },
    guideHidden: true,
    showFaces: false,
    upAxis: 'y',
  },
  settled: true,
  ending: 'stalled',
  experiment: 'long-edges',
  compare: ['li2022', 'composite_majorization'],
};

/** Of a file, with a handle at rest and another pulled away. */
export function pulled(net: NetSource, vertex: number, target: Vec3, change: Partial<Scene> = {}): GoldenLink {
  const handles = [
    { vertex: 0, target: null, anchor: true },
    { vertex, target, anchor: false },
  ];
  return { scene: { ...freshScene(net), handles, ...change } };
}

function withSymmetry(symmetry: Symmetry): GoldenLink {
  return pulled(SMALL, 8, [2, 2, 0.5], { symmetry });
}

function seen(change: Partial<ViewState>): GoldenLink {
  return pulled(SMALL, 8, [2, 2, 0.5], { view: { ...DEFAULT_VIEW, ...change } });
}

function besideHypar(link: GoldenLink): GoldenLink {
  return { ...link, scene: { ...link.scene, guide: { own: 'hypar' } } };
}

/** One table for each type that is a choice, with a link for each of its values. */
const FIELDS: Record<FieldName, GoldenLink> = {
  deviation: seen({ field: 'deviation' }),
  angle: seen({ field: 'angle' }),
  shear: seen({ field: 'shear', ends: { shear: [10, 45] } }),
  fold: seen({ field: 'fold', ends: { fold: [0, 30] } }),
  curvature: seen({ field: 'curvature', ends: { curvature: [-90, 180.5] } }),
  force: seen({ field: 'force', ends: { force: [-2, 1.5] } }),
  height: besideHypar(seen({ field: 'height', ends: { height: [-1, 0.25] } })),
  longer: seen({ field: 'longer' }),
};
const COLOUR_MAPS: Record<ColourMap, GoldenLink> = {
  paper: seen({ colourMap: 'paper' }),
  log: seen({ colourMap: 'log' }),
};
const UP_AXES: Record<UpAxis, GoldenLink> = { y: seen({ upAxis: 'y' }), z: seen({ upAxis: 'z' }) };
const SECTIONS: Record<Section['axis'], GoldenLink> = {
  x: seen({ section: { axis: 'x', at: 0.5 } }),
  y: seen({ section: { axis: 'y', at: 0.5 } }),
  z: seen({ section: { axis: 'z', at: 0.5 } }),
};
const AXES: Record<Symmetry['axis'], GoldenLink> = {
  x: withSymmetry({ axis: 'x', through: 'centre' }),
  y: withSymmetry({ axis: 'y', through: 'centre' }),
  z: withSymmetry({ axis: 'z', through: 'centre' }),
};
const PLANES: Record<Symmetry['through'], GoldenLink> = {
  centre: withSymmetry({ axis: 'x', through: 'centre' }),
  origin: withSymmetry({ axis: 'x', through: 'origin' }),
};
const REST_LENGTHS: Record<RestLengths, GoldenLink> = {
  automatic: pulled({ obj: uneven(6, 5), name: 'cloth.obj', restLengths: 'automatic' }, 29, [5, 4, 1]),
  equal: pulled({ obj: uneven(6, 5), name: 'cloth 布.ply', restLengths: 'equal' }, 29, [5, 4, 1]),
  own: pulled({ obj: uneven(6, 5), name: 'cloth.off', restLengths: 'own' }, 29, [5, 4, 1]),
};

/** Two pieces, the vertices of which take turns: a sheet of squares and triangles, and a hexagon between two pentagons. */
const PIECES = [
  ...[
    [0, 0, 0],
    [9, 0, 1],
    [1, 0, 0],
    [10, 0, 1],
    [1, 1, 0],
    [10.5, 0.9, 1],
    [0, 1, 0],
    [10, 1.8, 1],
    [2, 0, 0],
    [9, 1.8, 1],
  ],
  ...[
    [2, 1, 0.25],
    [8.5, 0.9, 1],
    [1, 2, 0.125],
    [11.4, 1.2, 0.6],
    [0, 2, 0],
    [11.6, -0.2, 0.4],
    [2, 2, 0],
    [11, -0.7, 0.7],
  ],
  ...[
    [7.6, 1.2, 0.6],
    [7.4, -0.2, 0.4],
    [8, -0.7, 0.7],
  ],
].map((point) => `v ${point.join(' ')}`);
const FACES = [
  '1 3 5 7',
  '3 9 11',
  '3 11 5',
  '7 5 13 15',
  '5 11 17 13',
  '2 4 6 8 10 12',
  '4 18 16 14 6',
  '12 19 20 21 2',
];

export function goldenLinks(core: Chebnet): Record<string, GoldenLink> {
  const shapes = core.shapes().map(({ name, parameters }): [string, GoldenLink] => {
    const values = parameters.map((each) => `${each.name}=${each.name === 'vertices' ? 120 : each.value}`);
    return [`shape-${name}`, { scene: freshScene({ recipe: `${name}:${values.join()}` }), drag: SCREW }];
  });
  const bent = core.openRecipe('dome:vertices=120').restPositions.map((x, i) => x + 0.05 * Math.sin(i));
  return {
    // A field more is a file more.
    [`everything-in-${fieldsIn([EVERYTHING, HANDLE])}-fields`]: {
      scene: { ...EVERYTHING, handles: HANDLES, positions: null },
    },
    ...Object.fromEntries(shapes),
    ...named('field', FIELDS),
    ...named('colours', COLOUR_MAPS),
    ...named('up', UP_AXES),
    ...named('section', SECTIONS),
    ...named('symmetry', AXES),
    ...named('plane', PLANES),
    ...named('lengths', REST_LENGTHS),
    ...named('slides', SLIDES),
    'lengths-not-said': pulled({ obj: uneven(5, 5), name: 'cloth' }, 24, [4, 4, 0.5]),
    pieces: pulled(
      { obj: [...PIECES, ...FACES.map((face) => `f ${face}`), ''].join('\n'), name: 'pieces.obj' },
      16,
      [2, 2, 0.5],
    ),
    // Of more vertices than go as text.
    ...named('packed', {
      own: pulled({ obj: uneven(17, 13), name: 'large.obj', restLengths: 'own' }, 220, [16, 13, 1]),
      equal: pulled({ obj: uneven(17, 13), name: 'large 大.ply', restLengths: 'equal' }, 220, [16, 13, 1]),
    }),
    'no-handles': { scene: { ...freshScene({ recipe: 'tube:vertices=120' }), handles: [] } },
    'at-rest': { scene: freshScene({ recipe: 'torus:vertices=120' }) },
    'not-settled': { scene: { ...freshScene({ recipe: 'dome:vertices=120' }), positions: bent }, unsolved: true },
    'far-below-the-threshold': {
      scene: { ...freshScene({ recipe: 'steps:vertices=120' }), options: { threshold: 1e-10 } },
      drag: SCREW,
    },
    material: {
      scene: {
        ...freshScene({ recipe: 'sheet:vertices=120' }),
        method: 'equilibrium',
        options: { rod_curvature: 0.125, warp_stiffness: 4, weft_stiffness: 0.25, square_corners: true },
      },
      drag: SCREW,
    },
    'out-of-reach': { scene: freshScene({ recipe: 'jack:vertices=120' }), drag: [0, 0, 50] },
    'drag-made-again': { scene: freshScene({ recipe: 'wave:vertices=120' }), drag: [0, 0, -9], replay: [10, 3] },
    'without-its-positions': { scene: freshScene({ recipe: 'dome:vertices=120' }), drag: SCREW, largest: 400 },
  };
}

function fieldsIn(value: unknown): number {
  if (typeof value !== 'object' || value === null) return 0;
  const below = Object.values(value).reduce((sum: number, each) => sum + fieldsIn(each), 0);
  return Array.isArray(value) ? below : below + Object.keys(value).length;
}

function named(kind: string, links: Record<string, GoldenLink>): Record<string, GoldenLink> {
  return Object.fromEntries(Object.entries(links).map(([value, link]) => [`${kind}-${value}`, link]));
}

// ------------------------------------------------------------------------------------------------------------ histories

type Sentence = Extract<ChangeName, readonly unknown[]>[0];

/** Every change that a history can tell of. */
export const CHANGES: Record<Sentence, ChangeName[]> = {
  open: [
    ['open', { shape: 'vault' }],
    ['open', 'mesh 网.obj'],
  ],
  shape: [['shape', { shape: 'dome' }]],
  newNet: [['newNet']],
  link: [['link']],
  move: [
    ['move', { handle: '7' }],
    ['move', { handle: 'crown' }],
    ['move', { handles: '3' }],
  ],
  add: [['add', { handle: '7' }]],
  remove: [['remove', { handles: '2' }]],
  handles: [['handles']],
  propose: [['propose']],
  locality: [['locality', { number: '12.5' }]],
  noLocality: [['noLocality']],
  influence: [['influence', { number: '4' }]],
  noInfluence: [['noInfluence']],
  lock: [['lock', { handle: '7' }]],
  unlock: [['unlock', { handle: '7' }]],
  hide: [['hide', { handle: '7' }]],
  show: [['show', { handle: '7' }]],
  soften: [['soften', { handle: '7' }]],
  harden: [['harden', { handle: '7' }]],
  slide: [['slide', { handles: '4' }]],
  hold: [['hold', { handle: '7' }]],
  rename: [['rename', { handle: 'crown' }]],
  symmetry: [['symmetry']],
  noSymmetry: [['noSymmetry']],
  guide: [['guide', 'hypar']],
  noGuide: [['noGuide']],
  flip: [['flip']],
  relax: [['relax']],
  refine: [['refine']],
  coarsen: [['coarsen']],
  cut: [['cut']],
  trim: [['trim']],
  keepPieces: [['keepPieces']],
  deletePieces: [['deletePieces']],
  deleteRows: [['deleteRows']],
  deleteFaces: [['deleteFaces']],
  addRow: [['addRow']],
  insertRow: [['insertRow']],
  removeLine: [['removeLine']],
  join: [['join']],
  resize: [['resize']],
  equalize: [['equalize']],
  method: [['method', { method: 'li2022' }]],
  initialisation: [['initialisation', { method: 'arap' }]],
  option: [['option', { option: 'p_end' }, '50']],
  weight: [
    ['weight', '0'],
    ['weight', '4'],
  ],
  guideWeight: [['guideWeight', '× 4']],
  balance: [['balance', '1 : 4']],
  optionBack: [['optionBack', { option: 'p_end' }]],
  options: [['options']],
  solve: [['solve']],
  step: [['step']],
  reset: [['reset']],
  behaviour: [['behaviour', { behaviour: 'cloth' }]],
};
