/** A Vite plugin that leaves out of three.js what the page has no use for: a visitor waits for every byte. */
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
  'shadow',
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
/** What the renderer asks its objects, materials, lights and textures for and is always answered no, compressed
 *  textures among it: the branches behind it go with the minifier. */
const IDLE_KINDS =
  /(?:[\w.]|\[ \w+ \])+\.is(?:ArrayCamera|ArrayTexture|BatchedMesh|CompressedArrayTexture|CompressedCubeTexture|CompressedTexture|CubeDepthTexture|CubeTexture|Data3DTexture|DataArrayTexture|DepthTexture|ExternalTexture|FogExp2|FramebufferTexture|HTMLTexture|LightProbe|LightProbeGrid|LineDashedMaterial|LOD|MeshDepthMaterial|MeshDistanceMaterial|MeshMatcapMaterial|MeshNormalMaterial|MeshPhongMaterial|MeshPhysicalMaterial|MeshStandardMaterial|MeshToonMaterial|NodeMaterial|Points|PointsMaterial|PointLight|RectAreaLight|ShadowMaterial|SkinnedMesh|SpotLight|Sprite|SpriteMaterial|StorageInstancedBufferAttribute|StorageBufferAttribute|SunLight|VideoTexture|WebGL3DRenderTarget|WebGLArrayRenderTarget|WebGLCubeRenderTarget|XRRenderTarget)\b(?! =[^=])|\bp === \w+_Format\b/g;
/** What a material of the page never has. */
const IDLE_READS =
  /\b(?:parameters|material)\.(?:map(?:Uv)?\b|(?:alphaHash|alphaMap|anisotropy|aoMap|batching|bumpMap|clearcoat|decodeVideo|diffuseRoughness|displacementMap|dispersion|emissiveMap|envMap|gradientMap|iridescence|lightMap|matcap|metalnessMap|morph|normalMap|packedNormal|retroreflect|roughnessMap|sheen|skinning|specularMap|specularColor|specularIntensity|thicknessMap|transmission)\w*)(?! =[^=])/g;
/** Functions of the renderer that are never called: the page draws to the screen and to plain textures. */
const IDLE_FUNCTIONS: Record<string, readonly string[]> = {
  'renderers/WebGLRenderer': [
    'renderTransmissionPass',
    'compileAsync',
    'setEffects',
    'setNodesHandler',
    'setRenderTargetTextures',
    'setRenderTargetFramebuffer',
    'readRenderTargetPixels',
    'readRenderTargetPixelsAsync',
    'copyFramebufferToTexture',
    'copyTextureToTexture',
    'initRenderTarget',
    'initTexture',
  ],
  'renderers/webgl/WebGLTextures': [
    'generateMipmap',
    'getInternalDepthFormat',
    'setTexture2DArray',
    'setTexture3D',
    'setTextureCube',
    'uploadCubeTexture',
    'setupRenderBufferStorage',
    'setupDepthTexture',
    'setupDepthRenderbuffer',
    'rebindTextures',
    'updateMultisampleRenderTarget',
    'updateVideoTexture',
  ],
  'renderers/webgl/WebGLMaterials': [
    'refreshUniformsDash',
    'refreshUniformsPoints',
    'refreshUniformsSprites',
    'refreshUniformsPhong',
    'refreshUniformsToon',
    'refreshUniformsStandard',
    'refreshUniformsPhysical',
    'refreshUniformsMatcap',
    'refreshUniformsDistance',
  ],
};

/** What starts a part of a shader that is never compiled. */
const IDLE_CONDITION =
  /^#if(def)?\W+(defined\W+)?(NUM_(POINT|SPOT|SUN|RECT_AREA)_LIGHTS|NUM_LIGHT_PROBE|STANDARD|USE_(ALPHAHASH|BATCHING|CLEARCOAT|IRIDESCENCE|LIGHTMAP|LIGHT_PROBES|SHADOWMAP|SKINNING|SPECULARMAP|TANGENT|TRANSMISSION)\b)/;

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
      const name = /\/three\/src\/(.*)\.js$/.exec(id)?.[1];
      if (name === undefined) return null;
      return name.startsWith('renderers/') ? leanRenderer(name, code) : code.replace(IDLE_METHODS, '');
    },
  };
}

function idleShader(name: string): string | null {
  const [, kind, shader = ''] = /shaders\/Shader(Lib|Chunk)\/(.*)\.glsl$/.exec(name) ?? [];
  if (kind === 'Lib' && IDLE_MATERIALS.includes(shader)) return "export const vertex = ''; export const fragment = '';";
  return kind === 'Chunk' && IDLE_CHUNKS.test(shader) ? "export default '';" : null;
}

function leanRenderer(name: string, code: string): string {
  const asked = code.replace(IDLE_KINDS, 'false').replace(IDLE_READS, 'null');
  return (IDLE_FUNCTIONS[name] ?? []).reduce(withoutBody, asked);
}

function withoutBody(code: string, name: string): string {
  const whole = new RegExp(
    `\\n(\\t+)(this\\.${name} = (?:async )?function|function ${name}) ?\\([^)]*\\) \\{\\n[^]*?\\n\\1\\}`,
  );
  if (!whole.test(code)) throw new Error(`three.js has no function ${name} any more`);
  return code.replace(whole, '\n$1$2() {}');
}

/** Without comments, indentation and what is compiled only with idle features. */
function lean(glsl: string): string {
  const lines = glsl.replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '').split(/\s*\n\s*/);
  const open: { idle: boolean; skipped: boolean }[] = [];
  return lines
    .filter((line) => {
      const inner = open.at(-1);
      if (/^#if/.test(line)) {
        const idle = IDLE_CONDITION.test(line) && !line.includes('||');
        open.push({ idle, skipped: idle || (inner?.skipped ?? false) });
        return !open.at(-1)!.skipped;
      }
      if (inner !== undefined && line.startsWith('#endif')) open.pop();
      if (inner?.idle && line.startsWith('#else')) inner.skipped = open.at(-2)?.skipped ?? false;
      return !inner?.skipped && !(inner?.idle && /^#e/.test(line));
    })
    .join('\n');
}
