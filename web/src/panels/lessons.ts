/** What the net shows on request. */
export const LESSONS = ['net', 'deviation', 'energy', 'stages'] as const;
export type Lesson = (typeof LESSONS)[number];
