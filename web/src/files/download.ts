/** How long a browser may take to fetch what it saves: on iPhones it asks first. */
const KEPT_MS = 60_000;

/** Has the browser save something as a file. */
export function download(name: string, content: BlobPart, type: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), KEPT_MS);
}
