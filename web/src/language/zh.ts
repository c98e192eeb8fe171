/** Simplified Chinese. */
import type { Words } from './language';

export const zh: Words = {
  handles: {
    none: '还没有手柄。点击网上的顶点即可抓住它。',
  },
};
