/** What is wrong with links, and with what only they and projects have, in the visitor's language. It comes with their reader. */
import { reading as en } from './en/reading';
import { language } from './language';
import { reading as zh } from './zh/reading';

export const readingWords = { en, zh }[language];
