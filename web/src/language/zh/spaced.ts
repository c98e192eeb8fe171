/** A name in Latin letters stands apart from the characters around it. */
export function spaced(name: string): string {
  return name.replace(/^(?=[\w(])/, ' ').replace(/(?<=[\w)])$/, ' ');
}
