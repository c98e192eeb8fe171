/** What the pictures of the page, this one and that of a surface, ask of their renderers alike. */
import { InstancedMesh, type Mesh, type Object3D, type ShaderMaterial, Texture, type WebGLRenderer } from 'three';

/** Higher pixel ratios cost much and show little; without a graphics card every pixel is expensive. */
const LARGEST = { card: 2, software: 1 };

/** Pixels of the picture to one of the page. */
export function pixelRatio(graphics: 'card' | 'software'): number {
  return Math.min(devicePixelRatio, LARGEST[graphics]);
}

/** Calls back when it may be another one: on another screen, or once the page is zoomed. Returns how to stop that. */
export function onPixelRatioChange(changed: () => void): () => void {
  const listening = new AbortController();
  /** A query is of one ratio, and says that it is no longer this. */
  const listen = (): void => {
    const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    const passed = (): void => {
      listen();
      changed();
    };
    query.addEventListener('change', passed, { once: true, signal: listening.signal });
  };
  listen();
  return () => listening.abort();
}

/** For when the context is lost: what the graphics card held is gone, and does not belong to the next context, which would
 *  complain when it is let go there. It is sent anew when it is drawn. */
export function forgetUploads(scene: Object3D): void {
  scene.traverse((object) => {
    const { geometry, material } = object as Partial<Mesh>;
    geometry?.dispose();
    for (const each of [material ?? []].flat()) {
      for (const { value } of Object.values((each as Partial<ShaderMaterial>).uniforms ?? {}))
        if (value instanceof Texture) value.dispose();
      each.dispose();
    }
    if (object instanceof InstancedMesh) object.dispose();
  });
}

/** Gives its context back at once: a browser has sixteen or so, and takes for one more the oldest, that of the main picture. */
export function endRenderer(renderer: WebGLRenderer): void {
  renderer.dispose();
  renderer.forceContextLoss();
}
