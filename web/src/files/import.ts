/** Nets from files. The core reads them; here only what can be told without reading is refused. */
import type { NetSource } from '../document/document';

/** Larger files are not nets one could edit: a net of 100,000 vertices has 10 MB. */
export const LARGEST_FILE = 100e6;

/** A file that is not even tried. `code` as in core/net/error.h. */
export class FileError extends Error {
  constructor(
    readonly code: 'bad_syntax' | 'too_large' | 'file_access',
    message: string,
  ) {
    super(message);
  }
}

/** The net of an OBJ file, unread. Throws FileError. */
export async function readNetFile(file: File): Promise<NetSource> {
  if (!/\.obj$/i.test(file.name)) {
    throw new FileError('bad_syntax', `${file.name} is not an OBJ file; nets are opened from OBJ files.`);
  }
  if (file.size > LARGEST_FILE) {
    const [size, largest] = [file.size, LARGEST_FILE].map((bytes) => Math.round(bytes / 1e6));
    throw new FileError('too_large', `${file.name} has ${size} MB; nets are opened up to ${largest} MB.`);
  }
  try {
    return { obj: await file.text(), name: file.name };
  } catch {
    throw new FileError('file_access', `${file.name} could not be read; perhaps it is a folder.`);
  }
}

/** Lets the user choose a file; null if they think better of it. */
export function pickFile(): Promise<File | null> {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = '.obj';
  return new Promise((resolve) => {
    input.onchange = () => resolve(input.files?.[0] ?? null);
    input.oncancel = () => resolve(null);
    input.click();
  });
}
