// One small run of each engine: played, scrubbed, picked, coloured, cut, compared, saved; nothing may be complained about.

import { readFileSync } from "node:fs";
import { expect, frame, pickSome, pixels, shoot, stage, test } from "./serve";

interface Engine {
  run: string;
  dimension: 2 | 3;
  fields: string[];
}

const ENGINES: Engine[] = [
  { run: "topple", dimension: 2, fields: ["rotation", "spin", "material"] },
  { run: "blast", dimension: 3, fields: ["pressure", "broken_share", "level"] },
  { run: "beam", dimension: 3, fields: ["sigma1_compressive", "broken_share", "block"] },
  { run: "soft", dimension: 3, fields: ["sigma3_compressive", "broken_share"] },
  { run: "hybrid", dimension: 3, fields: ["velocity.x", "sigma1_compressive"] },
];

// Drawn by the processor, on machines that may be busy.
test.setTimeout(180_000);

for (const { run, dimension, fields } of ENGINES) {
  test(`${run}: everything that can be done`, async ({ view }) => {
    const page = await view(run);
    // Played.
    await page.getByLabel("frames per second").selectOption("20");
    await page.locator("body").press(" ");
    await expect.poll(() => frame(page)).toBeGreaterThan(1);
    await page.locator("body").press(" ");
    // Scrubbed.
    await page.locator(".scrub").fill("1");
    await expect.poll(() => frame(page)).toBe(1);
    await page.locator(".scrub").blur();
    await page.keyboard.press("End");
    const last = Number(await page.locator(".scrub").getAttribute("max"));
    await expect.poll(() => frame(page)).toBe(last);
    await page.getByRole("button", { name: "visible", exact: true }).click();
    await shoot(page, `${run}-end`);
    // Coloured.
    let before = await pixels(page);
    for (const field of fields) {
      await page.getByLabel("field", { exact: true }).selectOption(field);
      await expect(page.locator(".legend .title")).toHaveText(new RegExp(`^${field.replace(".", "\\.")}`));
      await expect.poll(() => pixels(page)).not.toBe(before);
      before = await pixels(page);
    }
    // Picked.
    await page.locator("canvas").first().focus();
    await pickSome(page);
    await expect(page.locator(".numbers")).toContainText("displacement");
    await page.keyboard.press("Escape");
    // Cut: flat along each axis, any plane, whole blocks.
    for (const axis of dimension === 3 ? ["x", "y", "z", "free"] : ["x", "y", "free"]) {
      before = await pixels(page);
      await page.getByLabel("clipping plane").selectOption(axis);
      await expect.poll(() => pixels(page)).not.toBe(before);
      await shoot(page, `${run}-cut-${axis}`);
    }
    before = await pixels(page);
    await page.locator("canvas").first().focus();
    await page.keyboard.press("b");
    await expect.poll(() => pixels(page)).not.toBe(before);
    await page.getByLabel("clipping plane").selectOption("");
    // Contacts and cracks.
    await page.keyboard.press("c");
    await expect(page.locator(".legend")).toContainText("sliding");
    if (dimension === 3) await page.keyboard.press("k");
    await shoot(page, `${run}-contacts`);
    // Saved.
    await page.getByText("Save", { exact: true }).click();
    const waiting = page.waitForEvent("download");
    await page.getByRole("button", { name: "Picture", exact: true }).click();
    const picture = readFileSync(await (await waiting).path());
    expect(picture.subarray(1, 4).toString()).toBe("PNG");
    // Dark, and on a phone.
    await page.keyboard.press("t");
    await shoot(page, `${run}-dark`);
    await page.keyboard.press("t");
    await page.setViewportSize({ width: 390, height: 844 });
    await page.reload();
    await page.waitForSelector("html[data-ready]");
    await page.keyboard.press("End");
    await expect.poll(() => frame(page)).toBe(last);
    await shoot(page, `${run}-phone`);
  });
}

test("a flat cut fills what it opens, and what was cut can be picked", async ({ view }) => {
  const page = await view("blast");
  await page.keyboard.press("End");
  await expect.poll(() => frame(page)).toBeGreaterThan(5);
  await page.keyboard.press("x");
  await page.keyboard.press("x");
  await expect(page.locator(".legend")).toContainText("cut at y =");
  const cut = Number(await stage(page).getAttribute("data-cut"));
  expect(cut).toBeGreaterThan(20);
  await shoot(page, "flat-cut");
  const here = await pixels(page);
  await page.locator("canvas").first().focus();
  await page.keyboard.press(".");
  await expect.poll(() => pixels(page)).not.toBe(here);
  await page.keyboard.press("o");
  await shoot(page, "flat-cut-other-side");
  await page.keyboard.press("o");
  await pickSome(page);
  await expect(page.locator(".numbers")).toContainText("displacement");
  await page.keyboard.press("x");
  await page.keyboard.press("x");
  await expect(page.locator(".legend")).toContainText("dip/direction");
  const free = await pixels(page);
  await page.getByLabel("dip of the cut").fill("30");
  await expect.poll(() => pixels(page)).not.toBe(free);
  await page.getByLabel("dip direction of the cut").fill("200");
  await expect(page.locator(".legend")).toContainText("30°/200°");
  await shoot(page, "flat-cut-free");
});

test("facets that break are told from those that soften, with their areas", async ({ view }) => {
  const page = await view("beam");
  await page.keyboard.press("End");
  await expect.poll(() => frame(page)).toBeGreaterThan(2);
  await page.keyboard.press("k");
  await expect(page.locator(".legend")).toContainText(/broken in (tension|shear) \d+ \(.*m²\)/);
  await expect(page.locator(".legend")).not.toContainText("open");
  const soft = await view("soft");
  await soft.keyboard.press("End");
  await soft.keyboard.press("k");
  await expect(soft.locator(".legend")).toContainText(/softened \d+ \(.*m²\)/);
  await shoot(soft, "softened");
});

test("joints of the plane that broke have marks", async ({ view }) => {
  const page = await view("joints");
  await page.keyboard.press("End");
  await page.keyboard.press("c");
  await expect(page.locator(".legend")).toContainText(/broken [1-9]\d* \(.* m\)/);
  await shoot(page, "joints");
});

test("frames of static phases are named by phase and step", async ({ view }) => {
  const page = await view("beam");
  await expect(page.locator(".timeline .time b")).toHaveText(/^break, step [1-9]\d+$/);
  await page.keyboard.press("Home");
  await expect(page.locator(".timeline .time b")).toHaveText("bend, step 0");
  await page.keyboard.press("ArrowRight");
  await expect(page.locator(".timeline .time b")).toHaveText(/^\w+, step [1-9]\d+$/);
  await page.keyboard.press("p");
  await expect(page.locator(".chart .u-legend").first()).toContainText("step");
});

test("runs of two engines side by side", async ({ view }) => {
  const page = await view("blast", "hybrid");
  await expect(page.locator(".stage")).toHaveCount(2);
  await page.keyboard.press("End");
  await page.keyboard.press("x");
  await expect(page.locator(".legend").first()).toContainText("cut at x =");
  await shoot(page, "two-engines");
  await page.setViewportSize({ width: 390, height: 844 });
  await shoot(page, "two-engines-phone");
});
