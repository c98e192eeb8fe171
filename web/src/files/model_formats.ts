/** The formats that model.ts reads, for pickers and hints: those that a library of the page knows rather than the core. */
export const MODEL_FORMATS = [
  { title: 'GLB', extensions: ['glb', 'gltf'] },
  { title: '3DM', extensions: ['3dm'] },
];
