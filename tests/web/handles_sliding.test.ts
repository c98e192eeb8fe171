/** Which methods let handles slide. */
import { expect, test } from 'vitest';
import { slipwayOf } from '../../web/src/sidebar/sliding';
import { load } from '../wasm/load';
import { documentAt } from './nets';

test('the page says of those methods that they let handles slide of which the core does', async () => {
  const methods = (await load()).methods();
  const sliding = methods.filter(({ name: method }) => slipwayOf({ ...documentAt(null), method }, methods).slides);
  expect(sliding.map(({ name }) => name)).toEqual(['projection', 'equilibrium']);
});
