// Force chains: tubes through contacts by their force.

import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { BINARY } from "./runs";
import { expect, pixels, settled, shoot, stage, test } from "./serve";

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

test("a tube ends at its contact with ground", async ({ view }) => {
  const folder = mkdtempSync(join(tmpdir(), "riprap-slab-"));
  // A brick near the edge of a slab whose middle is 3 m away.
  const brick = 'grid.box = { size = ["1 m", "1 m", "1 m"], cell = "1 m", corner = ["3 m", "0 m", "0 m"] }';
  const slab = '[[blocks]]\nname = "slab"\nmaterial = "granite"\ngrid.box = { size = ["7 m", "1 m", "1 m"], cell = ["7 m", "1 m", "1 m"], corner = ["-3 m", "0 m", "-1 m"] }';
  const scene = TOWER.replace(/grid\.box = .*/, brick).replace("[[supports]]", `${slab}\n[[supports]]`).replace('block = "tower.1"', 'block = "slab"');
  writeFileSync(join(folder, "slab.toml"), scene);
  execFileSync(BINARY, ["run", "slab.toml", "--out", "slab.run", "--quiet"], { cwd: folder, stdio: "ignore" });
  const page = await view(join(folder, "slab.run"));
  await page.keyboard.press("n");
  await expect(page.locator(".legend")).toContainText("force of 1 contact up to 26 kN");
  await settled(page);
  // The middle of the slab is three edges of the brick away from it.
  const wide = await stage(page).evaluate((canvas) => {
    const { width, height } = canvas as HTMLCanvasElement;
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [width, height];
    const ctx = copy.getContext("2d")!;
    ctx.drawImage(canvas as HTMLCanvasElement, 0, 0);
    const { data } = ctx.getImageData(0, 0, width, height);
    const red = Array.from({ length: width * height }, (_, i) => i).filter((i) => data[4 * i]! > 110 && data[4 * i + 1]! < 60 && data[4 * i + 2]! < 60);
    const across = red.map((i) => i % width);
    return { count: red.length, share: (Math.max(...across) - Math.min(...across)) / width };
  });
  expect(wide.count).toBeGreaterThan(20);
  expect(wide.share).toBeLessThan(0.08);
  await shoot(page, "force-chains-slab");
});

test("force chains in the plane", async ({ view }) => {
  const page = await view("topple");
  await page.keyboard.press("n");
  await expect(page.locator(".legend")).toContainText(/forces of \d+ contacts up to/);
  await settled(page);
  await shoot(page, "force-chains-plane");
});
