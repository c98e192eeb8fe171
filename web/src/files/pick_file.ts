import type { FormatInfo } from '../../../wasm/chebnet';
import { MODEL_FORMATS } from './model_formats';

/** Lets the user choose a mesh, or a project as well; null if they cancel. */
export function pickFile(formats: readonly FormatInfo[], what: 'mesh' | 'any'): Promise<File | null> {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = acceptOf(formats, what);
  return new Promise((resolve) => {
    input.onchange = () => resolve(input.files?.[0] ?? null);
    input.oncancel = () => resolve(null);
    input.click();
  });
}

/** The extensions that can be opened; any file while no format is known. */
export function acceptOf(formats: readonly FormatInfo[], what: 'mesh' | 'any'): string {
  if (formats.length === 0) return '';
  const meshes = formats.map(({ name }) => name);
  const models = MODEL_FORMATS.flatMap(({ extensions }) => extensions);
  const projects = what === 'any' ? ['json'] : [];
  return [...meshes, ...models, ...projects].map((extension) => `.${extension}`).join();
}
