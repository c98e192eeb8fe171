import { expect, test } from 'vitest';
import { NearestFirst } from '../../web/src/handles/nearest_first';
import { printedSeed, random } from './random';

test('the nearest comes first, whatever comes and goes meanwhile', () => {
  const number = random(printedSeed('nearest first'));
  const waiting = new NearestFirst();
  let left: { item: number; distance: number }[] = [];
  for (let item = 0; item < 2000; item++) {
    const distance = Math.floor(50 * number());
    waiting.add(item, distance);
    left.push({ item, distance });
    if (number() < 0.4) takeOne();
  }
  while (left.length > 0) takeOne();
  expect(waiting.take()).toBeUndefined();

  function takeOne(): void {
    const taken = waiting.take()!;
    expect(taken.distance).toBe(Math.min(...left.map(({ distance }) => distance)));
    expect(left).toContainEqual(taken);
    left = left.filter(({ item }) => item !== taken.item);
  }
});
