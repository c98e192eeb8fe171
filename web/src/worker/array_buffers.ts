/** The buffers of an object's arrays, to be transferred in a message: cloning large ones from it would block the page. */
export function arrayBuffers(object: object): ArrayBuffer[] {
  return Object.values(object).flatMap((value) => (ArrayBuffer.isView(value) ? [value.buffer as ArrayBuffer] : []));
}
