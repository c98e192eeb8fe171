/** What the project depends on is written down once, with versions, and it is these that are installed. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const read = (path: string) => readFileSync(ROOT + path, 'utf8');

type Versions = Record<string, string>;
interface Locked {
  version: string;
  integrity?: string;
  resolved?: string;
  dependencies?: Versions;
  devDependencies?: Versions;
}

const manifest = JSON.parse(read('web/package.json')) as { dependencies: Versions; devDependencies: Versions };
const lock = JSON.parse(read('web/package-lock.json')) as { packages: Record<string, Locked> };
const direct = { ...manifest.dependencies, ...manifest.devDependencies };
const { '': project, ...locked } = lock.packages;

/** The rows of a table of DEPENDENCIES.md. */
function listed(title: string): { name: string; version: string; reason: string }[] {
  const section = read('DEPENDENCIES.md')
    .split(/^## /m)
    .find((each) => each.startsWith(title));
  const rows = [...(section ?? '').matchAll(/^\| (\S+) \| (\S+) \| (.+) \|$/gm)];
  return rows
    .map(([, name = '', version = '', reason = '']) => ({ name, version, reason }))
    .filter(({ name }) => name !== 'package');
}

const versions = (rows: { name: string; version: string }[]) =>
  Object.fromEntries(rows.map(({ name, version }) => [name, version]));

/** What `script` says after tests/install was read. */
function sourced(script: string): string {
  return execFileSync('bash', ['-c', `set -euo pipefail; source tests/install; ${script}`], {
    cwd: ROOT,
    encoding: 'utf8',
  });
}

test('each dependency is listed once, with a reason', () => {
  const rows = [...listed('From Debian'), ...listed('From npm')];
  expect(new Set(rows.map(({ name }) => name)).size).toBe(rows.length);
  for (const { name, reason } of rows) expect(reason.replace('* ', '').length, name).toBeGreaterThan(3);
});

describe('npm', () => {
  test('has the versions of the list, and no other package', () => {
    expect(versions(listed('From npm'))).toEqual(direct);
  });

  test('has exact versions, and keeps them exact', () => {
    for (const [name, version] of Object.entries(direct)) expect(version, name).toMatch(/^\d+\.\d+\.\d+$/);
    expect(read('web/.npmrc')).toMatch(/^save-exact=true$/m);
  });

  test('installs just these', () => {
    expect({ ...project?.dependencies, ...project?.devDependencies }).toEqual(direct);
    for (const [name, version] of Object.entries(direct))
      expect(locked[`node_modules/${name}`]?.version, name).toBe(version);
    for (const [path, { integrity }] of Object.entries(locked)) expect(integrity, path).toMatch(/^sha512-/);
  });

  test('asks whichever registry a machine has: the lock file names none', () => {
    expect(Object.entries(locked).filter(([, { resolved }]) => resolved !== undefined)).toEqual([]);
    expect(read('web/.npmrc')).toMatch(/^omit-lockfile-registry-resolved=true$/m);
  });

  test('Node.js is as new as the list says', () => {
    const [oldest, own] = sourced('echo $node_minimum $node_from_npm').trim().split(' ');
    expect(read('DEPENDENCIES.md')).toContain(
      `Node.js is ${oldest} or newer; where the machine's own is older, ${own} is`,
    );
  });
});

describe('Debian', () => {
  test('has the packages of the list, and no other', () => {
    const needed = sourced('echo "${for_page[@]}" "${for_tests[@]}"').trim().split(' ');
    expect(
      listed('From Debian')
        .map(({ name }) => name)
        .sort(),
    ).toEqual(needed.sort());
  });

  test('another version than the one tried is named, and no obstacle', () => {
    const [first, second] = listed('From Debian');
    const pretend = `dpkg-query() { [[ $* == *${first!.name} ]] && echo ${first!.version} || echo 99; }`;
    const said = sourced(`${pretend}; warn_of_untried ${first!.name} ${second!.name}`);
    expect(said).toBe(`Note: ${second!.name} is 99 here; it was tried with ${second!.version}\n`);
  });

  test('a package that came from elsewhere is not asked about', () => {
    expect(sourced('dpkg-query() { return 1; }; warn_of_untried cmake')).toBe('');
  });
});
