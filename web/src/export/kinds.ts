/** Kinds of files to save a net as: the formats of the core's table, and some that the page makes itself. */
import type { FormatInfo } from '../../../wasm/chebnet';

/** What is offered under one heading. */
export type Purpose = 'meshes' | 'making' | 'pictures';

/** The page's own, in the order of the menu; mesh formats follow the core's format named by `after`. */
const OWN = [
  { name: '3dm', mediaType: 'model/vnd.3dm', purpose: 'meshes', after: 'obj' },
  { name: 'glb', mediaType: 'model/gltf-binary', purpose: 'meshes', after: 'stl' },
  { name: 'svg', mediaType: 'image/svg+xml', purpose: 'making' },
  { name: 'csv', mediaType: 'text/csv', purpose: 'making' },
  { name: 'png', mediaType: 'image/png', purpose: 'pictures' },
] as const satisfies readonly { name: string; mediaType: string; purpose: Purpose; after?: string }[];

/** Of what CSV lists the lengths. */
export const TABLES = ['edges', 'rods'] as const;
export type TableName = (typeof TABLES)[number];

/** Each has a hint in `panelWords.exports.hints`. */
type OwnKind = (typeof OWN)[number]['name'];
/** A name of either table. */
export type FileKind = string;

/** What a user wants saved, and how. */
export interface SaveRequest {
  kind: FileKind;
  /** Of the pattern: how long an edge is drawn. */
  edgeMm: number;
  /** Of CSV. */
  table: TableName;
  /** Of the picture: how many times the pixels of the screen. */
  magnification: number;
}

/** One line of the menu. */
interface ExportKind {
  kind: FileKind;
  title: string;
  hint: string;
}

/** @param formats the core's table. @param words `about` those, and `hints` of the page's own. */
export function kindsFor(
  purpose: Purpose,
  formats: readonly FormatInfo[],
  words: { about: (format: FormatInfo) => string; hints: Record<OwnKind, string> },
): ExportKind[] {
  const own = OWN.filter((each) => each.purpose === purpose);
  const line = ({ name }: (typeof OWN)[number]): ExportKind => ({
    kind: name,
    title: name.toUpperCase(),
    hint: words.hints[name],
  });
  if (purpose !== 'meshes') return own.map(line);
  return formats.flatMap((format) => [
    { kind: format.name, title: format.title, hint: words.about(format) },
    ...own.filter((each) => 'after' in each && each.after === format.name).map(line),
  ]);
}

export function typeOf(kind: FileKind, formats: readonly FormatInfo[]): string {
  return [...formats, ...OWN].find(({ name }) => name === kind)!.mediaType;
}
