/** Which methods let handles slide. */
import { expect, test } from 'vitest';
import { METHODS_THAT_SLIDE } from '../../web/src/sidebar/sliding';
import { load } from '../wasm/load';

test('the page says of those methods that they let handles slide of which the core does', async () => {
  const methods = (await load()).methods();
  expect(methods.filter(({ slides }) => slides).map(({ name }) => name)).toEqual(METHODS_THAT_SLIDE);
});
