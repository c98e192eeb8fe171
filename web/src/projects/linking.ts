import { lazy } from '../lazy';

/** The code that reads and makes links, loaded on demand. */
export const linking = lazy(() => import('./link'));
