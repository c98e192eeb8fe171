/** What the page says of experiments, in the visitor's language. It comes with them, apart from all its other words. */
import { experiments as en } from '../language/en/experiments';
import { language } from '../language/language';
import { experiments as zh } from '../language/zh/experiments';

export const texts = { en, zh }[language];
