export const scripts = {
  net: 'a record with "recipe" or "obj"',
  surface: 'a record with "own", or with "vertices" and "faces"',
  unknownField: (path: string, known: readonly string[]) => `unknown field ${path}; known are ${known.join(', ')}`,
};
