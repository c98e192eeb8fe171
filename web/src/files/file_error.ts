/** A file that could not be read. `code` as in core/base/error.h. */
export class FileError extends Error {
  constructor(
    readonly code: string,
    message: string,
  ) {
    super(message);
  }
}
