/** What vite.config.ts makes while building. */
declare module 'virtual:plasma' {
  /** A colour map from dark to light, each colour as `#rrggbb`. */
  export const PLASMA: readonly string[];
}

declare module 'virtual:gallery_pictures' {
  /** By the name of a shape the lines of its small net as paths, from the far ones to the near ones. */
  export const PICTURES: Readonly<Record<string, readonly string[]>>;
  /** Of each of them, as SVG has it. */
  export const VIEW_BOX: string;
}
