/** The dialogs that lead to another net, from a file or by equalising. */

export const dialogs = {
  file: {
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
  },
  equalize: {
    choice: 'Equalise: the nearest net with edges of equal length',
    choiceHint: 'You see before and after, and how far vertices move, before it is opened.',
    open: 'Equalise…',
    repairAndOpen: 'Repair and equalise…',
    openAsItIs: 'Equalise as it is…',
    title: (name: string) => `Equalise ${name}`,
    introduction:
      'All edges get one length. The net stays as near to the original as it can, and its faces and vertices stay the same.',
    length: 'Length of every edge',
    mean: (length: string) => `The mean of the original, ${length}`,
    fitting: 'The best fit',
    fittingKnown: (length: string) => `The best fit, ${length}`,
    fittingHint:
      'The net keeps the size of the original. At the mean length, a mesh that was split from triangles must crumple, and that shrinks it.',
    given: 'Another length',
    noLength: 'A length is a number above 0.',
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
      `At this length the net had to shrink. With ${fitting}, the best fit, it keeps its size.`,
    range: (shortest: string, longest: string) => `${shortest} to ${longest}`,
    edgeLengths: (number: string) => `${number} edge lengths`,
    iterations: 'Iterations',
    iterationsIn: (iterations: string, milliseconds: string) => `${iterations} in ${milliseconds} ms`,
    deviation: 'Largest dL',
    edgesBefore: 'Edges before',
    edgesNow: 'Edges of the best attempt',
    spreadBefore: 'Standard deviation before',
    meanMove: 'Average move',
    maxMove: 'Farthest move',
  },
};

function polygon(arity: number): string {
  return { 3: 'triangle', 4: 'quad', 5: 'pentagon', 6: 'hexagon' }[arity] ?? `${arity}-gon`;
}
