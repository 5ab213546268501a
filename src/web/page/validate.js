// Checks of what a page passes in.

/** Returns a number between limits. Throws a RangeError that names any other value. */
export function checkedNumber(what, value, min, max) {
  if (typeof value === "number" && value >= min && value <= max) return value;
  throw new RangeError(`${what} is ${value}, expected a number from ${min} to ${max}`);
}

/** The error of a call that is given up for another one. */
export const abortError = (reason) => new DOMException(reason, "AbortError");
