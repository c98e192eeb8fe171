/** Bytes as base64 and back. */
import { strFromU8, strToU8 } from 'fflate';

export function toBase64(bytes: Uint8Array): string {
  return btoa(strFromU8(bytes, true));
}

/** Throws if it is none. */
export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  return strToU8(atob(text), true);
}
