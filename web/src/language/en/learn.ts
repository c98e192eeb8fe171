/** The lessons of the page. A name in braces is that of a formula (sidebar/formulas.ts). */
export const learn = {
  licences: 'chebnet is free software: its licence, and those of what it contains',
  showMe: 'Show me',
  noHandle: 'Make a vertex a handle first: pick it.',
  stagesDone: 'All stages are done: every edge had its length again. The net is as it was before the lesson.',
  lessons: {
    net: {
      title: 'A net of equal edges',
      text: 'A Chebyshev net has edges of one length, like wire mesh or woven cloth. Its faces may shear, its edges never stretch: that is how it takes on curved shapes. Of all such nets through the handles, this page finds one that bends and shears as little as it can.',
      show: 'how the net gives way to a handle and returns',
    },
    deviation: {
      title: 'How far an edge is off',
      text: 'Let {r} be the length of an edge, divided by the length it should have. Its deviation {deviation} is 0 if the length is right, and the same for twice as long as for half as long.',
      show: 'the edges by their deviation, in a colour for each power of ten',
    },
    energy: {
      title: 'The energy of the paper',
      text: 'The method of the paper, from which this page grew, seeks the shape with the least sum of {energy} over all edges. For each edge the least is at {atRest}. The larger {p}, the steeper the walls: with {p50} the worst edges count for nearly everything.',
      show: 'a handle far ahead of the net, and the worst edge climbing a wall',
    },
    stages: {
      title: 'Three stages',
      text: 'The method of the paper goes from rough to fine:',
      show: 'the steps of one stage, with the method of the paper',
    },
  },
  stageTexts: [
    'With {p2} the whole net moves, quickly and not yet exactly, until {rough} everywhere.',
    'With {p50} what is left spreads evenly over many edges, until {finer}.',
    'Only the vertices near edges that are still off move, until {fine}.',
  ],
  waits: 'Paused. “Show me” below “Three stages” goes on to the next one; a press elsewhere takes the handle back.',
  now: (p: number, ratio: string) => `Now: p\u00a0=\u00a0${p}; the worst edge, the dot, has r\u00a0=\u00a0${ratio}`,
  graph: (p: number, ratio: string) => `The energy of an edge against r, for p = ${p}; the worst edge has r = ${ratio}`,
};
