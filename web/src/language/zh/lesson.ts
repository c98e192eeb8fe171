import type { lesson as en } from '../en/lesson';
import type { Widened } from '../words';

export const lesson: Widened<typeof en> = {
  locale: 'zh-CN',
  title: '边长都相等的网',
  wireMesh: '拿一块金属丝网，可以把它贴着球面弯过去；换成纸，就免不了起皱。金属丝的长度不变，变的是丝与丝之间的夹角。',
  chebyshevNet: '切比雪夫网',
  mathematics: '就是这种丝网的数学模型：每条边保持长度，每个四边形可以剪切变形。',
  tryIt: '动手试试',
  howTo: '先点击图形，再拖动橙色小球。按 Esc 键或点击图形以外的地方，页面即可恢复滚动。',
  picture: '可以拖动的丝网穹顶',
  push: '把顶点压低',
  lift: '把顶点抬高',
  again: '重新开始',
  loading: '正在加载网。',
  measured: (edges, worst, iterations) => `${edges} 条边中最大的 dL 为 ${worst}，共迭代 ${iterations} 次。`,
  below: (limit) => `${limit} 以下`,
  lookFor: '看什么',
  deviation:
    '一条边的偏差是 dL = r + 1/r − 2，其中 r 是它的长度与应有长度之比；完全准确的边偏差为 0。把顶点压低几次，留意这个数字：无论穹顶变成什么样子，所有边中最大的 dL 总会回到 0.000001 以下，相当于长度的千分之一。',
  limit: '再把顶点尽量抬高。网的大小受边长所限：抬到某处，便没有任何形状能够满足，图上会说明这一点。',
};
