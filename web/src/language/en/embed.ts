export const embed = {
  activate: 'Press to drag the net',
  open: 'Open in chebnet',
  tooLarge: 'This net is too large to be opened in a window of its own.',
};
