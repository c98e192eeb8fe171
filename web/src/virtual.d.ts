/** What vite.config.ts makes while building. */
declare module 'virtual:plasma' {
  /** A colour map from dark to light, each colour as `#rrggbb`. */
  export const PLASMA: readonly string[];
}
