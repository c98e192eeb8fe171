/** Has the browser keep the page for when there is no network; see service_worker.ts. */

/** @param offer tells the visitor that another version is there; its argument goes over to it.
 *  @param reload loads the page again without a loss. */
export async function keepOffline(offer: (accept: () => void) => void, reload: () => void): Promise<void> {
  if (!import.meta.env.PROD || !isSecureContext || !('serviceWorker' in navigator)) return;
  const registration = await register();
  if (registration === undefined) return;
  const known = new Set<ServiceWorker>();
  const offerWhenReady = (worker: ServiceWorker | null): void => {
    // The first version of all is no news. Whether one was there before it is asked while it is young: in Firefox the first
    // may have taken the page over by the time it says that it is ready.
    if (worker === null || registration.active === null || known.has(worker)) return;
    known.add(worker);
    const look = (): void => {
      if (worker.state === 'installed') offer(() => goOverTo(worker, reload));
    };
    worker.addEventListener('statechange', look);
    look();
  };
  offerWhenReady(registration.waiting);
  offerWhenReady(registration.installing);
  registration.addEventListener('updatefound', () => offerWhenReady(registration.installing));
}

/** A browser may refuse, in a private window for one; where it keeps nothing, asking alone may fail. The page works without. */
async function register(): Promise<ServiceWorkerRegistration | undefined> {
  try {
    return await navigator.serviceWorker.register('./service_worker.js');
  } catch {
    return undefined;
  }
}

function goOverTo(worker: ServiceWorker, reload: () => void): void {
  navigator.serviceWorker.addEventListener('controllerchange', reload, { once: true });
  worker.postMessage('activate');
}
