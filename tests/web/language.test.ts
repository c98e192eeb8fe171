/** Every language says everything, in its own words. */
import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { messageOf } from '../../web/src/failure';
import { en } from '../../web/src/language/en';
import { dialogs as dialogsInEnglish } from '../../web/src/language/en/dialogs';
import { experiments as experimentsInEnglish } from '../../web/src/language/en/experiments';
import { learn as learnInEnglish } from '../../web/src/language/en/learn';
import { lesson as lessonInEnglish } from '../../web/src/language/en/lesson';
import { panels as panelsInEnglish } from '../../web/src/language/en/panels';
import { scripts as scriptsInEnglish } from '../../web/src/language/en/scripts';
import { zh } from '../../web/src/language/zh';
import * as ZH_CORE from '../../web/src/language/zh/core';
import { DEFECTS, dialogs as dialogsInChinese } from '../../web/src/language/zh/dialogs';
import { experiments as experimentsInChinese } from '../../web/src/language/zh/experiments';
import { learn as learnInChinese } from '../../web/src/language/zh/learn';
import { lesson as lessonInChinese } from '../../web/src/language/zh/lesson';
import * as ZH_PANELS from '../../web/src/language/zh/panels';
import { scripts as scriptsInChinese } from '../../web/src/language/zh/scripts';
import { load, ROOT } from '../wasm/load';

const { CORE_ERRORS, PARAMETERS } = ZH_CORE;
const { FORMATS, panels: panelsInChinese, SHAPES } = ZH_PANELS;

/** Every text and every function, by the names that lead to it. */
function leaves(words: object, path = ''): Map<string, unknown> {
  const found = new Map<string, unknown>();
  for (const [name, value] of Object.entries(words)) {
    if (typeof value === 'object') leaves(value, `${path}${name}.`).forEach((leaf, each) => found.set(each, leaf));
    else found.set(path + name, value);
  }
  return found;
}

const english = leaves({
  ...en,
  dialogs: dialogsInEnglish,
  learn: learnInEnglish,
  lesson: lessonInEnglish,
  panels: panelsInEnglish,
  experiments: experimentsInEnglish,
  scripts: scriptsInEnglish,
});
const chinese = leaves({
  ...zh,
  dialogs: dialogsInChinese,
  learn: learnInChinese,
  lesson: lessonInChinese,
  panels: panelsInChinese,
  experiments: experimentsInChinese,
  scripts: scriptsInChinese,
});

/** What stays as it is in Chinese. */
const SAME: string[] = [];

test('Chinese has the same names as English', () => {
  expect([...chinese.keys()]).toEqual([...english.keys()]);
});

test('a text is a text in both, not empty and not the same; a function takes the same', () => {
  const faults = [...english].filter(([name, text]) => {
    const translated = chinese.get(name);
    if (typeof text === 'function') return typeof translated !== 'function' || translated.length !== text.length;
    if (typeof text !== 'string' || typeof translated !== 'string') return true;
    return text.trim() === '' || translated.trim() === '' || (text === translated && !SAME.includes(name));
  });
  expect(faults).toEqual([]);
});

const HAN = /\p{Script=Han}/u;

