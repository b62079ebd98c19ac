import { readFileSync } from "node:fs";
import { unzipSync } from "fflate";
import { expect, frame, pickSome, pixels, shoot, stage, test } from "./serve";

test("a planar run plays, scrubs, colours, picks and plots", async ({ view }) => {
  const page = await view("topple");
  await expect(page.locator("h1")).toContainText(/topple|column/i);
  await expect(page.locator(".badge")).toHaveText("finished");
  // What it is made of comes first, any other field after one click.
  await expect(page.locator(".legend .title")).toHaveText("material");
  await page.getByRole("button", { name: "displacement", exact: true }).click();
  await expect(page.locator(".legend .title")).toHaveText(/^displacement/);
  // A finished run opens at its last frame.
  await page.keyboard.press("Home");
  await expect.poll(() => frame(page)).toBe(0);
  const first = await pixels(page);

  await page.keyboard.press(" ");
  await expect.poll(() => frame(page)).toBeGreaterThan(3);
  await page.keyboard.press(" ");
  // A picture that was asked for before may still come.
  await expect(async () => {
    const stopped = await frame(page);
    await page.waitForTimeout(400);
    expect(await frame(page)).toBe(stopped);
  }).toPass({ timeout: 30_000 });
  await expect.poll(() => pixels(page)).not.toBe(first);

  await page.locator(".scrub").fill("15");
  await expect.poll(() => frame(page)).toBe(15);
  await page.locator(".scrub").blur();
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => frame(page)).toBe(16);
  await page.keyboard.press("End");
  await expect.poll(() => frame(page)).toBeGreaterThan(18);

  const before = await pixels(page);
  await page.getByLabel("field", { exact: true }).selectOption("velocity.x");
  await expect(page.locator(".legend .title")).toHaveText(/^velocity.x \[.*m\/s\]/);
  await expect.poll(() => pixels(page)).not.toBe(before);
  await page.getByLabel("range of the colours").selectOption("fixed");
  for (const [label, value] of [["lowest value", "-0.5"], ["highest value", "0.5"]] as const) {
    await page.getByLabel(label).fill(value);
    await page.getByLabel(label).press("Enter");
  }
  await expect(page.locator(".legend .tick").last()).toHaveText(/500|0.5/);

  await pickSome(page);
  await expect(page.locator(".numbers")).toContainText("displacement");
  await expect(page.locator(".numbers")).toContainText("rad");
  await page.locator(".pickhead").getByText("history").click();
  await expect(page.locator(".chart .u-title")).toHaveText(/displacement/);
  await page.getByRole("tab", { name: "Histories" }).click();
  await expect(page.locator(".chart").first()).toBeVisible();
  await shoot(page, "planar");
  // A click in a plot goes to its time.
  const plot = (await page.locator(".u-over").first().boundingBox())!;
  await page.mouse.click(plot.x + 0.25 * plot.width, plot.y + 0.5 * plot.height);
  await expect.poll(() => frame(page)).toBeLessThan(10);
});

test("arrows, contacts, exaggeration and cutting in the plane", async ({ view }) => {
  const page = await view("topple");
  await page.locator(".scrub").fill("8");
  await expect.poll(() => frame(page)).toBe(8);
  const plain = await pixels(page);
  await page.locator(".scrub").blur();
  await page.keyboard.press("v");
  await expect(page.locator(".legend")).toContainText("longest velocity");
  await page.keyboard.press("c");
  await expect(page.locator(".legend")).toContainText("sliding");
  await page.getByText("touching").click();
  await shoot(page, "planar-arrows");
  await expect.poll(() => pixels(page)).not.toBe(plain);
  await page.getByLabel("vectors").selectOption("contact force");
  await expect(page.locator(".legend")).toContainText("longest contact force");
  await page.keyboard.press("]");
  await expect(page.locator(".legend")).toContainText("displacements × 2");
  await page.getByRole("button", { name: "true", exact: true }).click();
  await page.getByLabel("clipping plane").selectOption("x");
  const cut = await pixels(page);
  await page.getByText("flip").click();
  await expect.poll(() => pixels(page)).not.toBe(cut);
});

test("a deformable beam: cut blocks, cracks, names", async ({ view }) => {
  const page = await view("beam");
  await page.keyboard.press("Home");
  await expect.poll(() => frame(page)).toBe(0);
  const before = Number(await stage(page).getAttribute("data-blocks"));
  await page.keyboard.press("End");
  await expect.poll(() => frame(page)).toBeGreaterThan(2);
  // Blocks were cut on the way.
  await expect.poll(async () => Number(await stage(page).getAttribute("data-blocks"))).toBeGreaterThan(before);
  await page.getByLabel("field", { exact: true }).selectOption("sigma3_compressive");
  await expect(page.locator(".legend .title")).toHaveText(/sigma3_compressive \[.*Pa\]/);
  await page.getByRole("button", { name: "visible", exact: true }).click();
  await expect(page.locator(".legend")).toContainText("displacements ×");
  await shoot(page, "beam");
  const solid = await pixels(page);
  await page.keyboard.press("k");
  await expect(page.locator(".legend")).toContainText("broken");
  await expect.poll(() => pixels(page)).not.toBe(solid);
  await shoot(page, "beam-cracks");
  await page.keyboard.press("k");
  await pickSome(page);
  await expect(page.locator(".pickhead b")).toHaveText(/^beam\.\d+/);
  await expect(page.locator(".numbers")).toContainText("broken_share");
  await shoot(page, "beam-picked");
});

