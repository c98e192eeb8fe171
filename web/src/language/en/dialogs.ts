/** The dialogs that lead to another net, from a file, by equalising or on a surface. */
import type { Defect, Finding } from '../../../../wasm/chebnet';
import { readable } from './readable';

/** By the codes of failures. */
const WAYS_OUT: Record<string, string> = {
  no_faces: 'Points and lines alone make no net: save it as a mesh where it was made.',
};

export const dialogs = {
  projects: {
    title: 'My projects',
    hint: 'Those with a name stay until you delete them; of the others, the newest six. One that is open can be deleted once another one is open instead.',
    empty: 'Nothing is kept yet: whatever you change is kept here by itself.',
    notKept: 'The net that is open is not kept yet.',
    keep: 'Keep it',
    isOpen: 'open now',
    whileOpen: 'It is open: it can be deleted once another one is open instead.',
    isElsewhere: 'open in another tab',
    name: (project: string) => `Name of ${project}`,
    open: 'Open',
    openOne: (project: string) => `Open ${project}`,
    copy: 'Duplicate',
    copyOne: (project: string) => `Duplicate ${project}`,
    copyOf: (project: string) => `Copy of ${project}`,
    delete: 'Delete',
    deleteOne: (project: string) => `Delete ${project}`,
    deleted: (project: string) => `“${project}” is deleted.`,
    back: 'Undo',
    refused: 'The browser refused: its storage is full, or closed to this page.',
    close: 'Close',
  },
  defect: (defect: Defect) => readable(defect),
  /** In full. */
  finding: ({ sentence }: Finding) => sentence,
  file: {
    up: 'Which way is up?',
    isUp: (axis: string) => `${axis} is up`,
    steps: {
      loading: 'Loading the file',
      reading: 'Reading the mesh',
      checking: 'Looking for defects',
      measuring: 'Measuring the edges',
    },
    cancel: 'Cancel',
    facts: {
      vertices: 'Vertices',
      edges: 'Edges',
      faces: 'Faces',
      pieces: 'Pieces',
      boundaryLoops: 'Boundary loops',
      singularVertices: 'Singular vertices',
      shortest: 'Shortest edge',
      mean: 'Mean length',
      longest: 'Longest edge',
      deviation: 'Largest deviation from the mean',
      triangles: 'Triangles',
      genus: 'Handles (genus)',
      area: 'Area',
      curvature: 'Total curvature, + and −',
      noise: 'Noise or fine bumps: curvature that cancels',
      bothSigns: (positive: string, negative: string) => `${positive}, ${negative}`,
    },
    polygons: (arity: number, number: number, count: string) => `${count} ${polygon(arity)}${number === 1 ? '' : 's'}`,
    faces: (count: string, kinds: string[]) => `${count}: ${kinds.join(', ')}`,
    singular: (valence: string, count: string) => `${count} of valence ${valence}`,
    list: (items: string[]) => items.join(', '),
    none: 'none',
    below: (percent: string) => `below ${percent}`,
    defects: 'The mesh has defects',
    defectsHint: 'Repair would change this; the numbers above are those of the repaired mesh.',
    defect: (name: string, count: string) => `${name}: ${count}`,
    refused: (reason: string) => `As it is it cannot be opened: ${reason}.`,
    open: 'Open',
    repair: 'Repair and open',
    asItIs: 'Open as it is',
    lengths: (deviation: string) => `Edge lengths differ by up to ${deviation} from the mean`,
    own: { text: 'Keep each edge’s own length', hint: 'The shape stays as it is.' },
    equal: {
      text: (mean: string) => `One length, the mean (${mean})`,
      hint: 'The shape changes until all edges have it, as far as they can.',
    },
    tooLarge: (name: string, megabytes: number, largest: number) =>
      `${name} has ${megabytes} MB; nets are opened up to ${largest} MB.`,
    notStarted: 'The file reader could not be started.',
    /** In place of what the file reader says with this code. */
    unread: (_code: string): string | undefined => undefined,
    /** What the core says is wrong with a file, in the language of the page. */
    reason: (said: string) => said,
    /** What helps against a failure with this code, in a sentence; empty: nothing is known. */
    wayOut: (code: string) => WAYS_OUT[code] ?? '',
    kind: 'What is it?',
    net: { text: 'A net', hint: 'It is opened and edited as it is.' },
    surface: { text: 'A surface to make a net on', notOne: (reason: string) => `It cannot be one: ${reason}.` },
    drape: 'Make a net on it…',
    repairAndDrape: 'Repair and make a net on it…',
    drapeAsItIs: 'Make a net on it as it is…',
  },
  drape: {
    title: 'A net on a surface',
    opening: 'Measuring the surface…',
    making: 'Making the net…',
    outdated: 'Of other settings than these: make the net again to open it.',
    proposals: 'Good beginnings, the best first',
    proposal: (number: number, how: readonly string[]) => `Beginning ${number}: ${how.join(' ')}`,
    /** What comes of it, in lines below its picture. */
    proposed: (covered: string, sheared: string, distance: string) => [
      `${covered} covered`,
      `${sheared} sheared`,
      `${distance} edges off`,
    ],
    picture: 'The surface and the net on it; arrow keys move the seed, or the singular vertex that is chosen',
    /** While a cut or a curve is drawn. */
    pointing: 'Press the surface to set the points of the line, one after the other.',
    howTo: 'Drag the sphere to begin the net elsewhere, the ring beside it to turn the net.',
    surface: 'Surface',
    fromFile: 'A file of yours…',
    kind: 'Net',
    kinds: { piece: 'One piece', whole: 'The whole surface' },
    make: 'Make the net',
    noNetYet:
      'No net yet. “Make the net” covers all of the surface, which takes seconds; then you see how it lies, and can open it.',
    stop: 'Stop',
    phases: {
      border: 'Trying ways to meet borders and sharp edges…',
      triangles: 'Making even triangles…',
      singular: 'How few singular vertices it takes…',
      field: 'Finding directions…',
      grid: 'Fitting a grid…',
      fit: 'Bringing all edges to one length…',
    },
    singular: 'Singular vertices, of so many edges',
    singularOf: (total: string, byValence: string) => `${total}: ${byValence}`,
    cells: 'Cells',
    length: 'Edge length',
    tooShort: 'A finer net could not follow the hand.',
    direction: 'Direction',
    angle: 'Angle',
    arms: {
      title: 'Through the seed',
      ways: {
        geodesic: 'lines run straight on',
        least_shear: 'lines bend to shear least',
        curve: 'one follows a curve',
      },
      curve: 'The curve',
      draw: 'Draw the curve',
      end: 'End the curve',
      undo: 'Undo the point',
      howTo:
        'Pick points of the curve on the surface; then end it. By keys: arrows move the seed, Space sets a point there, Enter ends the curve, Backspace takes a point back, Esc gives it up.',
      noCurve: 'No curve is drawn yet: lines run straight on.',
      along: 'The curve gives the direction, and the seed slides along it.',
      noBetter: 'Bent lines would not make a better net here: they run straight on.',
    },
    limit: 'Sharpest',
    reach: 'Cells each way',
    toBorder: 'to the border',
    howMany: 'Singular vertices',
    howManyOf: { usual: 'where it curves', fewest: 'as few as it takes' },
    smoothing: 'Bumps',
    smoothings: (smoothing: number) =>
      smoothing === 0 ? 'all count' : smoothing === 1 ? 'small ones smoothed' : `smoothed ${smoothing} times as far`,
    border: 'At the border',
    locked: 'Where it locks',
    leaves: (height: number) =>
      height === 0 ? 'a gap stays' : `up to ${height === 1 ? 'an edge' : `${height} edges`} off`,
    borders: { beyond: 'whole cells', cut: 'rods cut at it', inside: 'no cell over it' },
    lines: {
      fitting: 'what fits best',
      always: 'a net line',
      outer: 'a net line, steps around holes',
      across: 'net lines at 45° to it',
      never: 'steps, as cells fall',
    },
    crease: 'Sharp edges',
    creases: (degrees: number | null) =>
      degrees === null ? 'as fits best' : degrees === 0 ? 'not followed' : `followed over ${degrees}°`,
    showShear: 'Colours by shear, red at 60°',
    prospects: {
      one_piece: (_covered: string) => 'One uncut piece will cover it.',
      tight: (_covered: string) => 'One uncut piece may cover it, with a slit or sharp corners at some places.',
      a_seam: (_covered: string) =>
        'One piece meets itself, as round a closed body, a hole or a handle: expect a seam. The whole surface can do without.',
      too_curved: (covered: string) =>
        `More curvature than one net can take: coarse ones that were tried covered up to ${covered}. Expect gaps, or cover the whole with singular vertices.`,
      ring: (covered: string) =>
        `One piece leaves gaps on the way round: coarse ones that were tried covered up to ${covered}. The whole surface can do without.`,
    },
    numbers: 'The surface in numbers',
    coversLess: 'This one covers less: drag the seed, turn it, take a proposal, or choose “The whole surface”.',
    crumpled: (folds: string, instead: string) => `Sharp folds at ${folds} edges (over 60°): ${instead}`,
    leftOff: (limbs: number) =>
      limbs === 1
        ? 'A limb too thin for cells of this size is left off: more cells keep it.'
        : `${limbs} limbs too thin for cells of this size are left off: more cells keep them.`,
    sharp: (cells: string) => `No net was found whose corners all keep the limit. Cells with a sharper one: ${cells}.`,
    leavesBare: (part: string) =>
      `${part} of the surface is farther from the net than half an edge. Where it is rough, fewer cells cover more; where it is finely shaped, more.`,
    againstFolds: {
      border: '“what fits best” at the border often lies smoother.',
      edges: '“as fits best” for sharp edges often lies smoother.',
      cells: 'more cells often lie smoother.',
    },
    pieces: {
      piece: (pieces: number) => `It has ${pieces} pieces: a net lies on that of the seed, the others stay bare.`,
      whole: (pieces: number) => `It has ${pieces} pieces: each gets a net.`,
    },
    cuts: {
      title: 'Cuts',
      draw: 'Draw a cut',
      end: 'End the cut',
      toBorder: 'Cut to the border',
      between: 'Cut between borders',
      undo: 'Undo',
      clear: 'Remove cuts',
      propose: 'Propose cuts',
      howTo:
        'Pick points of the cut on the surface. By keys: arrows move the seed, Space sets a point there, Enter ends the cut, Backspace takes a point back, Esc gives it up.',
      proposing: 'Trying cuts, which takes some seconds…',
      helped: (before: string, after: string) => `With these cuts ${after} is covered, without them ${before}.`,
      noneHelps: 'Of the cuts that were tried none lets the net cover more.',
      pieces: 'Pieces',
      piecesOf: (pieces: number, bare: number) =>
        bare > 0 ? `${pieces}, and ${bare} too small for a net` : String(pieces),
    },
    markedCreases: {
      title: 'Lines to follow',
      draw: 'Draw a line',
      end: 'End the line',
      close: 'Close the line',
      undo: 'Undo',
      clear: 'Remove lines',
      howTo:
        'Pick points of the line on the surface; then end it, or close it to a ring. By keys: Space sets a point, arrows move it, Enter ends the line, Backspace takes a point back, Esc gives it up.',
      next: 'Net lines are to run along it. It holds for the next net.',
      kept: (missed: number, edges: string) =>
        missed === 0
          ? 'Net lines run along what is drawn.'
          : `Not followed: ${missed}. On average along a line, net lines are up to ${edges} edges off.`,
    },
    singularWishes: {
      title: 'Singular vertices',
      list: 'Chosen',
      noneYet: 'none yet',
      noneChosen: 'none',
      dot: (number: number, edges: number, isPinned: boolean) =>
        `${number}: ${edges} edges${isPinned ? ', pinned' : ''}`,
      disc: (number: number) => `Region ${number} without any`,
      add: 'Pin another',
      forbid: 'Keep a region free',
      remove: 'Remove',
      undo: 'Undo',
      valence: 'Edges',
      edges: (edges: number) => String(edges),
      radius: 'Radius of a region',
      edgeLengths: (number: number) => `${number} edges`,
      only: 'These and no others',
      howTo:
        'Drag a numbered dot to where its singular vertex is to be; arrow keys move the one that is chosen. It holds for the next net.',
      click:
        'Pick where on the surface. By keys: Space sets it in the middle of the picture, arrows move it, Esc ends it.',
      added: 'Pinned there: it takes its turn from the others. It holds for the next net.',
      moved: 'Pinned there. It holds for the next net.',
      forbidden: 'No singular vertex is to stand in this region. It holds for the next net.',
      removed: 'None is to stand there any more: its turn goes to the others. It holds for the next net.',
      released: 'No longer pinned: the next net has it where it fits.',
      taken: 'It is gone from the list.',
      kept: (vertices: number, intruders: number, others: number) =>
        [
          vertices > 0 ? `Pinned, but not there: ${vertices}.` : '',
          intruders > 0 ? `In regions to be kept free: ${intruders}.` : '',
          others > 0 ? `Besides these: ${others}.` : '',
        ]
          .filter((each) => each !== '')
          .join(' ') || 'Drag a numbered dot, and make the net again.',
      needsNone: 'This net has no singular vertices.',
      missing: (count: number, edges: number) =>
        `These alone do not close: ${count} more with ${edges} edges ${count === 1 ? 'is' : 'are'} missing.`,
    },
    coverage: 'Covered',
    toHalfAnEdge: (part: string) => `${part}, to half an edge`,
    openBorder: 'Open inside, slits on both sides',
    meanDistance: 'Distance, mean',
    largestDistance: 'Distance, largest',
    lengths: (number: string) => `${number} edges`,
    distance: (inLengths: string, inUnits: string) => `${inLengths} edges, ${inUnits} units`,
    smallestAngle: 'Sharpest corner',
    sheared: 'Cells sheared over 15°',
    muchSheared: 'Cells sheared over 30°',
    folds: 'Folds over 60°',
    foldsOf: (folds: string, own: string) => `${folds}, away from sharp edges ${own}`,
    gaps: 'Gaps',
    refused: 'Refused: too sharp, met itself',
    refusals: (locked: string, met: string) => `${locked}, ${met} places`,
    time: 'Milliseconds',
    /** Of what is done, by its name. */
    times: {
      lay: 'laying',
      border: 'trying ways',
      triangles: 'triangles',
      singular: 'how few',
      field: 'directions',
      grid: 'grid',
      fit: 'fitting',
      open: 'opening',
      measure: 'measuring',
    },
    timeOf: (total: string, phases: readonly string[]) => `${total}: ${phases.join(', ')}`,
    none: 'none',
    /** For scripts that ask how the net lies. */
    noGuide: 'There is no surface beside the net.',
    unknownOption: (name: string, known: readonly string[]) =>
      `unknown option "${name}"; known are ${known.join(', ')}`,
    size: 'Cells, vertices',
    cellsAndVertices: (cells: string, vertices: string) => `${cells}, ${vertices}`,
    rods: 'Rods, their length',
    rodsOf: (rods: string, length: string) => `${rods}, ${length}`,
    cutEnds: 'Ends cut at the border',
    deviation: 'Largest dL',
    take: 'Open this net',
    cancel: 'Cancel',
  },
  change: {
    title: 'The net is being changed',
    starting: 'New faces',
    progress: (iterations: string) => `Finding a net whose edges have their length: iteration ${iterations}`,
    stop: 'Stop',
    notExact:
      'No net whose edges have one length was found near this shape. Nothing was changed; pull the net flatter there first, or choose another line.',
    vertices: (count: string) => `The net has ${count} vertices now.`,
    lengths: (length: string) => `The edges are ${length} long now.`,
    pieces: (count: number) => `It has ${count} pieces.`,
    goneIfCoarser: (pieces: number) =>
      pieces === 1
        ? 'One piece was too narrow to be coarser, and is gone.'
        : `${pieces} pieces were too narrow to be coarser, and are gone.`,
    sharp: 'Some corners are sharper than the limit: no such net within it was found.',
    lost: (handles: number) =>
      handles === 1
        ? 'One handle is gone: its vertex is no more.'
        : `${handles} handles are gone: their vertices are no more.`,
    /** The usual method is another one beyond so many vertices. */
    tooManyToRest: (limit: string) =>
      `Beyond ${limit} vertices, coming to rest takes longer than a hand can wait: the net keeps its lengths alone now. “Behaviour” has the choice.`,
    restsAgain: (limit: string) => `With no more than ${limit} vertices, it comes to rest again.`,
  },
  equalize: {
    choice: 'Equalise: the nearest net with edges of equal length',
    choiceHint: 'You see before and after, and how far vertices move, before it is opened.',
    open: 'Equalise…',
    repairAndOpen: 'Repair and equalise…',
    openAsItIs: 'Equalise as it is…',
    title: (name: string) => `Equalise ${name}`,
    introduction:
      'All edges get one length. The net stays as near to the surface of the original as it can, and its faces and vertices stay the same.',
    length: 'Length of every edge',
    mean: (length: string) => `The mean of the original, ${length}`,
    fitting: 'The best fit',
    fittingKnown: (length: string) => `The best fit, about ${length}`,
    fittingHint:
      'The net keeps the size of the original. At the mean length, a mesh that was split from triangles must crumple, and that shrinks it.',
    given: 'Another length',
    hold: (handles: number) =>
      handles === 1 ? 'Hold the handle where it is' : `Hold the ${handles} handles where they are`,
    start: 'Equalise',
    stop: 'Stop',
    take: 'Open the equalised net',
    cancel: 'Cancel',
    between: 'Between the original and the equalised net',
    original: 'Original',
    equalised: 'Equalised',
    attempt: 'Best attempt',
    share: (percent: number, end: string) => (percent === 100 ? end : `${percent} % ${end}`),
    shown: (deviation: string) => `Largest dL in the picture: ${deviation}`,
    starting: 'Starting',
    progress: (iterations: string, deviation: string) =>
      `Iteration ${iterations}, largest dL ${deviation}; done below 1e-9`,
    converged: (length: string) => `Every edge has the length ${length}.`,
    stalled: 'There may be no such net near this mesh: the solver got stuck before the edges were equal.',
    tooMany: (iterations: string) =>
      `There may be no such net near this mesh: after ${iterations} iterations the edges were still not equal.`,
    overflow: 'The numbers grew beyond what a computer can hold.',
    worstEdge: (a: number, b: number, is: string, wanted: string) =>
      `The worst edge, from vertex ${a} to ${b}, is ${is} long instead of ${wanted}.`,
    unchanged: 'Nothing was changed.',
    unreachable: (a: number, b: number, distance: string, reach: string) =>
      `There is no such net: handles ${a} and ${b} are ${distance} apart, and with this length the net between them reaches only ${reach}. Take a longer length, or do not hold the handles.`,
    fault: (sentence: string) => `It cannot be equalised: ${sentence}`,
    shrunk: (fitting: string) =>
      `At this length the net had to shrink. With the best fit, about ${fitting}, it keeps its size.`,
    range: (shortest: string, longest: string) => `${shortest} to ${longest}`,
    edgeLengths: (number: string) => `${number} edge lengths`,
    iterations: 'Iterations',
    iterationsIn: (iterations: string, milliseconds: string) => `${iterations} in ${milliseconds} ms`,
    deviation: 'Largest dL',
    edgesBefore: 'Edges before',
    edgesNow: 'Edges of the best attempt',
    spreadBefore: 'Standard deviation before',
    near: 'Near the surface, fair, no corner below 30°',
    guide: (surface: string) => `Near the surface beside it, ${surface}`,
    lengthsAlone:
      'No such net was found near the surface: this one has equal edges and nothing more, and its corners may be sharp.',
    beyondLimit: (quads: string) =>
      `No net was found whose corners all keep to 30°. Quads with a sharper one: ${quads}.`,
    meanDistance: 'Average distance from the surface',
    largestDistance: 'Largest distance from the surface',
    smallestAngle: 'Smallest corner',
    degrees: (degrees: string) => `${degrees}°`,
    folds: 'Folds over 60°',
    foldsOf: (folds: string, before: string) => `${folds}, before ${before}`,
    crumpled:
      'The net folds sharply where the edges of the original cannot all have one length near its surface. A net with edges of its own lies there more smoothly.',
    newNet: 'A new net on this surface…',
    meanMove: 'Average move',
    maxMove: 'Farthest move',
  },
};

function polygon(arity: number): string {
  return { 3: 'triangle', 4: 'quad', 5: 'pentagon', 6: 'hexagon' }[arity] ?? `${arity}-gon`;
}
