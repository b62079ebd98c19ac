// What a first user looked for: the end first, cuts that can be read, a range that one stray does not spoil, supports, a
// scene before it is run.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { BINARY, ROOT } from "./runs";
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
  await page.getByLabel("field", { exact: true }).selectOption("held");
  await page.getByLabel("clipping plane").selectOption("y");
  await page.keyboard.press("2");
  await expect.poll(async () => Number(await stage(page).getAttribute("data-cut"))).toBeGreaterThan(20);
  await page.keyboard.press("e");
  // One colour for all that is free: seen from the front, the middle of the cut has exactly it.
  const colours = () => stage(page).evaluate((canvas) => {
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
  await expect.poll(colours).toEqual(["78,121,167"]);
  await shoot(page, "cut-unlit");
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
  await expect(stage(page)).toHaveAttribute("data-blocks", "6");
  writeFileSync(file, TOWER.replace("density", "densty"));
  await expect(page.locator(".banner")).toContainText("did you mean `density`");
  await shoot(page, "preview-wrong");
  writeFileSync(file, TOWER);
  await expect(stage(page)).toHaveAttribute("data-blocks", "4");
});

/** A bank of rock with every kind of boundary, a load, a water table and two materials. */
const BANK = `
riprap = 1
title = "what holds and what pushes"
[space.spatial]
gravity = "9.81 m/s2"
found_contacts = false
[materials.rock]
density = "2600 kg/m3"
young = "20 GPa"
poisson = 0.25
[materials.steel]
density = "7800 kg/m3"
young = "200 GPa"
poisson = 0.3
[interfaces.rough]
between = ["rock", "rock"]
friction_angle = "40 deg"
[interfaces.smooth]
between = ["rock", "steel"]
friction_angle = "10 deg"
[interfaces.default]
friction_angle = "30 deg"
[[blocks]]
name = "bank"
material = "rock"
grid.box = { size = ["4 m", "3 m", "2 m"], cell = "1 m" }
[[blocks]]
name = "plate"
material = "steel"
brick = { size = ["4 m", "3 m", "0.5 m"], corner = ["0 m", "0 m", "2 m"] }
[[supports]]
on = { block = "plate" }
motion.velocity.z = { constant = "-1 mm/s" }
[[boundaries]]
on.plane = "z-min"
held = {}
[[boundaries]]
on.plane = "x-min"
roller = {}
[[boundaries]]
on.plane = "x-max"
viscous = {}
[[boundaries]]
on.plane = "y-min"
pressure = { value = "2 MPa" }
[[loads]]
on = { block = "bank.1" }
point = { force = ["0 kN", "30 kN", "0 kN"] }
[water.high]
points = [["0 m", "0.5 m"], ["4 m", "1.5 m"]]
[water.low]
level = "0.2 m"
[[phases]]
name = "full"
until = { time = "1 ms" }
water = "high"
[[phases]]
name = "drawn down"
until = { time = "1 ms" }
water = "low"
`;

test("boundaries, loads, water and joints can be shown", async ({ view }) => {
  const file = join(mkdtempSync(join(tmpdir(), "riprap-seeing-")), "bank.toml");
  writeFileSync(file, BANK);
  const page = await view(file);
  const legend = page.locator(".legend");
  // The table of the first phase is there; nothing else is before it is asked for.
  await expect(legend).toContainText("water table high");
  await expect(legend).not.toContainText("rollers");
  const wet = await settled(page);
  await page.keyboard.press("w");
  await expect(legend).not.toContainText("water table");
  let before = await settled(page);
  expect(before).not.toBe(wet);
  const changes = async (key: string, ...said: string[]) => {
    await page.keyboard.press(key);
    for (const text of said) await expect(legend).toContainText(text);
    const now = await settled(page);
    expect(now).not.toBe(before);
    before = now;
  };
  // 4 x 3 faces below, 3 x 2 at each end, 4 x 2 and the side of the plate in front.
  await changes("h", "held: 12 faces", "rollers: 7 faces", "viscous: 7 faces", "loaded: 9 faces");
  await shoot(page, "boundaries");
  await changes("l", "force 30 kN", "9 faces loaded, up to 2 MPa");
  // What stands outside is in view when all is asked for.
  await changes("f");
  await shoot(page, "loads");
  await page.keyboard.press("h");
  await page.keyboard.press("l");
  await changes("u", "1 held or moved", "1 of them driven");
  await page.keyboard.press("u");
  await expect(legend).not.toContainText("held or moved");
  await changes("j", "set 1: 00°/–, 24 m²", "set 2: 90°/090°, 18 m²", "set 3: 90°/000°, 16 m²");
  await shoot(page, "joint-sets");
  await changes("j", "rough: 46 m²", "smooth: 12 m²");
  await shoot(page, "joint-laws");
  await changes("j");
  await expect(legend).not.toContainText("rough");
  await changes("w", "water table high");
});

