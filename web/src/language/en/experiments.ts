/** The experiments: what each is called, and what to look for. */
export const experiments = {
  exponent: {
    title: 'Which exponent?',
    text:
      'A small exponent p spreads the error quickly but leaves a few bad edges; a large one evens them out but starts slowly. ' +
      'Solve with each and watch the slope of the curve; adaptive p is to take the best of both.',
  },
  'adaptive-exponent': {
    title: 'Adaptive exponent',
    text:
      'The solve begins with p = 2 and goes over to p = 50 when the largest dL is below 0.01. ' +
      'Count the iterations with and without: from the start p = 50 sees little but the worst edges.',
  },
  'fewer-variables': {
    title: 'Fewer variables near the end',
    text:
      'In stage 3 only vertices close to edges that are still off may move. Step until the stage begins, and look how ' +
      'many vertices are left. Iterations hardly change; the question is what each of the last ones costs.',
  },
  'long-edges': {
    title: 'Longer on the way',
    text:
      'The tube is pressed together. Composite majorization gives compressed edges no stiffness across, so after its first ' +
      'step nearly all edges are too long. Step with arrows and compare how far the wall swells with the paper’s method.',
  },
  majorizers: {
    title: 'Three majorizers',
    text:
      'One energy, three convex stand-ins for its Hessian. All end at the same lengths; look at how many iterations each ' +
      'takes, and whether the time of an iteration differs.',
  },
  energies: {
    title: 'Which energy?',
    text:
      'Energy (3) against the powers of dL themselves and against |r − 1| to the power of 4 and 8. ' +
      'Look for energies that come to a halt above the threshold: where their gradient fades, edges stay wrong.',
  },
  initialisations: {
    title: 'Where to begin',
    text:
      'A far jump of one handle can begin from the net as it stands, or first be spread by five iterations of ARAP or of ' +
      'local–global. See whether the better start saves iterations, and whether the shape it leads to is fairer.',
  },
  arap: {
    title: 'As rigid as possible',
    text:
      'ARAP keeps local shapes, not lengths: it settles soon, but red edges remain. ' +
      'Then solve with the paper’s method from the same start: the net may shear, and every edge keeps its length.',
  },
  'local-global': {
    title: 'Local–global',
    text:
      'Each iteration is cheap, for its linear system never changes. The curve falls fast and then flattens: ' +
      'look where it stands when the iterations run out, against the milliseconds that the paper’s method takes.',
  },
  'first-order': {
    title: 'Gradients only',
    text:
      'Steepest descent and L-BFGS on the paper’s energy, with 1000 iterations allowed. Step with arrows: the gradient moves ' +
      'what is next to the handle, while a Newton step moves the whole net at once.',
  },
  drag: {
    title: 'Drag it',
    text:
      'Take the orange sphere and move it about. Each frame starts from the last one, so a few iterations are enough; ' +
      'watch Last solve under Convergence while the hand moves.',
  },
  'many-handles': {
    title: 'Many handles',
    text:
      'Twenty-five handles jump at once to where an earlier edit had left them. Each is held exactly, and the net ' +
      'between them still finds its lengths. Then move one a little: close handles leave it less room.',
  },
  size: {
    title: 'Larger nets',
    text:
      'The same edit on nets of 4000 and of 1500 vertices. Solve both and compare iterations and milliseconds: ' +
      'look whether an iteration costs more than in proportion, and how slowly their number grows.',
  },
  'singular-vertices': {
    title: 'Singular vertices',
    text:
      'At the corners of the elephant three, five or six edges meet instead of four. Nothing in the method asks for four; ' +
      'look whether edges around the corners are the last to come right.',
  },
  'general-meshes': {
    title: 'General meshes',
    text:
      'Rows of squares alternate with rows of triangles, and each edge keeps its own length rather than one for all. ' +
      'Triangles cannot shear, so the sheet bends where it may; drag the handle far and it finds no way.',
  },
};

/** Other settings of an experiment. */
export const variants = {
  without: 'Without',
  paper: 'The paper’s method',
  powers: 'Powers of dL',
  arap: 'ARAP first',
  localGlobal: 'Local–global first',
  vertices: (count: number) => `${count} vertices`,
};
