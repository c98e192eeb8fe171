import type { en } from './en';

/** What every language must have: the same names, texts where English has texts, functions where it has functions. */
export type Words = Widened<typeof en>;
export type Widened<T> = T extends (...given: infer Given) => infer Result
  ? (...given: Given) => Result extends string ? string : Result
  : T extends string
    ? string
    : { [K in keyof T]: Widened<T[K]> };
