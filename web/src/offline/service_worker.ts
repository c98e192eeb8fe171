/**
 * Keeps the page for when there is no network. A version of the page is downloaded whole, each file checked against its
 * hash, before anything of it is shown; until a visitor wants it, or the last open page is closed, the version before goes on.
 */
export {};
declare const self: ServiceWorkerGlobalScope;

/** What the page consists of, written by web/offline.ts: `now` maps paths to hashes, `later` is kept when first asked for. */
declare const __CONTENTS__: { version: string; now: Record<string, string>; later: string[] };
const { version, now, later } = __CONTENTS__;

const { scope } = self.registration;
/** Prefix of caches: the site may hold other pages, even other copies of this one. */
const MINE = `chebnet ${scope} `;
const CACHE = MINE + version;
const INTEGRITIES = new Map(Object.entries(now).map(([path, integrity]) => [addressOf(path), integrity]));
const LATER = new Set(later.map(addressOf));
/** Stored last: a cache without it is an interrupted download. */
const WHOLE = `${scope}?whole`;

self.addEventListener('install', (event) => event.waitUntil(download()));
self.addEventListener('activate', (event) => event.waitUntil(takeOver()));
self.addEventListener('message', ({ data }) => {
  if (data === 'activate') void self.skipWaiting();
});
self.addEventListener('fetch', (event) => {
  const { method, url } = event.request;
  if (method === 'GET' && url.startsWith(scope)) event.respondWith(answer(event.request));
});

/** The page itself is stored under its folder: some hosts redirect index.html there. */
function addressOf(path: string): string {
  return path === 'index.html' ? scope : scope + path;
}

async function download(): Promise<void> {
  const cache = await caches.open(CACHE);
  try {
    await Promise.all(Object.entries(now).map(([path, integrity]) => keep(cache, addressOf(path), integrity)));
    await cache.put(WHOLE, new Response());
  } catch (error) {
    await caches.delete(CACHE);
    throw error;
  }
}

async function keep(cache: Cache, address: string, integrity: string): Promise<void> {
  const response = await fetch(address, { integrity, cache: 'no-cache' });
  if (!response.ok) throw new Error(`${address}: ${response.status}`);
  // For navigation, browsers refuse a response that was redirected.
  await cache.put(address, response.redirected ? new Response(response.body, response) : response);
}

/** Previous versions stay for pages that are still open with them. */
async function takeOver(): Promise<void> {
  const others = (await caches.keys()).filter((name) => name.startsWith(MINE) && name !== CACHE);
  const areWhole = await Promise.all(others.map(async (name) => (await caches.open(name)).match(WHOLE)));
  // Caches of early versions lack the mark of completeness.
  const before = others.filter((_, i) => areWhole[i]).at(-1) ?? others.at(-1);
  await Promise.all(others.filter((name) => name !== before).map((name) => caches.delete(name)));
  await self.clients.claim();
  // Not waited for: until a worker is active, all that the page asks for waits.
  void keepWhatCameBefore();
}

/** What the page has asked for before this worker could see it: the browser has it still, or is loading it. */
async function keepWhatCameBefore(): Promise<void> {
  const cache = await caches.open(CACHE);
  for (const address of LATER) {
    if (await cache.match(address)) continue;
    const response = await fetch(address, { cache: 'only-if-cached', mode: 'same-origin' }).catch(() => null);
    if (response?.ok) await cache.put(address, response).catch(() => {});
  }
}

/** A corrupt file in the cache would keep the page from starting, and so from ever being updated. */
async function isWhole(response: Response, integrity: string): Promise<boolean> {
  try {
    const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', await response.clone().arrayBuffer()));
    return integrity === `sha256-${btoa(String.fromCharCode(...hash))}`;
  } catch {
    return false;
  }
}

async function answer(request: Request): Promise<Response> {
  const { origin, pathname } = new URL(request.url);
  const address = addressOf((origin + pathname).slice(scope.length));
  const cache = await caches.open(CACHE);
  const integrity = INTEGRITIES.get(address);
  const kept = (await cache.match(address)) ?? (await caches.match(address));
  if (kept && (integrity === undefined || (await isWhole(kept, integrity)))) return kept;
  if (kept && integrity !== undefined) {
    await keep(cache, address, integrity);
    return (await cache.match(address))!;
  }
  const response = await fetch(request);
  // Where there is no room for it, the page has it all the same.
  if (response.ok && LATER.has(address)) await cache.put(address, response.clone()).catch(() => {});
  return response;
}
