import { words } from './language/language';

/** A part of the page that comes when it is first wanted. Fails with a sentence for the user; the next try may have better
 *  luck. */
export function part<T>(load: () => Promise<T>): () => Promise<T> {
  let loading: Promise<T> | null = null;
  return () =>
    (loading ??= load().catch((cause: unknown) => {
      loading = null;
      throw new Error(words.page.partMissing, { cause });
    }));
}