/** A wall in the plane between two plates, one of which is pressed. */
const PLATES = `
riprap = 1
title = "a pressed wall"
[space.planar]
gravity = ["0 m/s2", "-9.81 m/s2"]
[materials.rock]
density = "2600 kg/m3"
[interfaces.default]
normal_stiffness = "10 GPa/m"
friction_angle = "30 deg"
[[blocks]]
name = "foot"
material = "rock"
rectangle = { size = ["4 m", "1 m"], corner = ["0 m", "0 m"] }
[[blocks]]
name = "left"
material = "rock"
rectangle = { size = ["1 m", "2 m"], corner = ["0 m", "1 m"] }
[[blocks]]
name = "right"
material = "rock"
rectangle = { size = ["2 m", "2 m"], corner = ["1 m", "1 m"] }
[[supports]]
on = { block = "foot" }
fixed = {}
[[loads]]
on = { block = "right" }
edge = { from = ["1 m", "3 m"], to = ["3 m", "3 m"], pressure = ["1 MPa", "2 MPa"] }
[water.river]
points = [["0 m", "2 m"], ["4 m", "0.5 m"]]
[[phases]]
name = "press"
until = { time = "1 ms" }
`;

test("loads, water and joints of the plane can be shown", async ({ view }) => {
  const file = join(mkdtempSync(join(tmpdir(), "riprap-seeing-")), "plates.toml");
  writeFileSync(file, PLATES);
  const page = await view(file);
  const legend = page.locator(".legend");
  await expect(legend).toContainText("water table river");
  const plain = await settled(page);
  await page.keyboard.press("l");
  await expect(legend).toContainText("7 arrows of pressure, up to 2 MPa");
  const loaded = await settled(page);
  expect(loaded).not.toBe(plain);
  await page.keyboard.press("f");
  // Pieces of edges count: the foot reaches beyond the wall on it.
  await page.keyboard.press("j");
  await expect(legend).toContainText("set 1: 0° from x, 3 m");
  await expect(legend).toContainText("set 2: 90° from x, 2 m");
  expect(await settled(page)).not.toBe(loaded);
  await shoot(page, "planar-loads");
  await page.keyboard.press("j");
  await expect(legend).toContainText("default: 5 m");
});

test("water that seeps has arrows", async ({ view }) => {
  // Of a run: before the first step nothing has flowed.
  const folder = mkdtempSync(join(tmpdir(), "riprap-seeing-"));
  const [file, out] = [join(folder, "seeping.toml"), join(folder, "seeping.run")];
  writeFileSync(file, PLATES.replace("[[phases]]", '[water.river.seepage]\naperture = "1 mm"\n[[phases]]'));
  execFileSync(BINARY, ["run", file, "-q", "-o", out], { stdio: "ignore" });
  const page = await view(out);
  const plain = await settled(page);
  await page.getByLabel("vectors").selectOption("seepage flow");
  await expect(page.locator(".legend")).toContainText(/longest seepage flow .*m2\/s/);
  expect(await settled(page)).not.toBe(plain);
  await shoot(page, "seepage");
});

