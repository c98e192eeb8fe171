/** A hash that is no scene. `code`: "bad_link", damaged; "foreign_link", not ours or of another version. */
export class LinkError extends Error {
  constructor(
    readonly code: 'bad_link' | 'foreign_link',
    message: string,
  ) {
    super(message);
  }
}
