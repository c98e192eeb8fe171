/** What the equalizing worker does, apart from being a worker. */
import type { Chebnet, Equalizer, Mesh } from '../../../wasm/chebnet';
import { objText } from '../files/obj_text';
import type { EqualizeRequest, EqualizeResponse } from './equalize_protocol';
import { codeOf, messageOf } from '../failure';

/** Milliseconds between two pieces of news; one iteration is the least. */
const SLICE = 80;

export function equalize(
  core: Chebnet,
  { mesh, options }: EqualizeRequest,
  post: (response: EqualizeResponse) => void,
): void {
  try {
    const equalizer = core.equalizer(mesh, options);
    post(solveToTheEnd(equalizer, mesh, post));
    equalizer.dispose();
  } catch (error) {
    const code = codeOf(error);
    post({ type: 'error', code, message: messageOf(error) });
  }
}

function solveToTheEnd(equalizer: Equalizer, mesh: Mesh, post: (response: EqualizeResponse) => void): EqualizeResponse {
  for (;;) {
    const report = equalizer.solve({ milliseconds: SLICE });
    const positions = equalizer.positions();
    if (report.status === 'running') post({ type: 'news', report, positions });
    else
      return {
        type: 'ended',
        report,
        positions,
        obj: report.status === 'converged' ? objText({ ...mesh, positions }) : null,
      };
  }
}
