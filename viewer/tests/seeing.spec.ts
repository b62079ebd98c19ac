// What a first user looked for: the end first, cuts that can be read, a range that one stray does not spoil, supports, a
// scene before it is run.

import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { expect, frame, pixels, settled, shoot, stage, test } from "./serve";

/** Two bricks on a held one; gravity along -y. */
const TOWER = `
riprap = 1
title = "a tower along y"
[space.spatial]
gravity = ["0 m/s2", "-9.81 m/s2", "0 m/s2"]
[materials.granite]
density = "2600 kg/m3"
young = "20 GPa"
poisson = 0.25
[interfaces.default]
friction_angle = "30 deg"
[[blocks]]
name = "tower"
material = "granite"
grid.box = { size = ["1 m", "4 m", "1 m"], cell = "1 m" }
[[supports]]
on = { block = "tower.1" }
fixed = {}
[[phases]]
name = "stand"
until = { time = "1 ms" }
`;

test("a finished run opens at its last frame", async ({ view }) => {
  const page = await view("topple");
  const last = Number(await page.locator(".scrub").getAttribute("max"));
  expect(last).toBeGreaterThan(10);
  expect(await frame(page)).toBe(last);
  await expect(page.locator(".timeline small")).toHaveText(`${last + 1} of ${last + 1}`);
});

/** The highest number of the legend. */
async function highest(page: Page): Promise<number> {
  const said = await page.locator(".legend .tick").allTextContents();
  return Math.max(...said.map(Number));
}

test("colours span most blocks, and say how many lie beyond", async ({ view }) => {
  const page = await view("blast");
  // Blocks over the charge move half as far again as the rest of the fastest hundredth. Their largest speeds would not do: those
  // of the eight finest bricks are the same to six digits, of which the range of most leaves five out.
  await page.getByLabel("field", { exact: true }).selectOption("displacement");
  await expect(page.getByLabel("range of the colours")).toHaveValue("most");
  await page.getByLabel("clipping plane").selectOption("y");
  await expect.poll(async () => Number(await stage(page).getAttribute("data-cut"))).toBeGreaterThan(20);
  await expect(page.locator(".legend")).toContainText("beyond");
  const low = await highest(page);
  const most = await settled(page);
  await shoot(page, "range-most");
  await page.getByLabel("range of the colours").selectOption("run");
  await expect(page.locator(".legend")).not.toContainText("beyond");
  expect(await highest(page)).toBeGreaterThan(1.2 * low);
  expect(await settled(page)).not.toBe(most);
  await shoot(page, "range-run");
  // And back: what is left of one range in the other would show.
  await page.getByLabel("range of the colours").selectOption("most");
  await expect(page.locator(".legend")).toContainText("beyond");
  expect(await settled(page)).toBe(most);
});

test("of blocks that differ by less than a colour none lies beyond", async ({ view }) => {
  const page = await view("blast");
  await page.getByLabel("field", { exact: true }).selectOption("peak_speed");
  await expect(page.getByLabel("range of the colours")).toHaveValue("most");
  await expect(page.locator(".legend")).toContainText("peak_speed");
  await expect(page.locator(".legend")).not.toContainText("beyond");
});

test("a flat cut lies off the faces and has the colours of the legend", async ({ view }) => {
  const page = await view("blast");
  // The middle of a lattice is a plane of faces.
  await page.getByLabel("field", { exact: true }).selectOption("");
  await page.getByLabel("clipping plane").selectOption("y");
  await page.keyboard.press("2");
  await expect.poll(async () => Number(await stage(page).getAttribute("data-cut"))).toBeGreaterThan(20);
  await page.keyboard.press("e");
  await page.waitForTimeout(300);
  // One colour for everything: seen from the front, the middle of the cut has exactly it.
  const colours = await stage(page).evaluate((canvas) => {
    const from = canvas as HTMLCanvasElement;
    const copy = document.createElement("canvas");
    copy.width = from.width;
    copy.height = from.height;
    const ctx = copy.getContext("2d", { willReadFrequently: true })!;
    ctx.drawImage(from, 0, 0);
    const seen = new Set<string>();
    // Beside the star of the charge.
    for (let i = 4; i <= 10; i++) {
      for (let j = -3; j <= 3; j++) {
        const x = Math.round(from.width / 2 + 15 * i);
        const y = Math.round(from.height / 2 + 15 * j);
        seen.add([...ctx.getImageData(x, y, 1, 1).data.slice(0, 3)].join(","));
      }
    }
    return [...seen];
  });
  await shoot(page, "cut-unlit");
  expect(colours).toEqual(["185,168,140"]);
});

test("supports can be shown", async ({ view }) => {
  const page = await view("topple");
  const plain = await pixels(page);
  await page.keyboard.press("u");
  await expect(page.locator(".legend")).toContainText("2 held or moved");
  await expect.poll(() => pixels(page)).not.toBe(plain);
  await shoot(page, "supports");
});

test("a scene is shown before it is run, on its feet, and again when it is saved", async ({ view }) => {
  const file = join(mkdtempSync(join(tmpdir(), "riprap-seeing-")), "tower.toml");
  writeFileSync(file, TOWER);
  const page = await view(file);
  await expect(page.locator(".badge")).toHaveText("not run");
  await expect(stage(page)).toHaveAttribute("data-blocks", "4");
  await page.getByLabel("field", { exact: true }).selectOption("material");
  await expect(page.locator(".legend")).toContainText("granite");
  await page.keyboard.press("u");
  await expect(page.locator(".legend")).toContainText("1 held or moved");
  await shoot(page, "preview");
  // The tower is taller than wide on the screen: y is up.
  const up = await page.locator(".triad text").allTextContents();
  expect(up).toEqual(["x", "y", "z"]);
  const ends = await page.locator(".triad line").evaluateAll((lines) =>
    lines.map((l) => Number(l.getAttribute("y1")) - Number(l.getAttribute("y2"))),
  );
  expect(ends[1]).toBeGreaterThan(15);
  writeFileSync(file, TOWER.replace('"4 m"', '"6 m"'));
  await expect(stage(page)).toHaveAttribute("data-blocks", "6", { timeout: 15_000 });
  writeFileSync(file, TOWER.replace("density", "densty"));
  await expect(page.locator(".banner")).toContainText("did you mean `density`", { timeout: 15_000 });
  await shoot(page, "preview-wrong");
  writeFileSync(file, TOWER);
  await expect(stage(page)).toHaveAttribute("data-blocks", "4", { timeout: 15_000 });
});
