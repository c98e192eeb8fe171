/** Which engine the tests run in: the project of vitest says so (web/vitest.config.ts). */
import { startChromium } from './chromium';
import type { Engine, EngineName } from './driver';
import { startFirefox } from './firefox';
import { startWebKit } from './webkit';

const STARTS: Record<EngineName, () => Promise<Engine>> = {
  chromium: startChromium,
  firefox: startFirefox,
  webkit: startWebKit,
};

export const ENGINE = process.env['CHEBNET_ENGINE'] as EngineName;

export function startEngine(): Promise<Engine> {
  return STARTS[ENGINE]();
}
