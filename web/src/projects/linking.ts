import { lazy } from '../lazy';

/** For reading links and making them. */
export const linking = lazy(() => import('./link'));
