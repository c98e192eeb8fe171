/** What the panels say that come after the first picture, in the visitor's language. */
import { panels as en } from './en/panels';
import { language } from './language';
import { panels as zh } from './zh/panels';

export const panelWords = { en, zh }[language];
