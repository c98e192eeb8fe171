import { words } from './language/language';
import { Failure } from './failure';

/** A part of the page that comes when it is first wanted. Fails with a sentence for the user; the next try may have better
 *  luck. */
export function lazy<T>(load: () => Promise<T>): () => Promise<T> {
  let loading: Promise<T> | null = null;
  return () =>
    (loading ??= load().catch((cause: unknown) => {
      loading = null;
      throw new Failure('not_loaded', words.page.partMissing, { cause });
    }));
}
