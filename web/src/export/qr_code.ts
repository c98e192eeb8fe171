/** A QR code as one path, a square of side 1 for each dark module. */
import { encode } from 'uqr';

/** Most characters of a link that fit into the largest code. */
export const QR_CAPACITY = 2953;
/** Width of the quiet zone around the code that the standard demands, in modules. */
const QUIET_ZONE = 4;

export interface QrCode {
  /** Modules on each side. */
  size: number;
  path: string;
}

export function qrCode(text: string): QrCode {
  const { size, data } = encode(text, { ecc: 'L', border: QUIET_ZONE });
  const path = data.flatMap((row, y) => row.flatMap((dark, x) => (dark ? [`M${x} ${y}h1v1h-1z`] : []))).join('');
  return { size, path };
}
