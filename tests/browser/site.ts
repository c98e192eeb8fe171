/** The built page in a real browser: a server for it, the browser, and an eye on everything it complains about. */
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { chromium } from 'playwright-core';
import type { Scripting } from '../../web/src/scripting';

export const DIST = fileURLToPath(new URL('../../web/dist', import.meta.url));

const TYPES: Record<string, string> = {
  '.css': 'text/css',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
};

/** No eval, nothing from elsewhere, nothing inline but what the page admits by its hash: in the page and, where its meta
 *  element has no say, in the worker. */
const policy = (hash: string) =>
  [
    "default-src 'none'",
    `script-src 'self' 'wasm-unsafe-eval' ${hash}`,
    "worker-src 'self'",
    "connect-src 'self'",
    "img-src 'self'",
    "style-src 'self'",
    "manifest-src 'self'",
    "frame-src 'self'",
  ].join('; ');

/** Serves the built page below a folder, as any host of static files might. `root` may change. */
export async function serve(root: () => string): Promise<{ address: string; served: string[]; close(): void }> {
  const served: string[] = [];
  const [hash] = /'sha256-[^']*'/.exec(await readFile(join(DIST, 'index.html'), 'utf8'))!;
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url ?? '/', 'http://host').pathname.replace(/^\/some\/folder\/?/, '/'));
    const file = join(root(), path === '/' ? 'index.html' : path);
    served.push(file); // In the order of what is asked for, which reading does not keep.
    readFile(file).then(
      (body) => {
        const type = TYPES[extname(file)] ?? 'application/octet-stream';
        response.writeHead(200, { 'content-type': type, 'content-security-policy': policy(hash) }).end(body);
      },
      () => {
        served.splice(served.indexOf(file), 1);
        response.writeHead(404).end();
      },
    );
  });
  await new Promise<void>((done) => server.listen(0, '127.0.0.1', done));
  const { port } = server.address() as AddressInfo;
  return {
    address: `http://127.0.0.1:${port}/some/folder/`,
    served,
    close: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}

export function launch(): Promise<Browser> {
  // The one without windows of its own tests in three quarters of the time.
  const known = ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'];
  const executablePath = [process.env['CHROMIUM'] ?? '', ...known].find(existsSync);
  if (executablePath === undefined) throw new Error('no Chromium: install it or set CHROMIUM to its path');
  return chromium.launch({
    executablePath,
    args: [
      '--no-sandbox',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      // Software puts the page together faster by itself than by playing a graphics card.
      '--disable-gpu-compositing',
    ],
  });
}

/** A quarter of the pixels, which are drawn in software; places are the same. Pictures to look at have them all. */
const deviceScaleFactor = process.env['CHEBNET_SCREENSHOT'] ? 1 : 0.5;

/** As most visitors have it. */
export const MOVING = { reducedMotion: 'no-preference' } as const;

/** What the browser says about drawing in software, and playwright about what newVisit() asks of it. */
const EXPECTED = [/GL Driver Message .* GPU stall due to ReadPixels/, /Service Worker registration blocked/];

/** What nobody waits for any longer: the page was left, or a worker ended. */
const GIVEN_UP = 'net::ERR_ABORTED';

/** Somebody who was never here before. `complaints` collects every error and warning. */
export interface Visit {
  page: Page;
  script: Script;
  complaints: string[];
}

export async function newVisit(browser: Browser, options: BrowserContextOptions): Promise<Visit> {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    deviceScaleFactor,
    permissions: ['clipboard-read', 'clipboard-write'],
    // Downloading the page a second time would disturb what is measured.
    serviceWorkers: 'block',
    // What moves is drawn in software, which takes longer than the tests themselves. Some ask for it: see MOVING.
    reducedMotion: 'reduce',
    ...options,
  });
  const page = await context.newPage();
  const complaints: string[] = [];
  page.on('console', (message) => {
    const serious = ['error', 'warning', 'assert'].includes(message.type());
    if (serious && !EXPECTED.some((each) => each.test(message.text()))) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error.stack ?? error)));
  page.on('requestfailed', (request) => {
    const reason = request.failure()?.errorText;
    if (reason !== GIVEN_UP) complaints.push(`${request.url()}: ${reason}`);
  });
  page.on('response', (response) => {
    if (response.status() >= 400) complaints.push(`${response.url()}: ${response.status()}`);
  });
  page.on('crash', () => complaints.push('the page crashed'));
  return { page, script: new Script(page), complaints };
}

/** `window.chebnet` from outside: each call runs in the page. */
export class Script {
  constructor(readonly page: Page) {}

  async waitForNet() {
    await this.page.waitForFunction(() => window.chebnet !== undefined && window.chebnet.stats().vertices > 0, null, {
      timeout: 15_000,
    });
  }

  open(net: Parameters<Scripting['open']>[0]) {
    return this.page.evaluate((each) => window.chebnet.open(each), net);
  }

  setHandles(handles: Parameters<Scripting['setHandles']>[0]) {
    return this.page.evaluate((each) => window.chebnet.setHandles(each), handles);
  }

  move(vertex: number, target: [number, number, number]) {
    const both = [vertex, target] as const;
    return this.page.evaluate(([v, t]) => window.chebnet.move(v, t), both);
  }

  settled() {
    return this.page.evaluate(() => window.chebnet.settled());
  }

  stats() {
    return this.page.evaluate(() => window.chebnet.stats());
  }

  screenPosition(vertex: number) {
    return this.page.evaluate((v) => window.chebnet.screenPosition(v), vertex);
  }

  async positions() {
    return Float64Array.from(await this.page.evaluate(() => Array.from(window.chebnet.positions())));
  }

  async position(vertex: number): Promise<[number, number, number]> {
    const [x = NaN, y = NaN, z = NaN] = (await this.positions()).subarray(3 * vertex, 3 * vertex + 3);
    return [x, y, z];
  }
}