describe('what the core says has Chinese words:', () => {
  const byName = (table: { name: string }[]) => table.map(({ name }) => name).sort();
  const names = (table: object) => Object.keys(table).sort();

  test('its tables', async () => {
    const core = await load();
    const tables = {
      shapes: core.shapes(),
      methods: core.methods(),
      initialisations: core.initialisations(),
      formats: core.formats(),
      options: core.options(),
    };
    const { about, aboutParameter } = panelsInChinese.shape;
    const shapes = zh.core.tables(tables).shapes.map((shape) => ({
      ...shape,
      sentence: about(shape),
      parameters: shape.parameters.map((each) => ({ ...each, sentence: aboutParameter(shape.name, each) })),
    }));
    const formats = tables.formats.map((each) => ({ ...each, sentence: panelsInChinese.exports.about(each) }));
    const { option, aboutMethod, aboutInitialisation } = panelsInChinese.solver;
    const methods = tables.methods.map((each) => ({ ...each, sentence: aboutMethod(each) }));
    const initialisations = tables.initialisations.map((each) => ({ ...each, sentence: aboutInitialisation(each) }));
    const options = tables.options.map((each) => ({ ...each, sentence: option(each) }));
    for (const { SHAPES: rows } of [ZH_CORE, ZH_PANELS]) expect(names(rows)).toEqual(byName(shapes));
    for (const { name, parameters } of shapes) expect(names(SHAPES[name]!.parameters)).toEqual(byName(parameters));
    for (const { METHODS: rows } of [ZH_CORE, ZH_PANELS]) expect(names(rows)).toEqual(byName(methods));
    for (const { INITIALISATIONS: rows } of [ZH_CORE, ZH_PANELS]) expect(names(rows)).toEqual(byName(initialisations));
    expect(names(FORMATS)).toEqual(byName(formats));
    expect(names(ZH_PANELS.OPTIONS)).toEqual(byName(options));
    const stages = tables.methods.flatMap((each) => each.stages).filter((stage) => stage !== '');
    expect(names(ZH_PANELS.STAGES)).toEqual([...new Set(stages)].sort());
    for (const [{ core: said }, all] of [
      [en, tables.shapes],
      [zh, shapes],
    ] as const)
      for (const { name, title } of all) expect(said.shapes()[name] ?? name).toBe(title.toLowerCase());
    for (const { title, sentence } of shapes) expect([title, sentence].every((text) => HAN.test(text))).toBe(true);
    const all = [
      ...shapes.flatMap(({ parameters }) => parameters),
      ...methods,
      ...initialisations,
      ...formats,
      ...options,
    ];
    for (const { sentence } of all) expect(sentence).toMatch(HAN);
  });

  test('the names of parameters and options, defects, and no others', async () => {
    const core = await load();
    const parameters = core.shapes().flatMap((shape) => byName(shape.parameters));
    expect(names(PARAMETERS)).toEqual([...new Set(parameters)].sort());
    expect(names(ZH_PANELS.OPTION_NAMES)).toEqual(byName(core.options()).sort());
    expect(names(DEFECTS)).toEqual([...core.defects()].sort());
  });

  test('the codes of its errors', () => {
    const header = readFileSync(new URL('core/base/error.h', ROOT), 'utf8');
    const codes = [...header.matchAll(/^ {4}(\w+), +\/\/\/</gm)].map(([, code]) => code!);
    expect(codes.length).toBeGreaterThan(9);
    expect(names(CORE_ERRORS)).toEqual([...codes, 'crashed', 'disposed', 'internal'].sort());
  });
});

test('an error of the core keeps what the core says of it', () => {
  expect(en.core.failure('bad_syntax', 'a.obj:3: no number')).toBe('a.obj:3: no number');
  expect(zh.core.failure('bad_syntax', 'a.obj:3: no number')).toMatch(/^\p{Script=Han}+（a\.obj:3: no number）$/u);
  expect(zh.core.failure('a_new_code', 'Something else.')).toBe('Something else.');
});

function refusalOf(act: () => unknown): string {
  try {
    act();
  } catch (error) {
    return messageOf(error);
  }
  throw new Error('nothing was refused');
}

