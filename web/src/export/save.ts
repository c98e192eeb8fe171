/** Saves the net that is open as a file of some kind. */
import type { FlatPattern, FormatInfo, PatternFault, VertexLists } from '../../../wasm/chebnet';
import { lookOf } from '../document/document';
import { baseNameOf, fileNameOf } from '../files/file_name';
import { fieldOf, scaleOf } from '../fields/fields';
import { download } from '../files/download';
import { panelWords } from '../language/panels';
import type { Theme } from '../view/theme';
import type { Opening } from '../worker/opening';
import type { ExportAnswer, ExportJob } from './job';
import { typeOf } from './kinds';
import type { SaveRequest } from './kinds';
import { vertexColours } from './paint';
import { Failure } from '../failure';

/** What is saved. */
interface Saveable {
  readonly opening: Opening | null;
  /** The core's. */
  readonly formats: readonly FormatInfo[];
  /** See View.picture(). */
  picture(magnification: number): Promise<Blob>;
  /** The present net as the bytes of a file. */
  exported(format: string): Promise<Uint8Array<ArrayBuffer>>;
  flatPattern(): Promise<FlatPattern | PatternFault>;
  rods(): Promise<VertexLists>;
  say(message: string, action?: { label: string; run(): void }): void;
}

interface SaveParts {
  app: Saveable;
  theme(): Theme;
  spawnWorker(): Worker;
  /** Cuts the net into flat pieces, and then, if it has. */
  cutFlat(then: () => Promise<void>): void;
}

/** Why a net does not lie flat that would if it were cut. */
const CUT_HELPS: readonly PatternFault['reason'][] = ['singular', 'closed', 'overlap', 'touching'];

export async function save(request: SaveRequest, parts: SaveParts): Promise<void> {
  const { app } = parts;
  const { opening, formats } = app;
  if (opening === null) return;
  const content = await contentOf(request, opening, parts);
  if (content === null) return;
  const extension = request.kind === 'csv' && request.table !== 'edges' ? `${request.table}.csv` : request.kind;
  const name = fileNameOf(opening.document.net, extension, formats);
  download(name, content, typeOf(request.kind, formats));
  // A browser may save it without a word, and shows none of it to a screen reader.
  app.say(panelWords.saving.done(name));
}

/** Null: there is none, and why is said with a way out. */
async function contentOf(request: SaveRequest, opening: Opening, parts: SaveParts): Promise<BlobPart | null> {
  const { app, theme, spawnWorker } = parts;
  switch (request.kind) {
    case 'png':
      return app.picture(request.magnification);
    case '3dm':
      return made(rhinoJob(await app.rods(), opening, app.formats), spawnWorker());
    case 'glb':
      return made(paintedJob(opening, theme(), app.formats), spawnWorker());
    case 'csv':
      return app.exported(request.table);
    case 'svg':
      return patternOf(request, opening, parts);
    default:
      return app.exported(request.kind);
  }
}

async function patternOf(request: SaveRequest, opening: Opening, parts: SaveParts): Promise<BlobPart | null> {
  const { app } = parts;
  const pattern = await app.flatPattern();
  if (!('reason' in pattern)) return made(drawing(pattern, request, opening, app.formats), parts.spawnWorker());
  const why = patternFaultWords(pattern);
  if (!CUT_HELPS.includes(pattern.reason)) throw new Failure('no_pattern', why);
  const again = (): Promise<void> => save(request, parts);
  app.say(why, { label: panelWords.saving.pattern.cutAndSave, run: () => parts.cutFlat(again) });
  return null;
}

function drawing(
  pattern: FlatPattern,
  { edgeMm }: SaveRequest,
  { document, net }: Opening,
  formats: readonly FormatInfo[],
): ExportJob {
  const lines = { start: net.lineStart, vertices: net.lineVertices };
  const loops = { start: net.loopStart, vertices: net.loopVertices };
  return {
    kind: 'svg',
    pattern,
    lines,
    loops,
    faces: { start: net.faceStart, vertices: net.faceVertices },
    restPositions: net.restPositions,
    meanLength: net.info.meanLength,
    handles: document.handles,
    name: baseNameOf(document.net, formats),
    edgeMm,
  };
}

function rhinoJob(rods: VertexLists, { document, net, frame }: Opening, formats: readonly FormatInfo[]): ExportJob {
  const { faceStart, faceVertices } = net;
  return {
    kind: '3dm',
    mesh: { faceStart, faceVertices },
    positions: frame.positions,
    rods,
    name: baseNameOf(document.net, formats),
    layers: panelWords.saving.layers,
  };
}

function paintedJob({ document, net, frame }: Opening, theme: Theme, formats: readonly FormatInfo[]): ExportJob {
  const { edges, triangles } = net;
  const { positions } = frame;
  const { field, upAxis: up = 'z' } = document.view;
  const colours = vertexColours(scaleOf(lookOf(document), theme), fieldOf(field), frame, net);
  const name = baseNameOf(document.net, formats);
  return { kind: 'glb', positions, triangles, edges, colours, ink: theme.ink, up, name };
}

/** Runs a job in a worker, so as not to block the page. */
function made(job: ExportJob, worker: Worker): Promise<Uint8Array<ArrayBuffer>> {
  const answered = new Promise<ExportAnswer>((resolve) => {
    worker.onmessage = ({ data }: MessageEvent<ExportAnswer>) => resolve(data);
    worker.onerror = ({ message }) => resolve({ message: message || panelWords.saving.notStarted });
    worker.postMessage(job);
  });
  return answered.then(bytesOf).finally(() => worker.terminate());
}

function bytesOf(answer: ExportAnswer): Uint8Array<ArrayBuffer> {
  if ('bytes' in answer) return answer.bytes;
  throw new Failure('not_saved', panelWords.saving.failed(answer.message));
}

function patternFaultWords(fault: PatternFault): string {
  const { pattern } = panelWords.saving;
  switch (fault.reason) {
    case 'singular':
      return pattern.singular(fault.vertex, fault.valence);
    case 'closed':
      return pattern.closed;
    case 'not_quads':
    case 'loose':
      return pattern[fault.reason](fault.face);
    case 'overlap':
      return pattern.overlap;
    case 'touching':
      return pattern.touching(fault.vertex);
    case 'unequal':
      return pattern.unequal;
  }
}
