/** The projects that the browser keeps, as a visitor sees them: named, pictured, dated; to be opened, copied and deleted. */
import { delMany, get, getMany, set, setMany, update } from 'idb-keyval';
import type { ProjectLine } from '../dialogs/project_row';
import { netTitle } from '../document/changes';
import { type Term, textOf } from '../document/naming';
import { paintThumbnail } from '../elements/thumbnail';
import { Space } from '../view/space';
import type { Opening } from '../worker/opening';
import { freshId, heldLocks, INDEX, keysOf, lockOf, lookKey, NAMES, read, store } from './kept';

/** Pixels of a picture. */
export const PICTURE = { width: 192, height: 144 };
/** Edges drawn in a picture; of larger nets a part. */
const MOST_EDGES = 20_000;

/** What is listed of a project beside its name. */
interface Look {
  title: Term;
  /** Milliseconds since 1970. */
  date: number;
  /** How opaque each pixel is: it is drawn in the colour of the page. */
  picture: Uint8Array;
}

/** Newest first. */
export async function listProjects(): Promise<ProjectLine[]> {
  const ids = (await get<string[]>(INDEX, store)) ?? [];
  const names = (await get<Record<string, string>>(NAMES, store)) ?? {};
  const looks = await getMany<Look | undefined>(ids.map(lookKey), store);
  const held = await heldLocks();
  return ids.map((id, i) => {
    const look = looks[i];
    return {
      id,
      name: names[id] ?? '',
      title: look ? textOf(look.title) : '',
      date: look ? new Date(look.date) : null,
      picture: look?.picture ?? null,
      isElsewhere: held.has(lockOf(id)),
    };
  });
}

/** How a project looks now. */
export async function noteLook(id: string, { document: { net: source, view }, net, frame }: Opening): Promise<void> {
  const look: Look = {
    title: netTitle(source),
    date: Date.now(),
    picture: draw(net.edges, frame.positions, new Space(frame.positions, view.upAxis)),
  };
  await set(lookKey(id), look, store);
}

/** '': none. */
export async function nameOfProject(id: string): Promise<string> {
  return (await get<Record<string, string>>(NAMES, store))?.[id] ?? '';
}

/** '': none, and it is kept only until there are newer ones. */
export async function renameProject(id: string, name: string): Promise<void> {
  await update<Record<string, string>>(
    NAMES,
    (names = {}) => {
      const { [id]: _, ...others } = names;
      return name === '' ? others : { ...others, [id]: name };
    },
    store,
  );
}

export async function copyProject(id: string, name: string): Promise<void> {
  const kept = await read(id);
  if (kept === undefined) return;
  const copy = freshId();
  const look = await get<Look>(lookKey(id), store);
  await renameProject(copy, name);
  await setMany([[copy, kept.project], ...(look ? [[lookKey(copy), look] as [string, Look]] : [])], store);
  await update<string[]>(INDEX, (ids = []) => ids.flatMap((each) => (each === id ? [each, copy] : each)), store);
}

/** Returns what brings it back. */
export async function deleteProject(id: string): Promise<() => Promise<void>> {
  const kept = await read(id);
  const look = await get<Look>(lookKey(id), store);
  const ids = (await get<string[]>(INDEX, store)) ?? [];
  const name = await nameOfProject(id);
  await update<string[]>(INDEX, (all = []) => all.filter((each) => each !== id), store);
  await renameProject(id, '');
  await delMany(keysOf(id), store);
  return async () => {
    await renameProject(id, name);
    await setMany(
      [
        [id, kept?.project],
        [lookKey(id), look],
      ],
      store,
    );
    const place = ids.indexOf(id);
    await update<string[]>(INDEX, (all = []) => [...all.slice(0, place), id, ...all.slice(place)], store);
  };
}

/** As in the gallery. */
function draw(edges: Int32Array, positions: Float64Array, space: Space): Uint8Array {
  const { width, height } = PICTURE;
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext('2d')!;
  const upright = new Float32Array(positions.length);
  const point = { x: 0, y: 0, z: 0 };
  for (let i = 0; i < positions.length; i += 3) {
    space.toScene(point, [positions[i]!, positions[i + 1]!, positions[i + 2]!]);
    upright.set([point.x, point.y, point.z], i);
  }
  paintThumbnail(context, { edges: someOf(edges), positions: upright }, width, height);
  const { data } = context.getImageData(0, 0, width, height);
  return Uint8Array.from({ length: width * height }, (_, i) => data[4 * i + 3]!);
}

function someOf(edges: Int32Array): Int32Array {
  const step = Math.ceil(edges.length / 2 / MOST_EDGES);
  return step <= 1 ? edges : edges.filter((_, i) => (i >> 1) % step === 0);
}
