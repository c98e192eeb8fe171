/** As chebnet_core.js, with the bindings of bindings.cpp alone (see CMakeLists.txt); facade.js refuses what needs others. */
export { default } from './chebnet_core.js';
