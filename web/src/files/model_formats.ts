/** The formats that model.ts reads, for pickers, hints and refusals: those that a library of the page knows rather than the
 *  core. */
import type { FormatInfo } from '../../../wasm/chebnet';

export const MODEL_FORMATS = [
  { title: 'GLB', extensions: ['glb', 'gltf'] },
  { title: '3DM', extensions: ['3dm'] },
];

/** What the core says of a file that it refuses. Where it names the formats it reads, these are among them. */
export function withModelFormats(message: string, formats: readonly FormatInfo[]): string {
  const titles = formats.map(({ title }) => title);
  const all = [...titles, ...MODEL_FORMATS.map(({ title }) => title)];
  return message.replace(listed(titles), listed(all));
}

/** As the core lists them. */
function listed(titles: readonly string[]): string {
  return `${titles.slice(0, -1).join(', ')} and ${titles.at(-1)}`;
}
