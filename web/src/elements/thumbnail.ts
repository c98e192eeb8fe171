/** Draws a small net as lines, seen as the view first sees it. */

export interface Wireframe {
  edges: Int32Array;
  positions: Float32Array;
}

/** Seen from the front right and above, without perspective: right and up on the page, in x, y, z. */
const RIGHT = [0.876, 0.482, 0] as const;
const UP = [-0.229, 0.416, 0.88] as const;
const MARGIN = 6;

/** Towards the viewer, likewise. */
const TOWARDS = [0.424, -0.771, 0.475] as const;
/** Far lines are drawn first and faintly, so that a closed net is legible. */
export const LAYERS = [0.12, 0.35, 1];

/** Flat coordinates of each vertex, fitted into a box. */
export function project({ positions }: Wireframe, width: number, height: number): Float32Array {
  const flat = new Float32Array((positions.length / 3) * 2);
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (let i = 0; 3 * i < positions.length; i++) {
    const [x, y, z] = [positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!];
    flat[2 * i] = RIGHT[0] * x + RIGHT[1] * y + RIGHT[2] * z;
    flat[2 * i + 1] = -(UP[0] * x + UP[1] * y + UP[2] * z);
    for (const axis of [0, 1]) {
      low[axis] = Math.min(low[axis]!, flat[2 * i + axis]!);
      high[axis] = Math.max(high[axis]!, flat[2 * i + axis]!);
    }
  }
  const spans = [high[0]! - low[0]! || 1, high[1]! - low[1]! || 1] as const;
  const scale = Math.min((width - 2 * MARGIN) / spans[0], (height - 2 * MARGIN) / spans[1]);
  for (let i = 0; i < flat.length; i += 2) {
    flat[i] = width / 2 + (flat[i]! - (low[0]! + high[0]!) / 2) * scale;
    flat[i + 1] = height / 2 + (flat[i + 1]! - (low[1]! + high[1]!) / 2) * scale;
  }
  return flat;
}

export function drawThumbnail(canvas: HTMLCanvasElement, net: Wireframe): void {
  const { clientWidth: width, clientHeight: height } = canvas;
  const context = canvas.getContext('2d');
  if (!context || width === 0) return;
  const ratio = Math.min(2, devicePixelRatio);
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  context.scale(ratio, ratio);
  context.strokeStyle = getComputedStyle(canvas).color;
  paintThumbnail(context, net, width, height);
}

/** In the colour that strokes have. */
export function paintThumbnail(
  context: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D,
  net: Wireframe,
  width: number,
  height: number,
): void {
  context.lineWidth = 0.7;
  const flat = project(net, width, height);
  const layers = edgeLayers(net);
  LAYERS.forEach((opacity, layer) => {
    context.globalAlpha = opacity;
    context.beginPath();
    for (let e = 0; e < layers.length; e++) {
      if (layers[e] !== layer) continue;
      const [a, b] = [2 * net.edges[2 * e]!, 2 * net.edges[2 * e + 1]!];
      context.moveTo(flat[a]!, flat[a + 1]!);
      context.lineTo(flat[b]!, flat[b + 1]!);
    }
    context.stroke();
  });
}

/** Which of the layers each edge lies in, from the far end of the net to the near one. */
export function edgeLayers({ edges, positions }: Wireframe): Uint8Array {
  const depths = new Float32Array(edges.length / 2);
  let low = Infinity;
  let high = -Infinity;
  for (let e = 0; e < depths.length; e++) {
    for (const vertex of [edges[2 * e]!, edges[2 * e + 1]!]) {
      for (let k = 0; k < 3; k++) depths[e]! += TOWARDS[k]! * positions[3 * vertex + k]!;
    }
    low = Math.min(low, depths[e]!);
    high = Math.max(high, depths[e]!);
  }
  const thickness = (high - low) / LAYERS.length || 1;
  return Uint8Array.from(depths, (depth) => Math.min(LAYERS.length - 1, Math.floor((depth - low) / thickness)));
}
