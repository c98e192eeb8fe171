/** The experiments in the order of the paper's figures. Which experiment stands for which figure is our reading of it. */
import {
  DOME,
  ELEPHANT,
  JACK,
  LARGE_VAULT,
  MANY_HANDLES,
  MIXED,
  RESTING_TORUS,
  SMALL_VAULT,
  TORUS,
  TUBE,
  VAULT,
} from './edits';
import type { Experiment } from './experiment';

const fixed = (p: number) => ({ label: `p = ${p}`, options: { adaptive_p: false, p_end: p } });

export const EXPERIMENTS: readonly Experiment[] = [
  {
    name: 'exponent',
    figure: 4,
    title: 'Which exponent?',
    text:
      'A small exponent p spreads the error quickly but leaves a few bad edges; a large one evens them out but starts slowly. ' +
      'Solve with each and watch the slope of the curve; adaptive p is to take the best of both.',
    edit: VAULT,
    variants: [fixed(2), fixed(4), fixed(10), fixed(50)],
    compare: [],
    converges: true,
  },
  {
    name: 'adaptive-exponent',
    figure: 5,
    title: 'Adaptive exponent',
    text:
      'The solve begins with p = 2 and goes over to p = 50 when the largest dL is below 0.01. ' +
      'Count the iterations with and without: from the start p = 50 sees little but the worst edges.',
    edit: DOME,
    variants: [{ label: 'Without', options: { adaptive_p: false } }],
    compare: [],
    converges: true,
  },
  {
    name: 'fewer-variables',
    figure: 7,
    title: 'Fewer variables near the end',
    text:
      'In stage 3 only vertices close to edges that are still off may move. Step until the stage begins, and look how ' +
      'many vertices are left. Iterations hardly change; the question is what each of the last ones costs.',
    edit: JACK,
    variants: [{ label: 'Without', options: { adaptive_reduction: false } }],
    compare: [],
    converges: true,
  },
  {
    name: 'long-edges',
    figure: 8,
    title: 'Longer on the way',
    text:
      'The tube is pressed together. Composite majorization gives compressed edges no stiffness across, so after its first ' +
      'step nearly all edges are too long. Step with arrows and compare how far the wall swells with the paper’s method.',
    edit: TUBE,
    settings: { method: 'composite_majorization' },
    variants: [{ label: 'The paper’s method', method: 'li2022' }],
    compare: ['composite_majorization', 'li2022'],
    converges: true,
  },
  {
    name: 'majorizers',
    figure: 9,
    title: 'Three majorizers',
    text:
      'One energy, three convex stand-ins for its Hessian. All end at the same lengths; look at how many iterations each ' +
      'takes, and whether the time of an iteration differs.',
    edit: TORUS,
    variants: [
      { label: 'Composite majorization', method: 'composite_majorization' },
      { label: 'Projected Newton', method: 'projected_newton' },
    ],
    compare: ['li2022', 'composite_majorization', 'projected_newton'],
    converges: true,
  },
  {
    name: 'energies',
    figure: 10,
    title: 'Which energy?',
    text:
      'Energy (3) against the powers of dL themselves and against |r − 1| to the power of 4 and 8. ' +
      'Look for energies that come to a halt above the threshold: where their gradient fades, edges stay wrong.',
    edit: TUBE,
    variants: [
      { label: 'Powers of dL', options: { direct_energy: true } },
      { label: '|r − 1|⁴', method: 'dp4' },
      { label: '|r − 1|⁸', method: 'dp8' },
    ],
    compare: ['li2022', 'dp4', 'dp8'],
    converges: true,
  },
  {
    name: 'initialisations',
    figure: 12,
    title: 'Where to begin',
    text:
      'A far jump of one handle can begin from the net as it stands, or first be spread by five iterations of ARAP or of ' +
      'local–global. See whether the better start saves iterations, and whether the shape it leads to is fairer.',
    edit: VAULT,
    variants: [
      { label: 'ARAP first', initialisation: 'arap:5' },
      { label: 'Local–global first', initialisation: 'local_global:5' },
    ],
    compare: ['li2022', 'composite_majorization'],
    converges: true,
  },
  {
    name: 'arap',
    figure: 13,
    title: 'As rigid as possible',
    text:
      'ARAP keeps local shapes, not lengths: it settles soon, but red edges remain. ' +
      'Then solve with the paper’s method from the same start: the net may shear, and every edge keeps its length.',
    edit: VAULT,
    settings: { method: 'arap' },
    variants: [{ label: 'The paper’s method', method: 'li2022' }],
    compare: ['arap', 'li2022'],
    converges: false,
  },
  {
    name: 'local-global',
    figure: 14,
    title: 'Local–global',
    text:
      'Each iteration is cheap, for its linear system never changes. The curve falls fast and then flattens: ' +
      'look where it stands when the iterations run out, against the milliseconds that the paper’s method takes.',
    edit: TUBE,
    settings: { method: 'local_global' },
    variants: [{ label: 'The paper’s method', method: 'li2022' }],
    compare: ['local_global', 'li2022'],
    converges: false,
  },
  {
    name: 'first-order',
    figure: 15,
    title: 'Gradients only',
    text:
      'Steepest descent and L-BFGS on the paper’s energy, with 1000 iterations allowed. Step with arrows: the gradient moves ' +
      'what is next to the handle, while a Newton step moves the whole net at once.',
    edit: SMALL_VAULT,
    settings: { method: 'gradient_descent', options: { max_iterations: 1000 } },
    variants: [
      { label: 'L-BFGS', method: 'lbfgs' },
      { label: 'The paper’s method', method: 'li2022' },
    ],
    compare: ['gradient_descent', 'lbfgs', 'li2022'],
    converges: false,
  },
  {
    name: 'drag',
    figure: 16,
    title: 'Drag it',
    text:
      'Take the orange sphere and move it about. Each frame starts from the last one, so a few iterations are enough; ' +
      'watch Last solve under Convergence while the hand moves.',
    edit: RESTING_TORUS,
    compare: ['li2022', 'composite_majorization', 'projected_newton'],
    converges: true,
  },
  {
    name: 'many-handles',
    figure: 17,
    title: 'Many handles',
    text:
      'Twenty-five handles jump at once to where an earlier edit had left them. Each is held exactly, and the net ' +
      'between them still finds its lengths. Then move one a little: close handles leave it less room.',
    edit: MANY_HANDLES,
    compare: ['li2022', 'projected_newton', 'arap'],
    converges: true,
  },
  {
    name: 'size',
    figure: 18,
    title: 'Larger nets',
    text:
      'The same edit on nets of 4000 and of 1500 vertices. Solve both and compare iterations and milliseconds: ' +
      'look whether an iteration costs more than in proportion, and how slowly their number grows.',
    edit: LARGE_VAULT,
    variants: [{ label: '1500 vertices', edit: VAULT }],
    compare: ['li2022', 'composite_majorization', 'projected_newton'],
    converges: true,
  },
  {
    name: 'singular-vertices',
    figure: 20,
    title: 'Singular vertices',
    text:
      'At the corners of the elephant three, five or six edges meet instead of four. Nothing in the method asks for four; ' +
      'look whether edges around the corners are the last to come right.',
    edit: ELEPHANT,
    compare: ['li2022', 'composite_majorization', 'projected_newton'],
    converges: true,
  },
  {
    name: 'general-meshes',
    figure: 21,
    title: 'General meshes',
    text:
      'Rows of squares alternate with rows of triangles, and each edge keeps its own length rather than one for all. ' +
      'Triangles cannot shear, so the sheet bends where it may; drag the handle far and it finds no way.',
    edit: MIXED,
    compare: ['li2022', 'composite_majorization', 'projected_newton'],
    converges: true,
  },
];
