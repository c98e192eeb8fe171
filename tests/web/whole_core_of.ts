import type { Editors } from '../../wasm/chebnet';
import { replay } from '../../web/src/worker/replay';
import { Search } from '../../web/src/worker/search';
import type { WholeCore } from '../../web/src/worker/whole_core';

/** With a core that a test has loaded in place of the one that the worker loads. */
export function wholeCoreOf(core: Editors): WholeCore {
  return { core, Search, replay };
}
