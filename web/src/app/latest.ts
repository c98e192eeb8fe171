/** Of things that are wanted faster than they can be done, only the last. */
import { isCancelled } from '../worker/client';

/** Does what is wanted, one at a time, and of what is wanted meanwhile only the last; nothing more once one is cancelled. What it
 *  returns resolves when nothing is left to be done. */
export function latestOnly<Wanted>(
  doing: (wanted: Wanted) => Promise<void>,
  failed: (error: unknown) => void,
): (wanted: Wanted) => Promise<void> {
  let next: [Wanted] | null = null;
  let underWay: Promise<void> | null = null;

  async function goOn(): Promise<void> {
    while (next !== null) {
      const [wanted] = next;
      next = null;
      try {
        await doing(wanted);
      } catch (error) {
        if (isCancelled(error)) next = null;
        failed(error);
      }
    }
    underWay = null;
  }

  return (wanted) => {
    next = [wanted];
    return (underWay ??= goOn());
  };
}
