// What has a switch and a key of its own: bolts and charges.

import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, settled, shoot, test } from "./serve";

test("bolts are drawn and can be switched, by key and in the panel", async ({ view }) => {
  const page = await view("bolts");
  const legend = page.locator(".legend");
  // A quarter of the weight of the block in each of four bolts, 25.5 kN, at the joint.
  await expect(legend).toContainText(/bolts up to 25\.\d kN/);
  const drawn = await settled(page);
  await shoot(page, "bolts");
  await page.keyboard.press("r");
  await expect(legend).not.toContainText("bolts");
  const bare = await settled(page);
  expect(bare).not.toBe(drawn);
  await page.getByLabel("bolts", { exact: true }).check();
  await expect(legend).toContainText("bolts up to");
  expect(await settled(page)).toBe(drawn);
  // The first frame is older than the bolts.
  await page.keyboard.press("Home");
  await expect(legend).not.toContainText("bolts");
});

/** A bench with two charges: a point and a line. */
const BENCH = `
riprap = 1
title = "two charges"
[space.spatial]
gravity = "9.81 m/s2"
[materials.rock]
density = "2600 kg/m3"
young = "20 GPa"
poisson = 0.25
[interfaces.default]
friction_angle = "40 deg"
[[blocks]]
name = "bench"
material = "rock"
grid.box = { size = ["8 m", "5 m", "5 m"], cell = "1 m" }
[sources.point.pressure_cavity]
centre = ["1.5 m", "2.5 m", "2.5 m"]
pressure = { constant = "1 MPa" }
[sources.hole.pressure_cavity]
line = { from = ["5.5 m", "2.5 m", "0.5 m"], to = ["5.5 m", "2.5 m", "3.5 m"] }
pressure = { constant = "1 MPa" }
[[phases]]
name = "blast"
until = { time = "1 ms" }
`;

test("charges are drawn before and after the blast, with a switch of their own", async ({ view }) => {
  const file = join(mkdtempSync(join(tmpdir(), "riprap-marks-")), "bench.toml");
  writeFileSync(file, BENCH);
  const page = await view(file);
  const legend = page.locator(".legend");
  await expect(legend).toContainText("2 charges");
  const drawn = await settled(page);
  await shoot(page, "charges");
  await page.keyboard.press("i");
  await expect(legend).not.toContainText("charge");
  const bare = await settled(page);
  expect(bare).not.toBe(drawn);
  // Nothing else brings them back.
  await page.keyboard.press("k");
  const glass = await settled(page);
  await page.getByLabel("charges", { exact: true }).check();
  await expect(legend).toContainText("2 charges");
  expect(await settled(page)).not.toBe(glass);
  await shoot(page, "charges-glass");
  await page.keyboard.press("k");
  expect(await settled(page)).toBe(drawn);
});

test("the charge of a run is named", async ({ view }) => {
  const page = await view("blast");
  await expect(page.locator(".legend")).toContainText("charge");
  await shoot(page, "blast-charge");
  await page.keyboard.press("i");
  await expect(page.locator(".legend")).not.toContainText("charge");
});

/** A pile of which one stone is made too small to be meant, and nothing holds it. */
const SLIVER = `
riprap = 1
title = "a sliver in a wall"
[space.planar]
gravity = ["0 m/s2", "-9.81 m/s2"]
[materials.rock]
density = "2600 kg/m3"
[interfaces.default]
normal_stiffness = "10 GPa/m"
friction_angle = "30 deg"
[[blocks]]
name = "wall"
material = "rock"
wall = { corner = ["0 m", "0 m"], block = ["1 m", "0.5 m"], courses = 6, per_course = 6, bond = "running" }
[[blocks]]
name = "chip"
material = "rock"
rectangle = { size = ["0.5 m", "1 mm"], corner = ["2 m", "3.1 m"] }
[[phases]]
name = "fall"
until = { time = "1 ms" }
`;

test("warnings of a scene are marked at their blocks and lead there, also when it was saved", async ({ view }) => {
  const file = join(mkdtempSync(join(tmpdir(), "riprap-marks-")), "sliver.toml");
  writeFileSync(file, SLIVER);
  const page = await view(file);
  const warnings = page.locator("details", { hasText: "Warnings (" });
  await expect(warnings.locator("summary")).toHaveText("Warnings (2)");
  await expect(page.locator(".legend")).toContainText("1 block with warnings");
  // What names no block is told, too, and leads nowhere.
  await expect(warnings.locator("p.warning")).toContainText("no block is held or supported");
  const far = await settled(page);
  await shoot(page, "warned");
  await warnings.getByRole("button", { name: /chip.*sliver/ }).click();
  await expect(page.locator(".pickhead b")).toHaveText("chip");
  expect(await settled(page)).not.toBe(far);
  await shoot(page, "warned-block");
  // Mended and saved: the picture is without marks, and what is left is listed.
  writeFileSync(file, SLIVER.replace('"1 mm"', '"0.5 m"'));
  await expect(warnings.locator("summary")).toHaveText("Warnings (1)");
  await expect(page.locator(".legend")).not.toContainText("with warnings");
});
