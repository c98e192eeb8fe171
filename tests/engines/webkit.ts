/** WebKitGTK, by the WebDriver protocol (https://www.w3.org/TR/webdriver2/): WebKitWebDriver drives a MiniBrowser. */
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import type { Driver, Engine } from './driver';
import { end, newFolder, startDisplay } from './temporary';

const BROWSERS = ['x86_64', 'aarch64'].map((cpu) => `/usr/lib/${cpu}-linux-gnu/webkit2gtk-4.1/MiniBrowser`);
const PATIENCE = 60_000;

/** The private characters that stand for keys, from the protocol. */
const KEYS: Record<string, string> = {
  Control: '\uE009',
  Shift: '\uE008',
  Alt: '\uE00A',
  Meta: '\uE03D',
  Enter: '\uE007',
  Escape: '\uE00C',
  Tab: '\uE004',
  Backspace: '\uE003',
  Delete: '\uE017',
  Home: '\uE011',
  End: '\uE010',
  PageUp: '\uE00E',
  PageDown: '\uE00F',
  ArrowLeft: '\uE012',
  ArrowUp: '\uE013',
  ArrowRight: '\uE014',
  ArrowDown: '\uE015',
};

export async function startWebKit(): Promise<Engine> {
  const binary = [process.env['MINIBROWSER'] ?? '', ...BROWSERS].find(existsSync);
  if (binary === undefined) throw new Error('no MiniBrowser of WebKitGTK: install it or set MINIBROWSER to its path');
  const display = await startDisplay();
  const home = newFolder();
  const downloads = join(home.path, 'Downloads');
  mkdirSync(downloads);
  mkdirSync(join(home.path, '.config/gtk-3.0'), { recursive: true });
  // What moves is drawn in software, which takes longer than the tests themselves: less of it, as in the other engines.
  writeFileSync(join(home.path, '.config/gtk-3.0/settings.ini'), '[Settings]\ngtk-enable-animations=0\n');
  writeFileSync(join(home.path, '.config/user-dirs.dirs'), 'XDG_DOWNLOAD_DIR="$HOME/Downloads"\n');
  const env = {
    // Compiling WebAssembly as well as it can takes longer than the tests run it. Set from outside, it does (run_monkey).
    JSC_useOMGJIT: '0',
    ...process.env,
    HOME: home.path,
    XDG_CONFIG_HOME: '',
    DISPLAY: display.name,
    // Under this locale the language of its browser is called C.
    LC_ALL: 'C.UTF-8',
  };

  /** A browser that does not come up is started once more: no page has been shown in it yet. */
  async function newWindow(): Promise<Driver> {
    return startWindow().catch(startWindow);
  }

  /** A driver drives one window. */
  async function startWindow(): Promise<Driver> {
    const port = await freePort();
    const server = spawn('WebKitWebDriver', ['-p', String(port)], { stdio: 'ignore', env });
    try {
      return await beginSession(`http://127.0.0.1:${port}`, () => end(server));
    } catch (error) {
      await end(server);
      throw error;
    }
  }

  async function beginSession(address: string, stop: () => Promise<void>): Promise<Driver> {
    await untilItAnswers(address);
    const options = { binary, args: ['--automation'] };
    const capabilities = { browserName: 'MiniBrowser', pageLoadStrategy: 'none', 'webkitgtk:browserOptions': options };
    const { sessionId } = (await call(address, 'POST', '/session', {
      capabilities: { alwaysMatch: capabilities },
    })) as {
      sessionId: string;
    };
    const window = new WebKitWindow(`${address}/session/${sessionId}`, downloads, stop);
    await window.begin();
    return window;
  }

  async function close(): Promise<void> {
    await display.stop();
    home.remove();
  }

  return { name: 'webkit', newWindow, close };
}

class WebKitWindow implements Driver {
  readonly #session: string;
  readonly downloads: string;
  readonly #complaints: string[] = [];
  #pointer = { x: 0, y: 0 };
  readonly #end: () => Promise<void>;

  constructor(session: string, downloads: string, end: () => Promise<void>) {
    this.#session = session;
    this.downloads = downloads;
    this.#end = end;
  }

  async begin(): Promise<void> {
    await this.#post('/timeouts', { script: PATIENCE });
    await this.#listen();
    await this.resize(1280, 800);
  }

  async goto(url: string): Promise<void> {
    await this.#leave(() => this.#post('/url', { url }));
  }

  async reload(): Promise<void> {
    await this.#leave(() => this.#post('/refresh'));
  }

