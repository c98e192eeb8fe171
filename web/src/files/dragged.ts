/** What is dragged, or null where the browser keeps it to itself: Firefox, text out of a field. */
export function dragged({ dataTransfer }: DragEvent): DataTransfer | null {
  try {
    return dataTransfer?.types ? dataTransfer : null;
  } catch {
    return null;
  }
}
