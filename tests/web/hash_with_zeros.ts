/** Links that are small and inflate to much more. */
import { constants, deflateRawSync } from 'node:zlib';

/** The hash of a link to the scene that `header` describes, with so many bytes in the place of positions, a multiple of a megabyte. */
export function hashWithZeros(header: object, bytes: number): string {
  const json = Buffer.from(JSON.stringify(header));
  const length = Buffer.alloc(4);
  length.writeUInt32LE(json.length);
  // After a full flush what comes next stands by itself, so that a piece deflated once may follow itself.
  const flushed = (content: Uint8Array) => deflateRawSync(content, { level: 9, finishFlush: constants.Z_FULL_FLUSH });
  const pieces = Array<Buffer>(bytes / 1e6).fill(flushed(new Uint8Array(1e6)));
  return `#v1=${Buffer.concat([flushed(Buffer.concat([length, json])), ...pieces, deflateRawSync('')]).toString('base64url')}`;
}
