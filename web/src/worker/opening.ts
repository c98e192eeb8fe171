import type { ChebnetDocument } from '../document/document';
import type { FrameData, OpenedNet } from './protocol';

/** A net that is open, and all that belongs to it. */
export interface Opening {
  document: ChebnetDocument;
  net: OpenedNet;
  frame: FrameData;
}
