export const reading = {
  otherVersion: 'This link was made by another version of chebnet.',
  foreign: 'This link is not one of chebnet.',
  damaged: 'This link is damaged: perhaps a part of it was cut off.',
  handle: '[vertex, 0 or 1, x, y, z]',
  camera: 'two points: six numbers',
  ends: 'two numbers, the lower one first, above 0 for deviations',
};
