/** The lesson with the editor in it; see embed/lesson.ts. */
export const lesson = {
  locale: 'en-US',
  title: 'A net with edges of one length',
  wireMesh:
    'Take a piece of wire mesh. You can bend it over a ball, though you could not wrap the ball in paper without creases. The wires stay as long as they are; what gives way are the angles between them. A ',
  chebyshevNet: 'Chebyshev net',
  mathematics: ' is the mathematics of that mesh: each edge keeps its length, and each quad may shear.',
  tryIt: 'Try it',
  howTo:
    'Click the picture, then drag the orange sphere. Escape, or a click beside the picture, gives the page its scrolling back.',
  picture: 'A dome of wire mesh that can be dragged',
  push: 'Push the crown down',
  lift: 'Lift it',
  again: 'Start again',
  loading: 'The net is loading.',
  measured: (edges: number, worst: string, iterations: number) =>
    `The largest dL of its ${edges} edges is ${worst}, after ${iterations} iterations.`,
  below: (limit: string) => `below ${limit}`,
  lookFor: 'What to look for',
  deviation:
    'The deviation of an edge is dL = r + 1/r − 2, where r is its length divided by the length it should have. It is 0 for a perfect edge. Push the crown down a few times and watch the number: however the dome looks, the largest dL of all edges comes back below 0.000001, which is a tenth of a percent of the length.',
  limit:
    'Now lift the crown as far as it goes. A net is as long as its edges: at some point no shape exists, and the picture says so.',
};
