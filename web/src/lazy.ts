import { words } from './language/language';
import { Failure } from './failure';

/** Loads a part of the page on the first call. Fails with a sentence for the user; the next call tries again. */
export function lazy<T>(load: () => Promise<T>): () => Promise<T> {
  let loading: Promise<T> | null = null;
  return () =>
    (loading ??= load().catch((cause: unknown) => {
      loading = null;
      throw new Failure('not_loaded', words.page.partMissing, { cause });
    }));
}
