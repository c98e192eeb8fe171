/** How fine a net is: by the cells that would cover the whole surface, or by the length of its edges. */

export const SUGGESTED_CELLS = 1500;
/** More take too long to follow a hand. */
export const FEWEST_CELLS = 50;
export const MOST_CELLS = 20000;

export function lengthOf(cells: number, area: number): number {
  return Math.sqrt(area / cells);
}

export function cellsOf(length: number, area: number): number {
  return area / length ** 2;
}
