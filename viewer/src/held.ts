// Numbers of single blocks in a report: put together from the fields that it holds.

import type { BlockNumbers, Run } from "./run";
import { Problem } from "./source";

/** The contents of names.json (docs/src/run-folder.md). */
export interface Names {
  blocks: { first: number; name: string; from?: number; count?: number }[];
  groups: { name: string; blocks: [number, number][] }[];
}

/** Name of a block by its number; empty where it has none. */
export function nameOf(names: Names, id: number): string {
  // Entries ascend by their first number.
  const run = names.blocks.findLast((r) => r.first <= id);
  if (!run || id >= run.first + (run.count ?? 1)) return "";
  return run.from === undefined ? run.name : `${run.name}.${run.from + id - run.first}`;
}

/** Place of a block in frame `k`; below zero if it is not there. */
async function placeOf(run: Run, k: number, id: number): Promise<number> {
  const motion = await run.motion(k);
  const shape = await run.shape(motion.info.shape, k);
  return shape.u32("ids").indexOf(id);
}

/** As the answer `block` of the server. */
export async function heldBlock(run: Run, k: number, id: number): Promise<BlockNumbers> {
  const at = await placeOf(run, k, id);
  if (at < 0) throw new Problem(`there is no block ${id} in this frame`, "It was split, cut or removed.");
  const { held, names: fields, fields: known } = run.summary;
  const columns = await Promise.all(
    (fields ?? []).map(async (name) => {
      const components = known.find((f) => f.name === name)?.components ?? 1;
      if (held!.vectors.includes(name)) {
        const packet = await run.vectors(k, name);
        return { name, unit: packet.info.unit, values: [...packet.f32("values").subarray(3 * at, 3 * at + components)] };
      }
      const packet = await run.field(k, name).catch(() => null);
      return { name, unit: packet?.info.unit ?? "", values: packet ? [packet.f32("values")[at]!] : [] };
    }),
  );
  const { names } = run;
  const groups = names.groups.filter((g) => g.blocks.some(([a, b]) => a <= id && id <= b)).map((g) => g.name);
  return { block: id, name: nameOf(names, id), groups, frame: k, columns: columns.filter((c) => c.values.length > 0) };
}

/** As the answers `history` of the server. */
export async function heldHistory(
  run: Run,
  id: number,
  name: string,
  more: (values: (number | null)[], unit: string) => boolean,
): Promise<void> {
  const values: (number | null)[] = [];
  let unit = "";
  for (let k = 0; k < run.frames; k++) {
    const at = await placeOf(run, k, id);
    const field = at < 0 ? null : await run.field(k, name).catch(() => null);
    unit = field?.info.unit ?? unit;
    const value = field?.f32("values")[at];
    values.push(value !== undefined && Number.isFinite(value) ? value : null);
  }
  more(values, unit);
}
