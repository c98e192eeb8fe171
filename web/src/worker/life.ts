/**
 * How a page learns that a worker is no more. Browsers end workers without a word, when memory runs short for one. A worker
 * therefore holds a lock with its own name as long as it lives: whoever else gets that lock knows that it does not. Where
 * there are no locks (a page that is no secure context, a sandboxed frame) only its silence tells.
 */

export function newName(): string {
  return `chebnet ${Date.now()} ${Math.random()}`;
}

/** In the worker: resolves once its lock is held, or cannot be. It is to say nothing before. */
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

/** In the page: `ended` is called when the worker of that name, which is to have said something, is no more. */
export function whenEnded(worker: Worker, name: string, ended: () => void): void {
  const watch = (): void => void navigator.locks?.request(name, ended).catch(() => {});
  worker.addEventListener('message', watch, { once: true });
}
