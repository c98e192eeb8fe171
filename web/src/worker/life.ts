/**
 * How a page learns that a worker has died. Browsers end workers without an event, e.g. when memory runs short. A worker
 * therefore holds a Web Lock with its own name: when the page obtains that lock, the worker is gone. Without locks (in an
 * insecure context or a sandboxed frame) only a timeout tells.
 */

export function newName(): string {
  return `chebnet ${Date.now()} ${Math.random()}`;
}

/** In the worker: resolves once its lock is held, or cannot be. It must not post before. */
export function holdOwnLock(): Promise<void> {
  const { locks } = navigator;
  if (locks === undefined) return Promise.resolve();
  return new Promise((held) => {
    const forLife = (): Promise<never> => {
      held();
      return new Promise(() => {});
    };
    locks.request(self.name, forLife).catch(() => held());
  });
}

/** In the page: calls `ended` when the worker of that name, which has posted already, is gone. */
export function whenEnded(worker: Worker, name: string, ended: () => void): void {
  const watch = (): void => void navigator.locks?.request(name, ended).catch(() => {});
  worker.addEventListener('message', watch, { once: true });
}
