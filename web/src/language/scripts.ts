/** What is said of arguments of `window.chebnet`, in the visitor's language. It comes with their readers. */
import { scripts as en } from './en/scripts';
import { language } from './language';
import { scripts as zh } from './zh/scripts';

export const scriptWords = { en, zh }[language];
