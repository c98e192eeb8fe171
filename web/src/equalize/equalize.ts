/** Answers the request of equalizing.ts, in the worker: equalises one mesh and reports progress. */
import type { Chebnet, Equalizer } from '../../../wasm/chebnet';
import type { EqualizeRequest, EqualizeResponse } from './equalize_protocol';
import { codeOf, messageOf } from '../failure';
import { openSurface } from '../worker/opened_net';

/** Milliseconds between two pieces of news; one iteration is the least. */
const SLICE = 80;

export function equalize(core: Chebnet, request: EqualizeRequest, post: (response: EqualizeResponse) => void): void {
  try {
    const equalizer = begun(core, request);
    try {
      post(solveToTheEnd(equalizer, post));
    } finally {
      equalizer.dispose();
    }
  } catch (error) {
    const code = codeOf(error);
    post({ type: 'error', code, message: messageOf(error) });
  }
}

/** It keeps what it needs of the guide. */
function begun(core: Chebnet, { mesh, options, guide }: EqualizeRequest): Equalizer {
  if (!guide) return core.equalizer(mesh, options);
  const surface = openSurface(core, guide);
  try {
    return core.equalizer(mesh, { ...options, guide: surface });
  } finally {
    surface.dispose();
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
