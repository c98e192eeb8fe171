// Runs the targets, two at a time, and prints what each has done. Started by tests/fuzz/run.
import { spawn } from 'node:child_process';
import { randomInt } from 'node:crypto';
import { createWriteStream, existsSync, mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { parseArgs } from 'node:util';

const here = resolve('tests/fuzz');
const kept = resolve('build/fuzz');

/** A program with all that it says in a file; resolves to its exit code. */
function run(command, args, log, options = {}) {
  return new Promise((done, failed) => {
    const program = spawn(command, args, { ...options, stdio: ['ignore', 'pipe', 'pipe'] });
    const file = createWriteStream(log);
    program.stdout.pipe(file, { end: false });
    program.stderr.pipe(file, { end: false });
    program.on('error', failed);
    program.on('close', (code) => file.end(() => done(code)));
  });
}

/** The last match of a pattern with one group, as a number; null if there is none. */
function lastNumber(text, pattern) {
  const all = [...text.matchAll(pattern)];
  return all.length > 0 ? Number(all.at(-1)[1]) : null;
}

/** A target in C++, driven by libFuzzer. */
function coreTarget(name) {
  return async (seconds, seed) => {
    const folder = join(kept, name);
    const corpus = join(folder, 'corpus');
    mkdirSync(corpus, { recursive: true });
    const dictionary = join(here, 'dictionaries', `${name}.dict`);
    const log = join(folder, 'log.txt');
    const code = await run(
      resolve('build/sanitize/tests/fuzz', `fuzz_${name}`),
      [
        corpus,
        join(here, 'corpus', name),
        ...(existsSync(dictionary) ? [`-dict=${dictionary}`] : []),
        `-max_total_time=${seconds}`,
        `-seed=${seed}`,
        // An input that takes longer, or more memory, counts as one that breaks something.
        '-timeout=20',
        '-rss_limit_mb=2048',
        '-malloc_limit_mb=1024',
        '-max_len=4096',
        `-artifact_prefix=${folder}/`,
        '-print_final_stats=1',
      ],
      log,
      { env: { UBSAN_OPTIONS: 'print_stacktrace=1', ...process.env } },
    );
    const text = readFileSync(log, 'utf8');
    return {
      executions: lastNumber(text, /stat::number_of_executed_units: (\d+)/g),
      coverage: lastNumber(text, /cov: (\d+)/g),
      features: lastNumber(text, /ft: (\d+)/g),
      failed: code !== 0,
      log,
    };
  };
}

/** A target in TypeScript, driven by fast-check within a test. */
function pageTarget(name) {
  return async (seconds, seed) => {
    const folder = join(kept, name);
    mkdirSync(folder, { recursive: true });
    const log = join(folder, 'log.txt');
    const code = await run('npx', ['vitest', 'run', '--project', 'fuzz', `${name}.test.ts`], log, {
      cwd: 'web',
      env: { ...process.env, CHEBNET_FUZZ_SECONDS: String(seconds), CHEBNET_SEED: String(seed) },
    });
    const counts = [...readFileSync(log, 'utf8').matchAll(/executions: (\d+)/g)];
    return {
      executions: counts.reduce((sum, [, count]) => sum + Number(count), 0),
      coverage: null,
      features: null,
      failed: code !== 0,
      log,
    };
  };
}

function findTargets() {
  const targets = new Map();
  for (const file of readdirSync(join(here, 'targets')))
    targets.set(basename(file, '.cpp'), coreTarget(basename(file, '.cpp')));
  for (const file of readdirSync(join(here, 'page')).filter((each) => each.endsWith('.test.ts'))) {
    targets.set(basename(file, '.test.ts'), pageTarget(basename(file, '.test.ts')));
  }
  return targets;
}

function fail(message) {
  console.error(message);
  process.exit(2);
}

function readArguments(targets) {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      seconds: { type: 'string' },
      minutes: { type: 'string' },
      seed: { type: 'string' },
      'one-at-a-time': { type: 'boolean' },
    },
  });
  const seconds = values.minutes === undefined ? Number(values.seconds ?? 10) : 60 * Number(values.minutes);
  if (!(seconds >= 1)) fail('the time is a number of at least one second');
  // libFuzzer takes 0 for none.
  const seed = Number(values.seed ?? randomInt(1, 2 ** 31));
  if (!Number.isInteger(seed) || seed < 1 || seed >= 2 ** 31) fail('the seed is a whole number from 1 to 2147483647');
  const unknown = positionals.find((name) => !targets.has(name));
  if (unknown !== undefined) fail(`there is no target ${unknown}; known are ${[...targets.keys()].join(', ')}`);
  return {
    seconds: Math.round(seconds),
    seed,
    names: positionals.length > 0 ? positionals : [...targets.keys()],
    lanes: values['one-at-a-time'] ? 1 : 2,
  };
}

const widths = [16, 12, 10, 10, 9];
const row = (cells) =>
  cells.map((cell, i) => (i === 0 ? String(cell).padEnd(widths[i]) : String(cell ?? '').padStart(widths[i]))).join('');

async function main() {
  const targets = findTargets();
  const { seconds, seed, names, lanes } = readArguments(targets);
  const waiting = [...names];
  const failures = [];
  console.log(`seed ${seed}`);
  console.log(row(['target', 'executions', 'coverage', 'features', 'found']));
  const work = async () => {
    for (let name = waiting.shift(); name !== undefined; name = waiting.shift()) {
      const { executions, coverage, features, failed, log } = await targets.get(name)(seconds, seed);
      console.log(row([name, executions, coverage, features, failed ? 'a fault' : 'nothing']));
      if (failed) failures.push({ name, log });
    }
  };
  await Promise.all(Array.from({ length: lanes }, work));
  for (const { name, log } of failures) {
    console.error(`\n${name}: ${log} ends with\n${readFileSync(log, 'utf8').split('\n').slice(-60).join('\n')}`);
  }
  process.exit(failures.length > 0 ? 1 : 0);
}

await main();
