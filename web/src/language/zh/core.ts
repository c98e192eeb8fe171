/** What the core says, by the names in its tables and the codes of its errors. */
import type { Tables } from '../../net/tables';

export const SHAPES: Record<string, string> = {
  vault: '拱顶',
  saddle: '马鞍面',
  canopy: '雨棚',
  wave: '波浪',
  scroll: '卷网',
  vase: '花瓶',
  sheet: '平网',
  dome: '穹顶',
  tube: '管',
  torus: '环面',
  jack: '六臂体',
  steps: '阶梯',
  elephant: '大象',
  teddy: '玩具熊',
  rabbit: '兔子',
  horse: '木马',
  jug: '水罐',
  shirt: '背心',
};

export const METHODS: Record<string, string> = {
  li2022: 'Li 等 2022',
  projection: '投影',
  composite_majorization: '复合优超',
  projected_newton: '投影牛顿法',
  gauss_newton: '高斯–牛顿法',
  equilibrium: '平衡',
  dp4: 'D^p，p = 4',
  dp8: 'D^p，p = 8',
  arap: 'ARAP',
  local_global: '局部–全局法',
  gradient_descent: '梯度下降',
  lbfgs: 'L-BFGS',
};

export const INITIALISATIONS: Record<string, string> = {
  naive: '直接',
  arap: 'ARAP',
  local_global: '局部–全局法',
};

/** Parameters of shapes. */
export const PARAMETERS: Record<string, string> = {
  vertices: '顶点数',
  rise: '拱高',
  aspect: '长宽比',
  waves: '波数',
  slope: '坡度',
  reach: '延伸角',
  bend: '倾斜',
  thickness: '粗细',
  arm: '臂长',
  steps: '级数',
  height: '台阶高度',
  legs: '腿长',
  trunk: '鼻长',
  smooth: '光滑',
  rounding: '圆润',
  turns: '圈数',
  waist: '颈宽',
};

/** The codes of core/base/error.h, wasm/chebnet.d.ts and worker/protocol.ts. What the core says, a place or a value, follows. */
export const CORE_ERRORS: Record<string, string> = {
  no_faces: '网没有面',
  index_out_of_range: '所指的顶点不存在',
  repeated_vertex: '顶点重复',
  small_face: '面的顶点少于三个',
  non_finite: '数值不是有限数',
  zero_length_edge: '边的两端重合',
  bad_scale: '尺度过大或过小，请先缩放',
  non_manifold_edge: '同一条边上有两个以上的面',
  unused_vertex: '有顶点不属于任何面',
  bad_syntax: '无法读取',
  bad_option: '名称不存在，或设置不适用',
  too_large: '超出大小限制',
  file_access: '无法访问文件',
  impossible_change: '网不能这样更改',
  left_out: '此模块不含这一部分',
  internal: '内部错误',
  disposed: '编辑器已关闭',
  crashed: '求解器出现故障',
};

/** What the page's own workers say besides; there is nothing to add. */
const WORKER_ERRORS: Record<string, string> = {
  version: '页面与求解器的版本不同，请重新加载页面',
  no_net: '没有打开的网',
  not_loaded: '求解器的其余部分无法加载',
  bad_link: '此链接中的位置数据已损坏，或属于另一张网',
  other_numbering: '此网的编号与保存时不同，形状和手柄会对应到错误的顶点',
};

export const core = {
  tables: ({ shapes, ...more }: Tables): Tables => ({
    shapes: shapes.map((shape) => ({ ...shape, title: SHAPES[shape.name] ?? shape.title })),
    ...more,
  }),
  parameter: (name: string) => PARAMETERS[name] ?? name,
  shapes: () => SHAPES,
  method: (name: string) => METHODS[name] ?? INITIALISATIONS[name] ?? name,
  failure: (code: string, message: string) => {
    const said = CORE_ERRORS[code];
    return said === undefined ? (WORKER_ERRORS[code] ?? message) : `${said}（${message.replace(/\.$/, '')}）`;
  },
  sentence: (text: string) => (/[.!?。！？…]$/.test(text) ? text : `${text}。`),
  sentences: (all: string[]) => all.join(''),
};
