/** What is said of nets that the browser keeps, of links and of projects as they are opened, in the visitor's language. A first
 *  visit has no use for it. */
import { kept as en } from './en/kept';
import { language } from './language';
import { kept as zh } from './zh/kept';

export const keptWords = { en, zh }[language];
