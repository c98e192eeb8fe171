/**
 * A Vite plugin that puts the licences of all that the page is made of into licences.txt: of each package found in a built
 * script, and of the native libraries in the WebAssembly modules. A package without a text of its own fails the build.
 * Vite's `build.license` does not look into workers; rollup-plugin-license would bring eight packages more.
 */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename } from 'node:path';
import type { Plugin, Rolldown } from 'vite';

const HERE = new URL('./', import.meta.url);
const PACKAGES = new URL('node_modules/', HERE);
/** Of packages that bring no text, or more than concerns the page. */
const KEPT_TEXTS = new URL('licences/', HERE);
/** Of what the compiler puts into the WebAssembly modules. */
const NATIVE_TEXTS = new URL('../wasm/licences/', HERE);

const HEAD = `chebnet is free software, under the licence that stands here first. It contains the work of others, under the licences
that follow.`;

/** One plugin for the page and one for its workers, which are built apart, before it. */
export function licences(): { page: Plugin; worker: Plugin } {
  const packages = new Set<string>();
  const gather = (bundle: Rolldown.OutputBundle): void => {
    for (const name of packagesIn(bundle)) packages.add(name);
  };
  return {
    worker: { name: 'licences-of-workers', generateBundle: (_, bundle) => gather(bundle) },
    page: {
      name: 'licences',
      generateBundle(_, bundle) {
        gather(bundle);
        this.emitFile({ type: 'asset', fileName: 'licences.txt', source: licencesOf([...packages].sort()) });
      },
    },
  };
}

function packagesIn(bundle: Rolldown.OutputBundle): string[] {
  const modules = Object.values(bundle).flatMap((each) => (each.type === 'chunk' ? each.moduleIds : []));
  return modules.map(packageOf).filter((name) => name !== undefined);
}

function packageOf(module: string): string | undefined {
  // Written by plasma.ts, by Vite and by its bundler.
  if (module === '\0plasma') return 'd3-scale-chromatic';
  return /^\0(vite|rolldown)\//.exec(module)?.[1] ?? /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(module)?.[1];
}

function licencesOf(packages: readonly string[]): string {
  const native = readdirSync(NATIVE_TEXTS).sort();
  const texts = [
    HEAD,
    titled('chebnet', read(new URL('../LICENSE', HERE))),
    ...packages.map(licenceOfPackage),
    ...native.map((file) => titled(basename(file, '.txt'), read(new URL(file, NATIVE_TEXTS)))),
  ];
  // Servers rarely say how a text is encoded; its first character does.
  return `\uFEFF${texts.join('\n\n')}\n`;
}

function licenceOfPackage(name: string): string {
  const folder = new URL(`${name}/`, PACKAGES);
  const { version, license } = JSON.parse(read(new URL('package.json', folder))) as {
    version: string;
    license: string;
  };
  return titled(`${name} ${version} (${license})`, textOfPackage(name, folder));
}

function textOfPackage(name: string, folder: URL): string {
  const kept = new URL(`${name}.txt`, KEPT_TEXTS);
  if (existsSync(kept)) return read(kept);
  const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
  if (file === undefined)
    throw new Error(`${name} brings no licence text; please put it into web/licences/${name}.txt`);
  return read(new URL(file, folder));
}

function titled(title: string, text: string): string {
  return `${'='.repeat(80)}\n${title}\n${'='.repeat(80)}\n\n${text}`;
}

function read(file: URL): string {
  return readFileSync(file, 'utf8').trim();
}
