/** The lessons, in the visitor's language. They come when they are wanted, apart from all other words. */
import { learn as en } from './en/learn';
import { language } from './language';
import { learn as zh } from './zh/learn';

export const learnWords = { en, zh }[language];
