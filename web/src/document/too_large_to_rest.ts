import { METHOD_AT_REST, usualMethod } from './defaults';
import type { ChebnetDocument } from './document';

/** Whether it is for the size of its net that the method keeps lengths alone. */
export function isTooLargeToRest({ method, net }: Pick<ChebnetDocument, 'method' | 'net'>): boolean {
  return method !== METHOD_AT_REST && method === usualMethod(net);
}
