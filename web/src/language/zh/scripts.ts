import type { scripts as en } from '../en/scripts';
import type { Widened } from '../words';

export const scripts: Widened<typeof en> = {
  net: '含 recipe 或 obj 的记录',
  surface: '含 own，或含 vertices 和 faces 的记录',
  unknownField: (path, known) => `没有 ${path} 这个字段；可用的有：${known.join('、')}`,
};
