// A line through blocks of any form. Needs no page.

import { expect, test } from "@playwright/test";
import * as THREE from "three";
import { piecesAlong } from "../src/line";
import { prism, SQUARE, U } from "./prism";

/** Stretches of a line as block, from, to. */
function stretches(solids: Parameters<typeof piecesAlong>[0], a: [number, number, number], b: [number, number, number]): number[][] {
  const round = (share: number) => Math.round(1e6 * share) / 1e6;
  return piecesAlong(solids, new THREE.Vector3(...a), new THREE.Vector3(...b)).map((p) => [p.block, round(p.from), round(p.to)]);
}

test("a line through a block with a notch leaves the notch out", () => {
  const towers = prism(U);
  expect(stretches(towers, [-1, 1.5, 0.5], [4, 1.5, 0.5])).toEqual([[0, 0.2, 0.4], [0, 0.6, 0.8]]);
  expect(stretches(towers, [-1, 0.5, 0.5], [4, 0.5, 0.5])).toEqual([[0, 0.2, 0.8]]);
  // Down through a tower and up from the notch.
  expect(stretches(towers, [0.5, 3, 0.5], [0.5, -1, 0.5])).toEqual([[0, 0.25, 0.75]]);
  expect(stretches(towers, [1.5, 1.5, 0.5], [1.5, 5, 0.5])).toEqual([]);
  // Through its hollow faces, inside the material and in the notch.
  expect(stretches(towers, [0.5, 1.5, -1], [0.5, 1.5, 3])).toEqual([[0, 0.25, 0.5]]);
  expect(stretches(towers, [1.5, 1.5, -1], [1.5, 1.5, 3])).toEqual([]);
});

test("a line along faces and edges meets a block once or not at all", () => {
  const brick = prism(SQUARE);
  for (const [y, z] of [[0.5, 0.5], [0, 0], [0, 0.5], [0.5, 0], [0.3, 0.3]] as const) {
    expect(stretches(brick, [-1, y, z], [4, y, z])).toEqual([[0, 0.2, 0.4]]);
  }
  for (const [y, z] of [[1, 0.5], [0.5, 1], [1, 1], [2, 0.5]] as const) expect(stretches(brick, [-1, y, z], [4, y, z])).toEqual([]);
  expect(stretches(brick, [-1, -1, -1], [2, 2, 2])).toEqual([[0, 0.333333, 0.666667]]);
  // Ends inside.
  expect(stretches(brick, [0.25, 0.5, 0.5], [0.75, 0.5, 0.5])).toEqual([[0, 0, 1]]);
});