test("a blast: faces, cracks, cut, glass, views", async ({ view }) => {
  const page = await view("blast");
  await page.keyboard.press("End");
  await expect.poll(() => frame(page)).toBeGreaterThan(5);
  const blocks = Number(await stage(page).getAttribute("data-blocks"));
  const faces = Number(await stage(page).getAttribute("data-faces"));
  expect(blocks).toBeGreaterThan(500);
  // Faces between neighbours that have not parted are left out.
  expect(faces).toBeLessThan(3 * blocks);
  await shoot(page, "blast");
  await page.getByLabel("field", { exact: true }).selectOption("sigma1_compressive");
  await expect(page.locator(".legend .title")).toHaveText(/sigma1_compressive \[.*Pa\]/);
  await page.getByText("powers of ten").click();
  await page.getByLabel("clipping plane").selectOption("y");
  await shoot(page, "blast-cut");
  await pickSome(page);
  await expect(page.locator(".numbers")).toContainText("peak_speed");
  await page.keyboard.press("Escape");
  await page.keyboard.press("k");
  await expect(page.locator(".legend")).toContainText("broken");
  await page.keyboard.press("v");
  await shoot(page, "blast-cracks");
  await page.keyboard.press("k");
  await page.keyboard.press("v");
  await page.keyboard.press("x");
  await page.keyboard.press("x");
  await page.getByRole("button", { name: "visible", exact: true }).click();
  await expect(page.locator(".legend")).toContainText("displacements ×");
  await page.keyboard.press("3");
  await shoot(page, "blast-above");
  // Turning by hand changes the picture.
  const box = (await stage(page).boundingBox())!;
  const still = await pixels(page);
  await page.mouse.move(box.x + 300, box.y + 300);
  await page.mouse.down();
  await page.mouse.move(box.x + 380, box.y + 260, { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => pixels(page)).not.toBe(still);
});

test("two runs side by side share time and camera", async ({ view }) => {
  const page = await view("topple", "steep");
  await expect(page.locator(".stage")).toHaveCount(2);
  await page.locator(".scrub").fill("14");
  await expect.poll(() => frame(page, 0)).toBeGreaterThan(5);
  await expect.poll(() => frame(page, 1)).toBeGreaterThan(5);
  const second = await pixels(page, 1);
  const box = (await stage(page, 0).boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.wheel(0, -400);
  await expect.poll(() => pixels(page, 1)).not.toBe(second);
  await page.keyboard.press("f");
  await page.keyboard.press("p");
  await expect(page.locator(".chart").first()).toBeVisible();
  await shoot(page, "two-runs");
});

test("a picture and all frames are saved", async ({ view }) => {
  const page = await view("steep");
  const saved = async (label: string) => {
    const waiting = page.waitForEvent("download", { timeout: 50_000 });
    await page.getByRole("button", { name: label, exact: true }).click();
    const download = await waiting;
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  };
  await page.getByText("Save", { exact: true }).click();
  const picture = await saved("Picture");
  expect(picture.name).toMatch(/^steep_\d+\.png$/);
  expect(picture.bytes.subarray(1, 4).toString()).toBe("PNG");
  const frames = await saved("All frames");
  const inside = unzipSync(frames.bytes);
  const count = Object.keys(inside).length;
  expect(count).toBeGreaterThan(8);
  expect(Object.values(inside).every((png) => png[1] === 0x50 && png.length > 2000)).toBe(true);
});

test("keys, dark and light, and a phone", async ({ view }) => {
  const page = await view("blast");
  await page.keyboard.press("?");
  await expect(page.locator("dialog.sheet")).toBeVisible();
  await shoot(page, "keys");
  await page.keyboard.press("Escape");
  await page.emulateMedia({ colorScheme: "dark" });
  await page.keyboard.press("End");
  await page.keyboard.press("p");
  await expect(page.locator(".chart").first()).toBeVisible();
  await shoot(page, "dark");
  await page.keyboard.press("t");
  await expect(page.locator("html")).toHaveAttribute("data-theme", "light");
  await page.setViewportSize({ width: 390, height: 844 });
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  await page.keyboard.press("End");
  await shoot(page, "phone");
  await page.keyboard.press("m");
  await expect(page.locator(".panel")).toBeVisible();
  await shoot(page, "phone-panel");
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(wide).toBeLessThanOrEqual(390);
});
