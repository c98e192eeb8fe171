/**
 * Errors that the user is told: a code for programs, as in core/base/error.h or named where it is thrown, and a sentence
 * for people. Errors of the core have both, too. They are caught only to add to the sentence or to clean up. All end in
 * App.report(), which shows the sentence, or reject the promise of a script. An error without a code is a fault of the
 * program itself.
 */
export class Failure extends Error {
  constructor(
    readonly code: string,
    message: string,
    options?: ErrorOptions,
  ) {
    super(message, options);
  }
}

/** @param otherwise of an error that has none. */
export function codeOf(error: unknown, otherwise = 'internal'): string {
  return error instanceof Error && 'code' in error ? String(error.code) : otherwise;
}

export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