test("a line between two places has a length and the field along it", async ({ view }) => {
  const file = join(mkdtempSync(join(tmpdir(), "riprap-seeing-")), "plates.toml");
  writeFileSync(file, PLATES);
  const page = await view(file);
  await page.getByLabel("field", { exact: true }).selectOption("block");
  const box = (await stage(page).boundingBox())!;
  // The model is 4 m wide and 3 m high, in the middle of the picture.
  const perMetre = box.height / (2 * 0.53 * Math.max(3, (4 * box.height) / box.width));
  const click = (x: number, y: number) => page.mouse.click(box.x + box.width / 2 + (x - 2) * perMetre, box.y + box.height / 2 - (y - 1.5) * perMetre);
  const legend = page.locator(".legend");
  await page.keyboard.press("d");
  // A few pixels off: corners attract.
  await click(0.02, 2.98);
  await expect(legend).toContainText("click its other end");
  await click(2.98, 2.98);
  await expect(legend).toContainText("distance 3 m (3, 0)");
  // Taken away, and another one: from the foot through the left block.
  await page.keyboard.press("d");
  await expect(legend).not.toContainText("distance");
  await page.keyboard.press("d");
  const again = (await stage(page).boundingBox())!;
  const scale = again.height / (2 * 0.53 * Math.max(3, (4 * again.height) / again.width));
  const there = (x: number, y: number) => page.mouse.click(again.x + again.width / 2 + (x - 2) * scale, again.y + again.height / 2 - (y - 1.5) * scale);
  await there(0.5, 0.5);
  await there(0.5, 2.5);
  await expect(legend).toContainText(/distance (2|1\.99\d*|2\.00\d*) m/);
  await expect(page.locator(".chart .u-title")).toHaveText("block");
  await shoot(page, "line");
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "CSV" }).click()]);
  expect(download.suggestedFilename()).toMatch(/_block_line\.csv$/);
  const rows = readFileSync(await download.path(), "utf8").trim().split("\n").map((r) => r.split(","));
  expect(rows[0]).toEqual(["from [m]", "to [m]", "block", "name", "block"]);
  expect(rows.slice(1).map((r) => r[3])).toEqual(["foot", "left"]);
  await expect(legend).toContainText("right");
  // Half a metre in the foot, the rest in the block; clicks are good to a pixel.
  const [foot, left] = rows.slice(1).map((r) => r.map(Number));
  expect(foot![0]).toBe(0);
  expect(Math.abs(foot![1]! - 0.5)).toBeLessThan(2 / scale);
  expect(left![0]).toBeCloseTo(foot![1]!, 6);
  expect(Math.abs(left![1]! - 2)).toBeLessThan(3 / scale);
});

test("the field along a line goes through the rock", async ({ view }) => {
  const page = await view("blast");
  await page.getByRole("button", { name: "displacement", exact: true }).click();
  await page.getByLabel("clipping plane").selectOption("y");
  await expect.poll(async () => Number(await stage(page).getAttribute("data-cut"))).toBeGreaterThan(20);
  await page.keyboard.press("2");
  const box = (await stage(page).boundingBox())!;
  await page.keyboard.press("d");
  // On a busy machine a program clicks before the picture has turned, where there is no rock yet, and again before the first end is looked up.
  const first = page.getByText("click its other end");
  await expect(async () => {
    if (!(await first.isVisible())) await page.mouse.click(box.x + 0.35 * box.width, box.y + 0.55 * box.height);
    await expect(first).toBeVisible({ timeout: 5_000 });
  }).toPass({ timeout: 90_000 });
  await page.mouse.click(box.x + 0.65 * box.width, box.y + 0.5 * box.height);
  await expect(page.locator(".chart .u-title")).toHaveText(/^displacement/);
  await shoot(page, "line-blast");
  const read = async () => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "CSV" }).click()]);
    const rows = readFileSync(await download.path(), "utf8").trim().split("\n").slice(1);
    return rows.map((r) => r.split(",")).map((r) => [r[0], r[1], r[2], r[4]].map(Number));
  };
  const rows = await read();
  expect(rows.length).toBeGreaterThan(4);
  // Blocks follow each other without a gap, but for the cavity and for what has opened.
  rows.slice(1).forEach((row, k) => expect(row[0]).toBeGreaterThan(rows[k]![1]! - 0.05));
  // What the server says of a block.
  const [, , id, value] = rows[1]!;
  const k = Number(await stage(page).getAttribute("data-frame"));
  const block = (await (await page.request.get(`${page.url()}api/0/block/${k}/${id}`)).json()) as { columns: { name: string; values: number[] }[] };
  const shift = block.columns.find((c) => c.name === "displacement")!.values;
  expect(value! / Math.hypot(...shift)).toBeCloseTo(1, 5);
  // The plot follows the frame.
  await page.keyboard.press("Home");
  await expect.poll(async () => (await read()).every((r) => r[3] === 0)).toBe(true);
});

