/** Tables of the keys of controls that come late, for the sheet of keys. */
export { AXIS_KEYS } from '../view/axis_drag';
export { SELECTION_KEYS, VIEW_KEYS } from '../view/gesture_keys';
export { ROW_KEYS } from './handle_row';
export { SNAP_KEYS } from './snap_controls';
