/** The module worker that makes one file; a library that only one kind of file needs is loaded for that kind alone. */
import rhinoUrl from 'rhino3dm/rhino3dm.wasm?url';
import type { ExportAnswer, ExportJob } from './job';
import { patternSvg } from './pattern_svg';
import { messageOf } from '../failure';

async function answer(job: ExportJob): Promise<ExportAnswer> {
  switch (job.kind) {
    case 'glb': {
      const { glbOf } = await import('./glb');
      return { bytes: await glbOf(job) };
    }
    case '3dm': {
      const { rhinoFileOf } = await import('./rhino_file');
      return { bytes: await rhinoFileOf(job, rhinoUrl) };
    }
    case 'svg':
      return { bytes: new TextEncoder().encode(patternSvg(job)) };
  }
}

self.onmessage = ({ data }: MessageEvent<ExportJob>) => {
  const failed = (error: unknown): ExportAnswer => ({
    message: messageOf(error),
  });
  answer(data)
    .catch(failed)
    .then((each) => self.postMessage(each));
};
