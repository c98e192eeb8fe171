/** What stands on a page within another one, in the visitor's language. */
import { embed as en } from './en/embed';
import { language } from './language';
import { embed as zh } from './zh/embed';

export const embedWords = { en, zh }[language];
