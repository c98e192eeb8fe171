import type { JSHandle, Page } from 'playwright-core';

/** The colours of a PNG, four numbers from 0 to 255 a pixel, as they stand in the page: of large pictures there are many. */
export function pixels(page: Page, png: Uint8Array): Promise<JSHandle<Uint8ClampedArray>> {
  return page.evaluateHandle(
    async (bytes) => {
      const picture = await createImageBitmap(new Blob([Uint8Array.from(bytes)], { type: 'image/png' }));
      const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d')!;
      context.drawImage(picture, 0, 0);
      return context.getImageData(0, 0, picture.width, picture.height).data;
    },
    [...png],
  );
}
