/** HTML that shows an address in a frame of another page. */
export function frameCode(address: string): string {
  return `<iframe src="${address.replaceAll('&', '&amp;')}" width="100%" height="480" title="chebnet" allow="fullscreen; clipboard-write"></iframe>`;
}
