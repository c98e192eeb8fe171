// The core without files and equalising: a third smaller.
import createEditors from '../build/wasm/chebnet_editor.js';
import { loaderOf } from './facade.js';

/** @type {typeof import('./editors').loadEditors} */
export const loadEditors = loaderOf(createEditors);
