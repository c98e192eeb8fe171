/** English. A section for each part of the page. */
export const en = {
  handles: {
    none: 'No handles. Click a vertex of the net to take hold of it.',
  },
};
