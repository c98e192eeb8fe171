/** One way to drive the three engines: a window with its real pointer and keyboard, as much as they have in common. */

export type EngineName = 'chromium' | 'firefox' | 'webkit';

/** Bytes that the page may store: few, so that a test can fill them up. WebKit cannot be told. */
export const STORAGE = 2e7;

/** A running browser. */
export interface Engine {
  readonly name: EngineName;
  /** Opens a window for somebody who was never here before, 1280 × 800 pixels inside. */
  newWindow(): Promise<Driver>;
  close(): Promise<void>;
}

/** A window. Places are CSS pixels from the top left of the page; keys are named as in KeyboardEvent.key. */
export interface Driver {
  /** Resolves when the document is there; what its scripts do may be under way. */
  goto(url: string): Promise<void>;
  reload(): Promise<void>;
  /** The value of an expression of the page, awaited. It must be plain data. */
  evaluate(expression: string): Promise<unknown>;

  movePointer(x: number, y: number): Promise<void>;
  pressButton(): Promise<void>;
  releaseButton(): Promise<void>;
  turnWheel(dy: number): Promise<void>;
  pressKey(key: string): Promise<void>;
  releaseKey(key: string): Promise<void>;

  resize(width: number, height: number): Promise<void>;
  /** As PNG. */
  screenshot(): Promise<Buffer>;
  /** The folder that takes what is saved. */
  readonly downloads: string;
  /** Errors and warnings of the page so far. */
  complaints(): Promise<string[]>;
  close(): Promise<void>;
}
