import { lazy } from '../lazy';

/** The code that reads and writes projects, loaded when there is something to keep or to open. */
export const projectFormat = lazy(() => import('../document/project'));
