/** Answers the request of equalizing.ts, in the worker: equalises one mesh and reports progress. */
import type { Chebnet, Equalizer } from '../../../wasm/chebnet';
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
    post(solveToTheEnd(equalizer, post));
    equalizer.dispose();
  } catch (error) {
    const code = codeOf(error);
    post({ type: 'error', code, message: messageOf(error) });
  }
}

function solveToTheEnd(equalizer: Equalizer, post: (response: EqualizeResponse) => void): EqualizeResponse {
  for (;;) {
    const report = equalizer.solve({ milliseconds: SLICE });
    const positions = equalizer.positions();
    if (report.status !== 'running')
      return { type: 'ended', report, positions, surfacePositions: equalizer.surfacePositions() };
    post({ type: 'news', report, positions });
  }
}