  async evaluate(expression: string): Promise<unknown> {
    const script = `const done = arguments[0];
      Promise.resolve().then(() => (${expression})).then((value) => done({ value }), (error) => done({ error: error + '\\n' + error?.stack }));`;
    const answer = (await this.#post('/execute/async', { script, args: [] })) as { value?: unknown; error?: string };
    if (answer.error !== undefined) throw new Error(answer.error);
    return answer.value;
  }

  movePointer(x: number, y: number): Promise<void> {
    this.#pointer = { x: Math.round(x), y: Math.round(y) };
    return this.#act('pointer', { type: 'pointerMove', ...this.#pointer, duration: 0 });
  }

  pressButton(): Promise<void> {
    return this.#act('pointer', { type: 'pointerDown', button: 0 });
  }

  releaseButton(): Promise<void> {
    return this.#act('pointer', { type: 'pointerUp', button: 0 });
  }

  turnWheel(dy: number): Promise<void> {
    return this.#act('wheel', { type: 'scroll', ...this.#pointer, deltaX: 0, deltaY: Math.round(dy) });
  }

  pressKey(key: string): Promise<void> {
    return this.#act('key', { type: 'keyDown', value: KEYS[key] ?? key });
  }

  releaseKey(key: string): Promise<void> {
    return this.#act('key', { type: 'keyUp', value: KEYS[key] ?? key });
  }

  /** The window has bars of its own beside the page. */
  async resize(width: number, height: number): Promise<void> {
    const inside = async () => (await this.evaluate('[innerWidth, innerHeight]')) as [number, number];
    const outside = (await call(this.#session, 'GET', '/window/rect')) as { width: number; height: number };
    const [innerWidth, innerHeight] = await inside();
    await this.#post('/window/rect', {
      x: 0,
      y: 0,
      width: width + outside.width - innerWidth,
      height: height + outside.height - innerHeight,
    });
    for (let i = 0; i < 20 && String(await inside()) !== String([width, height]); ++i) await sleep(50);
  }

  async screenshot(): Promise<Buffer> {
    return Buffer.from(String(await call(this.#session, 'GET', '/screenshot')), 'base64');
  }

  async complaints(): Promise<string[]> {
    return [...this.#complaints, ...((await this.evaluate('window.complaints ?? []')) as string[])];
  }

  async close(): Promise<void> {
    await call(this.#session, 'DELETE', '');
    await this.#end();
  }

  /** The protocol has no console, so each document is listened to from within, from as early on as can be. */
  async #leave(go: () => Promise<unknown>): Promise<void> {
    this.#complaints.splice(0, Infinity, ...(await this.complaints()));
    await go();
    const until = Date.now() + PATIENCE;
    while (!(await this.#listen())) {
      if (Date.now() > until) throw new Error('no other document came');
      await sleep(10);
    }
  }

  /** False: this document was listened to already. */
  async #listen(): Promise<boolean> {
    return (await this.evaluate(`(${listen})()`).catch(() => false)) === true;
  }

  async #act(type: 'pointer' | 'key' | 'wheel', action: object): Promise<void> {
    const parameters = type === 'pointer' ? { parameters: { pointerType: 'mouse' } } : {};
    await this.#post('/actions', { actions: [{ type, id: type, ...parameters, actions: [action] }] });
  }

  #post(path: string, body: object = {}): Promise<unknown> {
    return call(this.#session, 'POST', path, body);
  }
}

declare global {
  interface Window {
    complaints?: string[];
  }
}

/** Runs in the page. */
function listen(): boolean {
  if (window.complaints !== undefined) return false;
  const complaints: string[] = (window.complaints = []);
  for (const kind of ['error', 'warn'] as const) {
    const before = console[kind];
    console[kind] = (...given: unknown[]) => {
      complaints.push(given.map(String).join(' '));
      before(...given);
    };
  }
  const missing = (element: unknown) => `could not be loaded: ${(element as HTMLImageElement | null)?.outerHTML}`;
  addEventListener('error', (event) => complaints.push(event.message ?? missing(event.target)), true);
  addEventListener('unhandledrejection', ({ reason }) => complaints.push(String(reason?.stack ?? reason)));
  addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) =>
    complaints.push(`${violatedDirective}: ${blockedURI}`),
  );
  return true;
}

async function call(address: string, method: string, path: string, body?: object): Promise<unknown> {
  // A driver that never answers is an error that names the command. Scripts give up earlier by themselves.
  const signal = AbortSignal.timeout(1.5 * PATIENCE);
  const given = { method, signal, body: body === undefined ? null : JSON.stringify(body) };
  const response = await fetch(address + path, given).catch((error) => {
    throw new Error(`${method} ${path}: ${error}`);
  });
  const { value } = (await response.json()) as { value: unknown };
  if (!response.ok) throw new Error(`${method} ${path}: ${JSON.stringify(value)}`);
  return value;
}

async function freePort(): Promise<number> {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address() as AddressInfo;
  server.close();
  await once(server, 'close');
  return port;
}

async function untilItAnswers(address: string): Promise<void> {
  const until = Date.now() + PATIENCE;
  while (true) {
    try {
      await call(address, 'GET', '/status');
      return;
    } catch (error) {
      if (Date.now() > until) throw error;
      await sleep(50);
    }
  }
}
