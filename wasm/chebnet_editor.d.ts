/** As chebnet_core.js, without the bindings of file_border.cpp and equalize_border.cpp, which nobody asks of wasm/editors.js. */
export { default } from './chebnet_core.js';
