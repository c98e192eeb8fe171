/** Figure 3, tried in a worker: each net is edited, and beside that its surface is deformed and gets a new net. */
import type { Chebnet, Editor, Mesh, Surface } from '../../../wasm/chebnet';
import type { SolverSettings } from '../document/document';
import { pointOf } from '../document/point_of';
import { partDone } from '../drape/phases';
import { codeOf, messageOf } from '../failure';
import { openNet } from '../worker/opened_net';
import type { EditScene } from './edits';
import type { MadeNet, NewNetRequest, NewNetResponse, TriedEdit } from './new_net_protocol';

/** Each way is run so often, and the fastest counts: engines compile code as it runs. */
const RUNS = 2;
/** The part of the work on an edit that is done before a new net is begun. */
const EDITED = 0.1;

type Progress = (makes: boolean, done: number) => void;

/** What an edit is of. */
interface Subject {
  rest: Mesh;
  length: number;
  singularVertices: number;
  handles: { vertex: number; target: [number, number, number] }[];
}

interface Solved {
  mesh: Mesh;
  milliseconds: number;
}

export function tryNewNets(
  core: Chebnet,
  { edits, ways, deforming }: NewNetRequest,
  post: (response: NewNetResponse) => void,
): void {
  try {
    edits.forEach((scene, edit) => {
      const progress: Progress = (makes, done) => post({ type: 'progress', edit, makes, done });
      post({ type: 'tried', edit, tried: tryEdit(core, scene, ways, deforming, progress) });
    });
    post({ type: 'ended' });
  } catch (error) {
    post({ type: 'error', code: codeOf(error), message: messageOf(error) });
  }
}

function tryEdit(
  core: Chebnet,
  scene: EditScene,
  ways: readonly SolverSettings[],
  deforming: SolverSettings,
  progress: Progress,
): TriedEdit {
  progress(false, 0);
  const subject = subjectOf(core, scene);
  const deformed = solve(core, subject, deforming);
  const surface = core.openSurface(deformed.mesh);
  try {
    const edited = ways.map((way) => {
      const { mesh, milliseconds } = solve(core, subject, way);
      return { milliseconds, singularVertices: subject.singularVertices, distance: distanceOf(surface, mesh, subject) };
    });
    return { edited, made: newNet(surface, subject, deformed.milliseconds, progress) };
  } finally {
    surface.dispose();
  }
}

function subjectOf(core: Chebnet, { net, handles }: EditScene): Subject {
  const editor = openNet(core, net);
  const { restPositions: positions, faceStart, faceVertices, info } = editor;
  editor.dispose();
  return {
    rest: { positions, faceStart, faceVertices },
    length: info.meanLength,
    singularVertices: Object.values(info.singularVertices).reduce((sum, each) => sum + each, 0),
    handles: handles.map(({ vertex, target }) => ({ vertex, target: target ?? pointOf(positions, vertex) })),
  };
}

/** From rest, as often as it takes to know how long that takes. */
function solve(core: Chebnet, { rest, handles }: Subject, settings: SolverSettings): Solved {
  const times: number[] = [];
  let positions = rest.positions;
  for (let run = 0; run < RUNS; run++) {
    const editor = core.openMesh(rest);
    setUp(editor, settings);
    editor.setHandles(handles);
    times.push(editor.solve().milliseconds);
    positions = editor.positions();
    editor.dispose();
  }
  return { mesh: { ...rest, positions }, milliseconds: Math.min(...times) };
}

function setUp(editor: Editor, { method, initialisation, options }: SolverSettings): void {
  editor.setMethod(method);
  editor.setInitialisation(initialisation);
  for (const [name, value] of Object.entries(options)) editor.setOption(name, value);
}

function newNet(surface: Surface, subject: Subject, deforming: number, progress: Progress): TriedEdit['made'] {
  progress(true, EDITED);
  const start = performance.now();
  try {
    const { mesh, singularVertices } = surface.remesh({ length: subject.length }, (phase, done) =>
      progress(true, EDITED + (1 - EDITED) * partDone(phase, done)),
    );
    return {
      milliseconds: deforming + performance.now() - start,
      singularVertices: singularVertices.reduce((sum, each) => sum + each.count, 0),
      distance: distanceOf(surface, mesh, subject),
    };
  } catch (error) {
    return messageOf(error);
  }
}

function distanceOf(surface: Surface, mesh: Mesh, { length }: Subject): MadeNet['distance'] {
  return surface.measure(mesh).meanDistance / length;
}
