/** What the core says, by the names in its tables and the codes of its errors. */
import type { Tables } from '../../net/tables';

interface ShapeWords {
  title: string;
  sentence: string;
  parameters: Record<string, string>;
}

const VERTICES = '网的大致顶点数。';
const SMOOTH = '1：光滑；0：方块。';
const ROUNDING = '锥磨圆多少；1：无锐折。';

export const SHAPES: Record<string, ShapeWords> = {
  vault: {
    title: '拱顶',
    sentence: '一道拱沿波浪线移动而成。',
    parameters: {
      vertices: VERTICES,
      rise: '拱高与拱宽之比。',
      aspect: '长度与拱的弧长之比。',
      waves: '沿长度起伏的次数。',
      slope: '波浪的坡度，度。',
    },
  },
  saddle: {
    title: '马鞍面',
    sentence: '一道拱沿下垂的弧线移动而成。',
    parameters: {
      vertices: VERTICES,
      rise: '拱高与拱宽之比。',
      aspect: '下垂弧与拱的长度之比。',
    },
  },
  canopy: {
    title: '雨棚',
    sentence: '自由曲面薄壳，从落脚处升起，末端挑出成檐。',
    parameters: {
      vertices: VERTICES,
      rise: '拱高与拱宽之比。',
      aspect: '长度与拱的弧长之比。',
      slope: '升起的坡度，度。',
    },
  },
  sheet: {
    title: '平网',
    sentence: '方格的平网，如展开的金属丝网。',
    parameters: { vertices: VERTICES, aspect: '平网的长宽之比。' },
  },
  dome: {
    title: '穹顶',
    sentence: '球面的一部分，从相交于顶点的两道拱织成网。',
    parameters: { vertices: VERTICES, reach: '两道主拱向下延伸的角度，度。' },
  },
  tube: {
    title: '管',
    sentence: '倾斜的管，两端开口。',
    parameters: { vertices: VERTICES, aspect: '管长与管周长之比。', bend: '管向两侧倾斜的角度，度。' },
  },
  torus: {
    title: '环面',
    sentence: '竖立的小环沿平放的大环移动而成。',
    parameters: { vertices: VERTICES, thickness: '竖环周长与平环周长之比。' },
  },
  jack: {
    title: '六臂体',
    sentence: '立方体伸出六条方形臂。',
    parameters: { vertices: VERTICES, arm: '每条臂的长度与宽度之比。', smooth: SMOOTH },
  },
  steps: {
    title: '阶梯',
    sentence: '阶梯金字塔。',
    parameters: { vertices: VERTICES, steps: '通往顶部的级数。', height: '每级台阶的高度与深度之比。' },
  },
  elephant: {
    title: '大象',
    sentence: '由方块搭成的大象。',
    parameters: {
      vertices: VERTICES,
      legs: '腿的长度（躯干高度为 4）。',
      trunk: '象鼻的长度（躯干高度为 4）。',
      smooth: SMOOTH,
    },
  },
  teddy: {
    title: '玩具熊',
    sentence: '坐着的玩具熊，处处光滑。',
    parameters: { vertices: VERTICES, rounding: ROUNDING },
  },
  rabbit: {
    title: '兔子',
    sentence: '坐着的兔子，处处光滑。',
    parameters: { vertices: VERTICES, rounding: ROUNDING },
  },
  horse: {
    title: '木马',
    sentence: '立在滑轨上的马，身下有两个洞。',
    parameters: { vertices: VERTICES, rounding: ROUNDING },
  },
  jug: {
    title: '水罐',
    sentence: '带把手的水罐，罐口敞开。',
    parameters: { vertices: VERTICES, rounding: ROUNDING },
  },
  shirt: {
    title: '背心',
    sentence: '无袖衫，下摆、领口和袖口敞开。',
    parameters: { vertices: VERTICES },
  },
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

export const FORMATS: Record<string, string> = {
  obj: '用于 Rhino 和 Blender',
  ply: '二进制，保留全部精度',
  off: '纯文本',
  stl: '三角形，用于 3D 打印',
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
  tables: ({ shapes, formats, ...more }: Tables): Tables => ({
    shapes: shapes.map((shape) => {
      const { title, sentence, parameters } = SHAPES[shape.name] ?? { ...shape, parameters: {} };
      const own = shape.parameters.map((each) => ({ ...each, sentence: parameters[each.name] ?? each.sentence }));
      return { ...shape, title, sentence, parameters: own };
    }),
    formats: formats.map((each) => ({ ...each, sentence: FORMATS[each.name] ?? each.sentence })),
    ...more,
  }),
  parameter: (name: string) => PARAMETERS[name] ?? name,
  shape: (name: string) => SHAPES[name]?.title ?? name,
  method: (name: string) => METHODS[name] ?? INITIALISATIONS[name] ?? name,
  failure: (code: string, message: string) => {
    const said = CORE_ERRORS[code];
    return said === undefined ? (WORKER_ERRORS[code] ?? message) : `${said}（${message.replace(/\.$/, '')}）`;
  },
  sentence: (text: string) => (/[.!?。！？…]$/.test(text) ? text : `${text}。`),
  sentences: (all: string[]) => all.join(''),
};
