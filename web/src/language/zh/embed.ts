import type { embed as en } from '../en/embed';
import type { Widened } from '../words';

export const embed: Widened<typeof en> = {
  activate: '点击后即可拖动网',
  open: '在 chebnet 中打开',
  tooLarge: '这张网太大，无法在单独的窗口中打开。',
};
