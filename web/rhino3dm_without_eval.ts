/**
 * rhino3dm is compiled so that its glue (Emscripten's embind) writes functions as text and evaluates them, which the page's
 * content security policy forbids. Emscripten has a setting for that, DYNAMIC_EXECUTION=0, which calls the same things from
 * closures; this plugin makes of the glue what that setting would have made of it. If another version of rhino3dm has other
 * glue, the build fails.
 */
import type { Plugin } from 'vite';

const GLUE = /rhino3dm\.module\.js$/;

/** What evaluates text, and what takes its place; both stand in the same scope. */
const CLOSURES: readonly (readonly [evaluation: string, closure: string])[] = [
  // In createJsInvoker(argTypes, isClassMethodFunc, returns): a function of JavaScript that calls one of C++.
  [
    'return new Function(args1,invokerFnBody)',
    `return (humanName, throwBindingError, invoker, fn, runDestructors, fromRetWire) => function (...given) {
      const destructors = needsDestructorStack ? [] : null;
      const wired = [];
      for (let i = isClassMethodFunc ? 1 : 2; i < argTypes.length; ++i)
        wired.push(argTypes[i].toWireType(destructors, i === 1 ? this : given[i - 2]));
      const result = invoker(fn, ...wired);
      if (needsDestructorStack) runDestructors(destructors);
      else wired.forEach((value, i) => argTypes[i + (isClassMethodFunc ? 1 : 2)].destructorFunction?.(value));
      if (returns) return fromRetWire(result);
    }`,
  ],
  // In __emval_create_invoker(argCount, argTypesPtr, kind): a function of C++ that calls one of JavaScript.
  [
    'new Function(Object.keys(captures),functionBody)(...Object.values(captures))',
    `(handle, methodName, destructorsRef, args) => {
      const given = argFromPtr.map((read, i) => read(args + i * GenericWireTypeSize));
      let result;
      if (kind === 0) result = Emval.toValue(handle)(...given);
      else if (kind === 1) result = Emval.toValue(handle)[getStringOrSymbol(methodName)](...given);
      else if (kind === 2) result = new (Emval.toValue(handle))(...given);
      else result = given[0];
      if (!retType.isVoid) return emval_returnValue(toReturnWire, destructorsRef, result);
    }`,
  ],
  // Of use in Node alone.
  ['await import("node:module")', '{}'],
];

export function rhino3dmWithoutEval(): Plugin {
  return {
    name: 'rhino3dm-without-eval',
    transform: { filter: { id: GLUE }, handler: withoutEval },
  };
}

export function withoutEval(glue: string): string {
  const closed = CLOSURES.reduce((code, [evaluation, closure]) => code.replace(evaluation, () => closure), glue);
  if (/new Function|\beval\(/.test(closed))
    throw new Error('rhino3dm has new glue that evaluates text; see rhino3dm_without_eval.ts');
  return closed;
}
