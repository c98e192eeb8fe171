import type { reading as en } from '../en/reading';
import type { Widened } from '../words';

export const reading: Widened<typeof en> = {
  otherVersion: '此链接由另一版本的 chebnet 生成。',
  foreign: '此链接不是 chebnet 的链接。',
  damaged: '此链接已损坏，可能有一部分被截断。',
  handle: ' [顶点, 0 或 1, x, y, z]',
  camera: '两个点：六个数值',
  ends: '两个数值，小的在前；偏差的两端须大于 0',
};
