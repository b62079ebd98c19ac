// Where the cut lies that is asked for.

import type { Blocks } from "./blocks";
import { quantity } from "./format";
import { normalInPlane, normalOf, type Cut } from "./section";
import type { Settings } from "./settings";

/** The cut that is asked for, less the origin of what is drawn. */
export function cutOf(blocks: Blocks, settings: Settings): Cut | null {
  const { clipAxis, clipAt, clipDip, clipDirection, clipFlip, clipFlat } = settings;
  const flat = blocks.dimension === 2;
  if (clipAxis === "" || (clipAxis === "z" && flat)) return null;
  let normal: Cut["normal"] = [0, 0, 0];
  if (clipAxis !== "free") normal["xyz".indexOf(clipAxis)] = 1;
  else normal = flat ? normalInPlane(clipDip) : normalOf(clipDip, clipDirection);
  const { low, high } = blocks.shape.info;
  // Ends of the model's box along the normal.
  const reach = [0, 0];
  normal.forEach((n, k) => {
    reach[0] += Math.min(n * low[k]!, n * high[k]!);
    reach[1] += Math.max(n * low[k]!, n * high[k]!);
  });
  const wanted = reach[0]! + clipAt * (reach[1]! - reach[0]!);
  // A flat cut along faces of blocks would show either side of them, or both at once.
  const at = clipFlat ? blocks.clearOf(normal, wanted) : wanted;
  // The camera begins in front, to the left and above: what is nearer to it goes first.
  const upper = clipAxis === "z" || clipAxis === "free";
  return { normal, at, keep: upper === clipFlip ? 1 : -1, flat: clipFlat };
}

/** The cut in the axes of the model: what lies along the normal beyond a place, m, is taken away. */
export function cutAway(blocks: Blocks, settings: Settings): { normal: Cut["normal"]; at: number } | null {
  const cut = cutOf(blocks, settings);
  if (!cut) return null;
  const side = -cut.keep;
  return { normal: cut.normal.map((n) => side * n) as Cut["normal"], at: side * placeAlong(blocks, cut) };
}

/** Where a cut lies along its normal in the axes of the model, m. */
function placeAlong(blocks: Blocks, { normal, at }: Cut): number {
  const { origin } = blocks.shape.info;
  return at + normal.reduce((sum, n, k) => sum + n * origin[k]!, 0);
}

/** Where the cut is, in words; empty without one. */
export function cutText(blocks: Blocks, settings: Settings): string {
  const cut = cutOf(blocks, settings);
  if (!cut) return "";
  const { clipAxis, clipDip, clipDirection } = settings;
  if (clipAxis !== "free") return `cut at ${clipAxis} = ${quantity(placeAlong(blocks, cut), "m", 3)}`;
  const flat = blocks.dimension === 2;
  const angle = (v: number) => String(Math.round(v)).padStart(flat ? 1 : 2, "0");
  return flat ? `cut at ${angle(clipDip)}° from x` : `cut ${angle(clipDip)}°/${angle(clipDirection).padStart(3, "0")}° (dip/direction)`;
}
