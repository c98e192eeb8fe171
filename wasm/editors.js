// The core for a first net: little more than half as large.
import createEditors from '../build/wasm/chebnet_editor.js';
import { loaderOf } from './facade.js';

/** @type {typeof import('./editors').loadEditors} */
export const loadEditors = loaderOf(createEditors);
