/** Answers the request of equalizing.ts, in the worker: equalises one mesh and reports progress. */
import type { Chebnet, Equalizer } from '../../../wasm/chebnet';
import type { EqualizeRequest, EqualizeResponse } from './equalize_protocol';
import { codeOf, messageOf } from '../failure';
import { openSurface } from '../worker/opened_net';

/** Milliseconds between two pieces of news; one iteration is the least. */
const SLICE = 80;

export function equalize(
  core: Chebnet,
  { mesh, options, guide }: EqualizeRequest,
  post: (response: EqualizeResponse) => void,
): void {
  try {
    const surface = guide && openSurface(core, guide);
    const equalizer = core.equalizer(mesh, surface ? { ...options, guide: surface } : options);
    surface?.dispose();
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