test('what the core says of a file that it cannot read is said in Chinese, too', async () => {
  const core = await load();
  for (const [name, content] of [
    ['empty.obj', '# nothing'],
    ['word.obj', 'v 0 0 0\nv 1 zero 0\n'],
    ['face.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n'],
    ['none.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n'],
    ['flat.obj', 'v 0 0\nf 1 1 1\n'],
    ['face.off', 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n'],
    ['short.off', 'OFF\n3 1 0\n0 0 0\n'],
    ['word.ply', 'ply\nformat ascii 1.0\nnonsense\n'],
    ['word.stl', 'solid part\nnonsense\n'],
    ['drawing.obj', '<svg/>'],
    ['page.obj', '<html>'],
    ['net.obj', 'PK\x03\x04'],
    ['text.txt', 'x'],
    ['edge.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n'],
  ] as const) {
    const said = refusalOf(() => core.openMesh(core.readMesh(new TextEncoder().encode(content), name)));
    const reason = dialogsInChinese.file.reason(said);
    expect(reason, said).toMatch(/\p{Script=Han}/u);
    // Names of files and formats, and what is quoted.
    expect(reason.replace(/^\S+: |“.*”/g, '')).not.toMatch(/[a-z]{2}/);
    expect(dialogsInEnglish.file.reason(said)).toBe(said);
  }
  expect(dialogsInChinese.file.reason('a.obj: something new')).toBe('a.obj: something new');
});

test('a finding is told with its examples', () => {
  const finding = {
    defect: 'duplicate_vertices',
    repaired: true,
    count: 1200,
    examples: [4, 7],
    sentence: 'as the core says',
  } as const;
  expect(dialogsInEnglish.finding({ ...finding, examples: [4, 7] })).toBe('as the core says');
  expect(dialogsInChinese.finding({ ...finding, examples: [4, 7] })).toMatch(/^1,200 .*：4、7…$/);
});

test('names of the core are made readable', () => {
  expect(panelsInEnglish.solver.optionName('switch_deviation')).toBe('Switch deviation');
  expect(panelsInEnglish.solver.optionName('p_end')).toBe('p end');
});

test('a message becomes a sentence, a name of a file stays as it is', () => {
  expect(en.core.sentence('no net is open')).toBe('No net is open.');
  expect(en.core.sentence('net.obj: line 3 is no face')).toBe('net.obj: line 3 is no face.');
  expect(zh.core.sentence('没有打开的网')).toBe('没有打开的网。');
  expect(zh.core.sentence('链接已损坏。')).toBe('链接已损坏。');
});

test('no text stands outside of language/', () => {
  const SOURCES = new URL('web/src/', ROOT);
  /** They speak English to programs, with a code by which the page says it in the visitor's language. */
  const FOR_PROGRAMS =
    /^(worker|language)\/|^files\/(file_importer|file_worker|model|gltf_mesh|rhino_mesh)\.ts$|^embed\/(arguments|host)\.ts$|^export\/(pattern_svg|frame_code)\.ts$|^document\/numbers\.ts$/;
  /** What a literal stands behind that nobody reads. */
  const UNREAD = /(new Error\(|'internal', |matchMedia\(|class: |[!=]== |\/\* glsl \*\/ )$/;
  const ALLOWED = [
    'English',
    '(prefers-color-scheme: dark)',
    'linear-gradient(to right, …)',
    // Keys.
    'Backspace',
    'Delete',
    'Esc',
    'Home',
    'Enter',
  ];
  const COMMENT_OR_LITERAL = /\/\*[\s\S]*?\*\/|\/\/.*|'(?:[^'\\\n]|\\.)*'|`(?:[^`\\]|\\.)*`/g;
  /** Two words side by side, or one with a capital. */
  const TEXT = /[A-Za-z]{2,}[,:;]? [A-Za-z]{2,}|^[A-Z][a-z]+…?$/;

  const files = readdirSync(SOURCES, { recursive: true, encoding: 'utf8' });
  const found = files
    .filter((file) => file.endsWith('.ts') && !FOR_PROGRAMS.test(file))
    .flatMap((file) => {
      const source = readFileSync(new URL(file, SOURCES), 'utf8');
      return [...source.matchAll(COMMENT_OR_LITERAL)].flatMap(({ 0: each, index }) => {
        const text = each.slice(1, -1).replace(/\$\{[^}]*\}/g, '…');
        const shown = !/^(\/|`\s*<)/.test(each) && !UNREAD.test(source.slice(0, index)); // no comment, no markup
        return shown && TEXT.test(text) && !ALLOWED.includes(text) ? [`${file}: ${text}`] : [];
      });
    });
  expect(found).toEqual([]);
});

test('the installed page is the same in both languages but for its words', () => {
  const manifest = (name: string): object => JSON.parse(readFileSync(new URL(`web/public/${name}`, ROOT), 'utf8'));
  const { name, description, ...others } = manifest('manifest.webmanifest') as Record<string, unknown>;
  const inChinese = manifest('manifest.zh.webmanifest') as Record<string, unknown>;
  expect(inChinese).toMatchObject({
    ...others,
    lang: zh.locale,
    name: zh.page.title,
    description: expect.stringMatching(HAN),
  });
  expect([name, description]).toEqual([en.page.title, expect.any(String)]);
});

test('in Chinese, how many are selected has no blank after its colon', () => {
  const { narrator, changes } = panelsInChinese;
  expect(narrator.selected(changes.several(5))).toBe('已选中：5 个手柄');
});
