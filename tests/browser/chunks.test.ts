/** The files of the built page: what each of them imports. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseAst } from 'vite';
import { expect, test } from 'vitest';
import { DIST } from './site';

const ASSETS = join(DIST, 'assets');

interface Node {
  type: string;
  [part: string]: unknown;
}

const isNode = (value: unknown): value is Node => typeof value === 'object' && value !== null && 'type' in value;

/** Everything in a syntax tree, whole before part. */
function* nodesOf(node: Node): Generator<Node> {
  yield node;
  for (const part of Object.values(node).flat()) if (isNode(part)) yield* nodesOf(part);
}

/** The text of a literal, quoted in any way; null for what is reckoned when it runs. */
function textOf(node: unknown): string | null {
  if (!isNode(node)) return null;
  if (node.type === 'Literal') return typeof node['value'] === 'string' ? node['value'] : null;
  if (node.type !== 'TemplateLiteral') return null;
  const quasis = node['quasis'] as { value: { cooked: string } }[];
  return quasis.length === 1 ? quasis[0]!.value.cooked : null;
}

const IMPORTS = ['ImportDeclaration', 'ImportExpression', 'ExportNamedDeclaration', 'ExportAllDeclaration'];

/** What a chunk imports now or later, and which workers it starts; all by their file's names. */
function linksOf(chunk: string): { imports: string[]; workers: string[] } {
  const nodes = [...nodesOf(parseAst(readFileSync(join(ASSETS, chunk), 'utf8')) as unknown as Node)];
  const named = (texts: (string | null)[]) =>
    texts.flatMap((text) => (text === null ? [] : [text.replace(/^.*\//, '')]));
  const imports = nodes.filter(({ type }) => IMPORTS.includes(type)).map(({ source }) => textOf(source));
  const starts = nodes.filter(
    ({ type, callee }) => type === 'NewExpression' && isNode(callee) && callee['name'] === 'Worker',
  );
  const workers = starts
    .flatMap((start) => [...nodesOf(start)].map(textOf))
    .filter((text) => text?.endsWith('.js') ?? false);
  return { imports: named(imports), workers: named(workers) };
}

const chunks = readdirSync(ASSETS).filter((name) => name.endsWith('.js'));
const links = chunks.map((chunk) => ({ chunk, ...linksOf(chunk) }));

test('nothing imports the page or the lesson, and the lesson loads nothing of the page but what both need', () => {
  const entryOf = (page: string) =>
    /<script type="module"[^>]*assets\/([^"]*)"/.exec(readFileSync(join(DIST, page), 'utf8'))![1]!;
  const [page, lesson] = [entryOf('index.html'), entryOf('lesson.html')];
  const importedBy = (entry: string) => links.find(({ chunk }) => chunk === entry)!.imports;
  expect(links.filter(({ imports }) => imports.includes(page) || imports.includes(lesson))).toEqual([]);
  expect(importedBy(page)).toContainEqual(expect.stringMatching(/^first-/));
  expect(importedBy(lesson).filter((name) => !/^(common|lesson)-/.test(name))).toEqual([]);
});

test("no file imports from a worker's entry: WebKit would evaluate the entry a second time", () => {
  const workers = links.flatMap(({ workers }) => workers);
  expect([...new Set(workers)].map((name) => name.replace(/-.{8}\.js$/, '')).sort()).toEqual([
    'change_worker',
    'drape_worker',
    'equalize_worker',
    'export_worker',
    'file_worker',
    'new_net_worker',
    'worker',
  ]);
  expect(links.some(({ chunk, imports }) => chunk.startsWith('worker-') && imports.length > 0)).toBe(true);
  const guilty = links.filter(({ imports }) => imports.some((name) => workers.includes(name)));
  expect(guilty.map(({ chunk }) => chunk)).toEqual([]);
});
