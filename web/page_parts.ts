/** Vite plugins that leave out of libraries what the page has no use for: a visitor waits for every byte. */
import { interpolatePlasma } from 'd3-scale-chromatic';
import type { Plugin } from 'vite';

/** Of three.js, the page's materials are its own shaders, MeshBasic, MeshLambert and lines; there is no headset, no map of
 *  the surroundings, no shadow map. Whoever wants more of it takes its name out of these lists. */
const IDLE_MATERIALS = [
  'meshphysical',
  'meshphong',
  'meshtoon',
  'meshmatcap',
  'meshnormal',
  'background',
  'backgroundCube',
  'cube',
  'equirect',
  'sprite',
  'vsm',
  'points',
  'depth',
  'distance',
  'linedashed',
];
const IDLE_CHUNKS =
  /^(lights_(physical|phong|toon|fragment_maps)|iridescence|transmission|clearcoat|envmap|lightprobes|shadowm|normal_fragment_maps|bumpmap|normalmap|displacementmap|metalnessmap|roughnessmap|gradientmap|skin|morph|tonemapping|map_|alpha|aomap|lightmap|emissivemap|specularmap_pars|uv_|batching|clipping|fog|logdepthbuf|dithering|packing)/;
const IDLE_MODULES: Record<string, string> = {
  'renderers/webxr/WebXRManager': `export class WebXRManager {
    enabled = false; isPresenting = false;
    addEventListener() {} removeEventListener() {} setAnimationLoop() {} dispose() {}
    getEnvironmentBlendMode() { return 'opaque'; }
  }`,
  'renderers/webgl/WebGLShadowMap': 'export class WebGLShadowMap { enabled = false; render() {} }',
  'renderers/webgl/WebGLMorphtargets': 'export class WebGLMorphtargets {}',
  'renderers/webgl/WebGLUniformsGroups': 'export class WebGLUniformsGroups { dispose() {} }',
  'renderers/webgl/WebGLOutput': 'export class WebGLOutput {}',
  'renderers/webgl/WebGLClipping':
    'export class WebGLClipping { numPlanes = 0; numIntersection = 0; init() { return false; } }',
  'renderers/webgl/WebGLEnvironments': `export class WebGLEnvironments { get(texture) { return texture; } dispose() {} }`,
  'lights/DirectionalLightShadow': 'export class DirectionalLightShadow { dispose() {} }',
  'math/FrustumArray': 'export class FrustumArray {}',
  'extras/ImageUtils': 'export class ImageUtils {}',
  'renderers/shaders/DFGLUTData': 'export function getDFGLUT() { return null; }',
  'extras/PMREMGenerator': 'export class PMREMGenerator {}',
};
/** Scenes are not written as three's own JSON. */
const IDLE_METHODS = /\n\ttoJSON\([^)]*\) \{\n[\s\S]*?\n\t\}\n/g;

/** three.js from its sources, without the idle parts. Only for building: while developing, its bundle loads faster. */
export function leanThree(): Plugin {
  return {
    name: 'lean-three',
    apply: 'build',
    enforce: 'pre',
    config: () => ({ resolve: { alias: [{ find: /^three$/, replacement: 'three/src/Three.js' }] } }),
    load(id) {
      const name = /\/three\/src\/(.*)\.js$/.exec(id)?.[1];
      return name === undefined ? null : (IDLE_MODULES[name] ?? idleShader(name));
    },
    transform(code, id) {
      if (id.endsWith('.glsl.js'))
        return code.replace(/\/\* glsl \*\/\s*`([^`]*)`/g, (_, glsl: string) => JSON.stringify(lean(glsl)));
      return id.includes('/three/src/') ? code.replace(IDLE_METHODS, '') : null;
    },
  };
}

function idleShader(name: string): string | null {
  const [, kind, shader = ''] = /shaders\/Shader(Lib|Chunk)\/(.*)\.glsl$/.exec(name) ?? [];
  if (kind === 'Lib' && IDLE_MATERIALS.includes(shader)) return "export const vertex = ''; export const fragment = '';";
  return kind === 'Chunk' && IDLE_CHUNKS.test(shader) ? "export default '';" : null;
}

/** Without comments and indentation. */
function lean(glsl: string): string {
  return glsl.replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '').replace(/[ \t]*\n\s*/g, '\n');
}

/** `virtual:plasma`: the colours of one map, of the hundred in the library. */
export function plasma(): Plugin {
  const colours = Array.from({ length: 256 }, (_, i) => interpolatePlasma(i / 255));
  return {
    name: 'plasma',
    resolveId: (id) => (id === 'virtual:plasma' ? '\0plasma' : null),
    load: (id) => (id === '\0plasma' ? `export const PLASMA = '${colours.join('')}'.match(/#.{6}/g);` : null),
  };
}
