/** Texts about experiments in the visitor's language, loaded with them, apart from all other texts. */
import { experiments as en } from '../language/en/experiments';
import { language } from '../language/language';
import { experiments as zh } from '../language/zh/experiments';

export const texts = { en, zh }[language];
