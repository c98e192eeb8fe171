import { part } from '../part';

/** For reading links and making them. */
export const linking = part(() => import('./link'));
