// The flat cut: areas of caps against what geometry says. Needs no page.

import { expect, test } from "@playwright/test";
import { caps, normalInPlane, normalOf, sides, type Cut, type Solids } from "../src/section";
import { prism, SQUARE, U } from "./prism";

function cutAt(normal: [number, number, number], at: number, keep: 1 | -1 = 1): Cut {
  return { normal, at, keep, flat: true };
}

/** Area of the caps, and its part along a direction: how they face. */
function area(solids: Solids, cut: Cut): { size: number; facing: number } {
  const { triangles } = caps(solids, cut, [0]);
  let size = 0;
  let facing = 0;
  for (let t = 0; t < triangles.length; t += 9) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = triangles.slice(t, t + 9) as [number, number, number, number, number, number, number, number, number];
    const [ux, uy, uz, vx, vy, vz] = [bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    size += 0.5 * Math.hypot(nx, ny, nz);
    facing += 0.5 * (nx * cut.normal[0] + ny * cut.normal[1] + nz * cut.normal[2]) * cut.keep;
  }
  return { size, facing };
}

test("caps of a cube have the area of the section and face what was taken away", () => {
  const cube = prism(SQUARE);
  const half = Math.SQRT1_2;
  const cases: [Cut, number][] = [
    [cutAt([1, 0, 0], 0.25), 1],
    [cutAt([0, 0, 1], 0.9, -1), 1],
    [cutAt([half, half, 0], half), Math.SQRT2],
    // The regular hexagon through the middle.
    [cutAt([1, 1, 1].map((v) => v / Math.sqrt(3)) as [number, number, number], 1.5 / Math.sqrt(3)), (3 * Math.sqrt(3)) / 4],
  ];
  for (const [cut, expected] of cases) {
    const { size, facing } = area(cube, cut);
    expect(size).toBeCloseTo(expected, 5);
    expect(facing).toBeCloseTo(-expected, 5);
  }
});

test("a body that is not convex gets one cap for each part", () => {
  const towers = prism(U);
  const { size } = area(towers, cutAt([0, 1, 0], 1.5));
  expect(size).toBeCloseTo(2, 5);
  // Through the base; through one tower; across, where the cap itself is not convex.
  expect(area(towers, cutAt([0, 1, 0], 0.5)).size).toBeCloseTo(3, 5);
  expect(area(towers, cutAt([1, 0, 0], 0.5)).size).toBeCloseTo(2, 5);
  expect(area(towers, cutAt([0, 0, 1], 0.5)).size).toBeCloseTo(5, 5);
});

test("only blocks that the plane crosses are cut", () => {
  const cube = prism(SQUARE);
  const side = (at: number) => {
    const out = new Uint8Array(1);
    sides(cube, cutAt([1, 0, 0], at), 1e-5, out);
    return out[0];
  };
  expect([side(-0.5), side(0), side(0.5), side(1), side(1.5)]).toEqual([1, 1, 2, 0, 0]);
});

test("polygons in the plane get lines", () => {
  const flat: Solids = { ...prism(SQUARE), dimension: 2, facesOf: Uint32Array.of(0, 1), faceEnds: Uint32Array.of(0, 4), corners: Uint32Array.of(0, 1, 2, 3) };
  const made = caps(flat, cutAt([1, 0, 0], 0.25), [0]);
  expect(made.triangles).toEqual([]);
  const [ax, ay, , bx, by] = made.lines as [number, number, number, number, number];
  expect([ax, bx]).toEqual([0.25, 0.25]);
  expect(Math.abs(by - ay)).toBeCloseTo(1, 6);
});

test("planes by dip and dip direction", () => {
  const close = (found: number[], wanted: number[]) => found.forEach((v, k) => expect(v).toBeCloseTo(wanted[k]!, 9));
  close(normalOf(0, 123), [0, 0, 1]);
  close(normalOf(90, 90), [1, 0, 0]);
  close(normalOf(90, 0), [0, 1, 0]);
  close(normalInPlane(0), [0, 1, 0]);
  close(normalInPlane(90), [-1, 0, 0]);
});
