/** Numbers that look random and repeat: mulberry32. */
export function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** The one of CHEBNET_SEED, or else a new seed for each run unless one is given; printed, so that a failure can be repeated. */
export function printedSeed(what: string, usual = Math.floor(Math.random() * 2 ** 31)): number {
  const seed = Number(process.env['CHEBNET_SEED'] ?? usual);
  console.log(`${what}: CHEBNET_SEED=${seed}`);
  return seed;
}
