/** What the dialogs say that lead to another net, in the visitor's language. It comes with them, apart from all other words. */
import { dialogs as en } from './en/dialogs';
import { language } from './language';
import { dialogs as zh } from './zh/dialogs';

export const dialogWords = { en, zh }[language];
