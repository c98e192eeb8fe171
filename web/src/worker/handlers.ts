/** What is done with each kind of message; `also` is what else is known of it. A kind without a handler is an error of types. */
export type Handlers<Message extends { type: string }, Result = void, Also extends unknown[] = []> = {
  readonly [Type in Message['type']]: (message: Extract<Message, { type: Type }>, ...also: Also) => Result;
};

export function handleBy<Message extends { type: string }, Result, Also extends unknown[]>(
  handlers: Handlers<Message, Result, Also>,
  message: Message,
  ...also: Also
): Result {
  const handler = handlers[message.type as Message['type']] as (message: Message, ...also: Also) => Result;
  return handler(message, ...also);
}
