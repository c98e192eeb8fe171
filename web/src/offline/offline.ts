/** Has the browser keep the page for when there is no network; see service_worker.ts. */

/** @param offer tells the visitor that another version is there; its argument goes over to it. */
export async function keepOffline(offer: (accept: () => void) => void): Promise<void> {
  if (!import.meta.env.PROD || !isSecureContext || !('serviceWorker' in navigator)) return;
  const registration = await navigator.serviceWorker.register('./service_worker.js').catch(() => undefined);
  // A browser may refuse, in a private window for one. The page works without.
  if (registration === undefined) return;
  const known = new Set<ServiceWorker>();
  const offerWhenReady = (worker: ServiceWorker | null): void => {
    // The first version of all is no news. Whether one was there before it is asked while it is young: in Firefox the first
    // may have taken the page over by the time it says that it is ready.
    if (worker === null || registration.active === null || known.has(worker)) return;
    known.add(worker);
    const look = (): void => {
      if (worker.state === 'installed') offer(() => goOverTo(worker));
    };
    worker.addEventListener('statechange', look);
    look();
  };
  offerWhenReady(registration.waiting);
  offerWhenReady(registration.installing);
  registration.addEventListener('updatefound', () => offerWhenReady(registration.installing));
}

function goOverTo(worker: ServiceWorker): void {
  navigator.serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
  worker.postMessage('activate');
}
