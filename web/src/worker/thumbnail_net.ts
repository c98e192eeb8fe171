import type { Editors } from '../../../wasm/chebnet';

export interface ThumbnailNet {
  edges: Int32Array;
  positions: Float32Array;
}

/** The net of a recipe, reduced to what a picture in the gallery needs. */
export function thumbnailOf(core: Editors, recipe: string): ThumbnailNet {
  const editor = core.openRecipe(recipe);
  const { edges, restPositions } = editor;
  editor.dispose();
  return { edges, positions: Float32Array.from(restPositions) };
}
