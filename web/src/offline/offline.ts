/** Registers the service worker, by which the page works without a network. */

/** @param offer tells the visitor that another version is there; its argument goes over to it.
 *  @param reload loads the page again without a loss. */
export async function keepOffline(offer: (accept: () => void) => void, reload: () => void): Promise<void> {
  if (!import.meta.env.PROD || !isSecureContext || !('serviceWorker' in navigator)) return;
  const registration = await register();
  if (registration === undefined) return;
  const known = new Set<ServiceWorker>();
  const offerWhenReady = (worker: ServiceWorker | null): void => {
    // The very first version is not announced. Whether there was one before is asked early: in Firefox the first may control
    // the page by the time it reports that it is installed.
    if (worker === null || registration.active === null || known.has(worker)) return;
    known.add(worker);
    const look = (): void => {
      // Until it is accepted another version may have come in its place.
      if (worker.state === 'installed')
        offer(() => goOverTo(registration.waiting ?? registration.active ?? worker, reload));
    };
    worker.addEventListener('statechange', look);
    look();
  };
  offerWhenReady(registration.waiting);
  offerWhenReady(registration.installing);
  registration.addEventListener('updatefound', () => offerWhenReady(registration.installing));
}

/** A browser may refuse, e.g. in a private window, or throw when storage is disabled. The page works without. */
async function register(): Promise<ServiceWorkerRegistration | undefined> {
  try {
    return await navigator.serviceWorker.register('./service_worker.js');
  } catch {
    return undefined;
  }
}

/** Other windows may have gone over before: then the worker is active already, and no event comes. */
function goOverTo(worker: ServiceWorker, reload: () => void): void {
  const reloadOnceActive = (): void => {
    if (worker.state !== 'activated') return;
    worker.removeEventListener('statechange', reloadOnceActive);
    reload();
  };
  worker.addEventListener('statechange', reloadOnceActive);
  worker.postMessage('activate');
  reloadOnceActive();
}
