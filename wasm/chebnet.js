// The whole core.
import createCore from '../build/wasm/chebnet_core.js';
import { loaderOf } from './facade.js';

export const loadChebnet = loaderOf(createCore);
