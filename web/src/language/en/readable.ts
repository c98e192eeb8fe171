/** Names of the core as people read them. */

/** `switch_deviation` → `Switch deviation`; but `p_end` → `p end`, for p is a letter of the paper. */
export function readable(name: string): string {
  const words = name.replaceAll('_', ' ');
  if (words.charAt(1) === ' ') return words;
  return words.charAt(0).toUpperCase() + words.slice(1);
}
