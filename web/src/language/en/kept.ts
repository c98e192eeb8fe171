export const kept = {
  restored: 'Your net is as you left it.',
  startAfresh: 'Start afresh',
  restoreLast: 'Restore my last net',
  noOther: 'This browser has kept no other net.',
  lastRestored: 'Your last net is back.',
  opened: 'The project is open.',
  copyOpened: 'The project is open in another tab, too: this is a copy.',
  linkOpened: (title: string | null) => (title === null ? 'The link is open.' : `${title}.`),
  linkFollowed: (title: string | null) =>
    `${title === null ? 'The link is open' : title}. Undo brings back what was here before.`,
  diedKept: 'The page stopped while your last net was open, so it was not opened again by itself.',
  diedLink: 'The page stopped while this link was open, so it was not opened again by itself.',
  openAnyway: 'Open it',
  notKept: 'This browser does not let the page keep your net. Save it as a project before you leave.',
  wouldBeLost:
    'This browser does not keep your net: the project would replace it for good. Save it first, or open the project again.',
  fault: (file: string, reason: string) => `${file}: ${reason}`,
};
