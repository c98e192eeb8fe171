import type { kept as en } from '../en/kept';
import type { Widened } from '../words';

export const kept: Widened<typeof en> = {
  restored: '已恢复到您离开时的状态。',
  startAfresh: '重新开始',
  restoreLast: '恢复上次的网',
  noOther: '本浏览器没有保存其他的网。',
  lastRestored: '上次的网已恢复。',
  opened: '项目已打开。',
  copyOpened: '此项目也在另一标签页中打开：这里是副本。',
  linkOpened: (title) => (title === null ? '链接已打开。' : `${title}。`),
  linkFollowed: (title) => `${title === null ? '链接已打开' : title}。撤销即可恢复之前的内容。`,
  diedKept: '上次的网打开时页面意外停止，因此没有自动打开。',
  diedLink: '打开此链接时页面意外停止，因此没有自动打开。',
  openAnyway: '仍然打开',
  notKept: '浏览器不允许本页保存您的网。离开前请保存项目。',
  wouldBeLost: '浏览器没有保存您的网：打开项目会永久取代它。请先保存，或再次打开该项目。',
  fault: (file, reason) => `${file}：${reason}`,
};
