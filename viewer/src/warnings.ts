// Blocks that warnings name: their messages hold names of blocks and groups in backticks.

import type { Names } from "./held";

/** Numbers of the blocks that a message names, ascending; a name of a table or group means all its blocks. */
export function blocksOf(message: string, names: Names): number[] {
  const found = new Set<number>();
  const add = (first: number, last: number) => {
    for (let b = first; b <= last; b++) found.add(b);
  };
  for (const [, name] of message.matchAll(/`([^`]+)`/g)) {
    const [, base, digits] = /^(.*)\.(\d+)$/.exec(name!) ?? [];
    for (const run of names.blocks) {
      const count = run.count ?? 1;
      if (run.name === name) add(run.first, run.first + count - 1);
      else if (run.from !== undefined && run.name === base) {
        const at = Number(digits) - run.from;
        if (at >= 0 && at < count) add(run.first + at, run.first + at);
      }
    }
    for (const group of names.groups) if (group.name === name) for (const [first, last] of group.blocks) add(first, last);
  }
  return [...found].sort((a, b) => a - b);
}
