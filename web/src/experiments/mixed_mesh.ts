/** A curved sheet whose rows of squares alternate with rows of triangles, as OBJ text: a net that is not all quads, and
 *  whose edges are of many lengths. */

const COLUMNS = 36;
const ROWS = 36;

export function mixedMesh(): string {
  return [...vertices(), ...faces()].join('\n');
}

function* vertices(): Generator<string> {
  let y = 0;
  let offset = 0;
  for (let row = 0; row <= ROWS; row++) {
    for (let column = 0; column <= COLUMNS; column++) yield vertexLine(column + offset, y);
    const triangles = isOfTriangles(row);
    y += triangles ? Math.sqrt(3) / 2 : 1;
    if (triangles) offset = 0.5 - offset;
  }
}

/** The sheet arches over its width and waves along its length. */
function vertexLine(x: number, y: number): string {
  const across = x / COLUMNS - 0.5;
  const z = 2.4 * Math.cos(2.4 * across) + 0.5 * Math.sin(y / 5);
  return `v ${[(10 * x) / COLUMNS - 5, (10 * y) / COLUMNS - 4.7, z].map((each) => each.toFixed(6)).join(' ')}`;
}

function* faces(): Generator<string> {
  let shifted = false;
  for (let row = 0; row < ROWS; row++) {
    const triangles = isOfTriangles(row);
    for (let column = 0; column < COLUMNS; column++) {
      const [a, b] = [row * (COLUMNS + 1) + column + 1, row * (COLUMNS + 1) + column + 2];
      const [d, c] = [a + COLUMNS + 1, b + COLUMNS + 1];
      if (!triangles) yield `f ${a} ${b} ${c} ${d}`;
      else if (shifted) yield* [`f ${a} ${b} ${c}`, `f ${a} ${c} ${d}`];
      else yield* [`f ${a} ${b} ${d}`, `f ${b} ${c} ${d}`];
    }
    if (triangles) shifted = !shifted;
  }
}

function isOfTriangles(row: number): boolean {
  return row % 2 === 1;
}
