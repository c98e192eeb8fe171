/** The lessons of the page. */
export const learn = {
  licences: 'chebnet is free software: its licence, and those of what it contains',
  showMe: 'Show me',
  noHandle: 'Make a vertex a handle first: click it.',
  stagesDone: 'All stages are done: every edge has its length again, and the usual method is back.',
  lessons: {
    net: {
      title: 'A net of equal edges',
      text: 'A Chebyshev net has edges of one length, like wire mesh or woven cloth. Its faces may shear, its edges never stretch: that is how it takes on curved shapes.',
      show: 'how the net gives way to a handle and returns',
    },
    deviation: {
      title: 'How far an edge is off',
      text: 'Let r be the length of an edge, divided by the length it should have. Its deviation dL = r + 1/r − 2 is 0 if the length is right, and the same for twice as long as for half as long.',
      show: 'the edges by their deviation, in a colour for each power of ten',
    },
    energy: {
      title: 'The energy',
      text: 'The solver seeks the shape with the least sum of r^p + r^−p over all edges. For each edge the least is at r = 1. The larger p, the steeper the walls: with p = 50 the worst edges count for nearly everything.',
      show: 'a handle far ahead of the net, and the worst edge climbing a wall',
    },
    stages: {
      title: 'Three stages',
      text: 'The method of the paper goes from rough to fine:',
      show: 'the steps of one stage, with the method of the paper',
    },
  },
  stageTexts: [
    'With p = 2 the whole net moves, quickly and not yet exactly, until dL is below 0.01 everywhere.',
    'With p = 50 what is left spreads evenly over many edges, until dL is below 0.0001.',
    'Only the vertices near edges that are still off move, until dL is below 0.000001.',
  ],
  now: (p: number, ratio: string) => `Now: p = ${p}; the worst edge, the dot, has r = ${ratio}`,
  graph: (p: number, ratio: string) => `The energy of an edge against r, for p = ${p}; the worst edge has r = ${ratio}`,
};