/** Pixels of the picture that have one of the colours of crosses: compression, tension. */
async function crossed(page: Page): Promise<[number, number]> {
  return stage(page).evaluate((canvas) => {
    const from = canvas as HTMLCanvasElement;
    const copy = document.createElement("canvas");
    copy.width = from.width;
    copy.height = from.height;
    const ctx = copy.getContext("2d", { willReadFrequently: true })!;
    ctx.drawImage(from, 0, 0);
    const { data } = ctx.getImageData(0, 0, copy.width, copy.height);
    const found: [number, number] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      const rgb = [data[i], data[i + 1], data[i + 2]].join(",");
      if (rgb === "29,95,208") found[0]++;
      if (rgb === "208,28,28") found[1]++;
    }
    return found;
  });
}

test("principal stresses of the plane are crosses", async ({ view }) => {
  // 8 and 3 MPa, turned by 20 degrees, before anything has moved.
  const page = await view(join(ROOT, "scenes/verify/engineering/in_situ_inclined.toml"));
  await page.getByLabel("field", { exact: true }).selectOption("");
  await expect(page.locator(".legend")).not.toContainText("compression");
  const plain = await settled(page);
  expect(await crossed(page)).toEqual([0, 0]);
  await page.keyboard.press("a");
  await expect(page.locator(".legend")).toContainText("compression up to 8 MPa");
  await expect(page.locator(".legend")).toContainText("longest cross 8 MPa");
  await expect(page.locator(".legend")).not.toContainText("tension");
  expect(await settled(page)).not.toBe(plain);
  const [pressed, pulled] = await crossed(page);
  expect(pressed).toBeGreaterThan(300);
  expect(pulled).toBe(0);
  await shoot(page, "stress-plane");
  await page.keyboard.press("a");
  await expect(page.locator(".legend")).not.toContainText("compression");
  expect(await settled(page)).toBe(plain);
});

test("principal stresses in space are crosses on a cut, and bending has both colours", async ({ view }) => {
  const page = await view("beam");
  await page.getByLabel("field", { exact: true }).selectOption("");
  await page.getByLabel("clipping plane").selectOption("y");
  await page.keyboard.press("2");
  await expect.poll(async () => Number(await stage(page).getAttribute("data-cut"))).toBeGreaterThan(0);
  const plain = await settled(page);
  await page.getByLabel("stress", { exact: true }).check();
  await expect(page.locator(".legend")).toContainText("compression up to");
  await expect(page.locator(".legend")).toContainText("tension up to");
  expect(await settled(page)).not.toBe(plain);
  const [pressed, pulled] = await crossed(page);
  expect(pressed).toBeGreaterThan(20);
  expect(pulled).toBeGreaterThan(20);
  await shoot(page, "stress-space");
});

test("deformable blocks have crosses in their tetrahedra where the run has written these", async ({ view }) => {
  const page = await view("soft");
  await page.getByLabel("field", { exact: true }).selectOption("");
  await page.getByLabel("clipping plane").selectOption("y");
  await page.keyboard.press("2");
  await expect.poll(async () => Number(await stage(page).getAttribute("data-cut"))).toBeGreaterThan(0);
  await page.keyboard.press("a");
  await expect(page.locator(".legend")).toContainText("tension up to");
  // The legend stands before the picture does.
  await settled(page);
  const [pressed, pulled] = await crossed(page);
  expect(pressed).toBeGreaterThan(20);
  expect(pulled).toBeGreaterThan(20);
  await shoot(page, "stress-tetrahedra");
});
