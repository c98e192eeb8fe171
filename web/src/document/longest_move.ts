/** The largest distance between the places of a vertex in `before` and in `after`. */
export function longestMove(before: Float64Array, after: Float64Array): number {
  let longest = 0;
  for (let i = 0; i < before.length; i += 3) {
    const [x, y, z] = [after[i]! - before[i]!, after[i + 1]! - before[i + 1]!, after[i + 2]! - before[i + 2]!];
    longest = Math.max(longest, x * x + y * y + z * z);
  }
  return Math.sqrt(longest);
}
