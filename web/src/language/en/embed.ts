export const embed = {
  activate: 'Press to drag the net',
  open: 'Open in chebnet',
};
