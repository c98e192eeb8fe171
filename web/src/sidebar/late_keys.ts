/** The sheet's tables of keys, but for those of the whole page: of controls that come late. */
import type { KeyTable } from '../dialogs/key_sheet';
import { AXIS_KEYS } from '../view/axis_drag';
import { PEN_KEYS, SELECTION_KEYS, VIEW_KEYS } from '../view/gesture_keys';
import { ROW_KEYS } from './row_title';
import { SNAP_KEYS } from './snap_controls';

export const LATE_TABLES: readonly KeyTable[] = [
  { where: 'picture', rows: VIEW_KEYS },
  { where: 'selection', rows: [...SELECTION_KEYS, ...AXIS_KEYS, ...SNAP_KEYS] },
  { where: 'drawing', rows: PEN_KEYS },
  { where: 'list', rows: ROW_KEYS },
];
