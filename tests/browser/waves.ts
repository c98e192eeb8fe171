/** A surface of a million triangles that is dropped on the page. */

declare global {
  interface Window {
    waves: File;
    /** What reading said it was doing, in order. */
    steps: string[];
  }
}

/** Runs in the page, where 50 MB need not be sent. Binary STL: each triangle has corners of its own, which are found to be one. */
export function makeWaves() {
  // Squares along a side.
  const side = 708;
  const bytes = new DataView(new ArrayBuffer(84 + 100 * side * side));
  bytes.setUint32(80, 2 * side * side, true);
  let at = 84;
  const add = (...corners: [number, number][]) => {
    corners.forEach(([i, j], k) =>
      [i, j, 50 * Math.sin(i / 50) * Math.cos(j / 67)].forEach((x, axis) =>
        bytes.setFloat32(at + 12 * (k + 1) + 4 * axis, x, true),
      ),
    );
    at += 50;
  };
  for (let i = 0; i < side; i++)
    for (let j = 0; j < side; j++) {
      add([i, j], [i + 1, j], [i + 1, j + 1]);
      add([i, j], [i + 1, j + 1], [i, j + 1]);
    }
  window.waves = new File([bytes], 'waves.stl');
}

/** Likewise. */
export function dropWaves() {
  window.steps = [];
  new MutationObserver(() => {
    const step = document.querySelector('label[for=file-progress]')?.textContent;
    if (step && step !== window.steps.at(-1)) window.steps.push(step);
  }).observe(document.body, { subtree: true, childList: true, characterData: true });
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(window.waves);
  document
    .getElementById('view')!
    .dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
}
