import type { learn as en } from '../en/learn';
import type { Widened } from '../words';

export const learn: Widened<typeof en> = {
  licences: 'chebnet 是自由软件：它的许可证，以及其中所含软件的许可证',
  showMe: '演示',
  noHandle: '请先点击一个顶点，使它成为手柄。',
  stagesDone: '所有阶段都已完成：每条边都恢复了自己的长度。网已回到演示之前的样子。',
  lessons: {
    net: {
      title: '等边长的网',
      text: '切比雪夫网的边长都相同，就像铁丝网或织物。面可以剪切变形，边却从不伸长：正因如此，它能贴合弯曲的形状。在通过各手柄的所有这样的网中，本页寻找弯曲和剪切尽可能小的一张。',
      show: '网如何随手柄变形，再恢复原状',
    },
    deviation: {
      title: '边偏离了多少',
      text: '设 {r} 为一条边的长度与它应有长度之比。偏差 {deviation} 在长度正确时为 0，长一倍与短一半的偏差相同。',
      show: '按偏差为边着色，每个数量级一种颜色',
    },
    energy: {
      title: '论文的能量',
      text: '论文的方法（本页由此发展而来）寻找使所有边的 {energy} 之和最小的形状。每条边在 {atRest} 处能量最小。{p} 越大，两侧的壁越陡：当 {p50} 时，几乎只有最差的边起作用。',
      show: '手柄远远走在网的前面，最差的边爬上陡壁',
    },
    stages: {
      title: '三个阶段',
      text: '论文的方法由粗到精：',
      show: '用论文的方法走完一个阶段',
    },
  },
  stageTexts: [
    '取 {p2}，整张网快速移动，尚不精确，直到各处 {rough}。',
    '取 {p50}，余下的偏差均匀分散到许多边上，直到 {finer}。',
    '只移动仍有偏差的边附近的顶点，直到 {fine}。',
  ],
  waits: '已暂停。点击“三个阶段”下的“演示”进入下一阶段；点击别处则把手柄放回原位。',
  now: (p, ratio) => `现在 p\u00a0=\u00a0${p}；圆点是最差的边，r\u00a0=\u00a0${ratio}`,
  graph: (p, ratio) => `边的能量随 r 的变化，p = ${p}；最差的边 r = ${ratio}`,
};
