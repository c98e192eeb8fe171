/** The module worker for one picture, with a core of its own: it is sent a recipe and answers with the net, or null. */
import { thumbnailOf } from './thumbnail_net';
import { loadWholeCore } from './whole_core';

self.onmessage = async ({ data: recipe }: MessageEvent<string>) => {
  try {
    self.postMessage(thumbnailOf(await loadWholeCore(), recipe));
  } catch {
    self.postMessage(null);
  }
};
