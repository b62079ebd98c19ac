// Force chains: tubes through contacts by their force.

import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { BINARY } from "./runs";
import { expect, pixels, settled, shoot, test } from "./serve";

/** Four bricks of 1 m3 and 2600 kg/m3 on each other, the lowest held: the lowest contact carries three. */
const TOWER = `
riprap = 1
title = "a tower at rest"
[space.spatial]
gravity = "10 m/s2"
[materials.granite]
density = "2600 kg/m3"
young = "20 GPa"
poisson = 0.25
[interfaces.default]
normal_stiffness = "1 GPa/m"
shear_stiffness = "1 GPa/m"
friction_angle = "30 deg"
[[blocks]]
name = "tower"
material = "granite"
grid.box = { size = ["1 m", "1 m", "4 m"], cell = "1 m" }
[[supports]]
on = { block = "tower.1" }
fixed = {}
[[phases]]
name = "rest"
kind = "static"
until = { unbalanced = 1e-8, steps = 20000 }
`;

test("force chains lead the weight of a tower down, and their legend tells the largest force", async ({ view }) => {
  const folder = mkdtempSync(join(tmpdir(), "riprap-chains-"));
  writeFileSync(join(folder, "tower.toml"), TOWER);
  execFileSync(BINARY, ["run", "tower.toml", "--out", "tower.run", "--quiet"], { cwd: folder, stdio: "ignore" });
  const page = await view(join(folder, "tower.run"));
  await settled(page);
  const before = await pixels(page);
  await page.keyboard.press("n");
  await expect(page.locator(".legend")).toContainText("forces of 3 contacts up to 78 kN");
  await settled(page);
  expect(await pixels(page)).not.toBe(before);
  await shoot(page, "force-chains");
  await expect(page.getByLabel("size of arrows, crosses and chains")).toBeVisible();
  await page.keyboard.press("n");
  await expect(page.locator(".legend")).not.toContainText("forces of");
  await settled(page);
  expect(await pixels(page)).toBe(before);
});

test("force chains in the plane", async ({ view }) => {
  const page = await view("topple");
  await page.keyboard.press("n");
  await expect(page.locator(".legend")).toContainText(/forces of \d+ contacts up to/);
  await settled(page);
  await shoot(page, "force-chains-plane");
});
