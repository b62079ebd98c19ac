import { spawn } from "node:child_process";
import { rmSync } from "node:fs";
import { join } from "node:path";
import { BINARY, ROOT, RUNS } from "./runs";
import { expect, frame, shoot, stage, test } from "./serve";

test("a folder that is no run", async ({ view }) => {
  const page = await view("empty");
  await expect(page.locator(".card.problem")).toContainText("manifest.json");
  await expect(page.locator(".card.problem .hint")).toContainText("riprap view");
  await shoot(page, "broken-empty");
});

test("a manifest that was cut off, beside a sound run", async ({ view }) => {
  const page = await view("garbled", "topple");
  await expect(page.locator(".card.problem")).toContainText("not a riprap manifest");
  await expect(stage(page)).toHaveAttribute("data-frame", /^[1-9]\d*$/);
  await shoot(page, "broken-beside");
});

test("a frame that was cut off: the others are shown", async ({ view, allow }) => {
  allow(/422/);
  const page = await view("cut");
  await expect(page.locator(".banner")).toBeHidden();
  await page.locator(".scrub").fill("2");
  await expect(page.locator(".banner")).toContainText("is damaged");
  await shoot(page, "broken-frame");
  await page.locator(".scrub").fill("3");
  await expect(page.locator(".banner")).toBeHidden();
  await expect.poll(() => frame(page)).toBe(3);
});

test("a run whose program died, and one without frames", async ({ view }) => {
  const page = await view("unfinished");
  await expect(page.locator(".badge")).toHaveText("unfinished");
  await page.keyboard.press("p");
  await expect(page.locator(".chart").first()).toBeVisible();
  await page.keyboard.press("End");
  await expect.poll(() => frame(page)).toBeGreaterThan(5);
  const other = await view("frameless");
  await expect(other.locator(".banner")).toContainText("no frames");
  await shoot(other, "frameless");
});

test("a run that goes on is followed to its end, past bad answers", async ({ view, allow }) => {
  const out = join(RUNS, "live.run");
  rmSync(out, { recursive: true, force: true });
  const words = ["run", join(ROOT, "scenes/planar/topple.toml"), "--quiet", "--out", out, "--threads", "1"];
  const going = spawn(BINARY, [...words, "--set", "outputs.0.frames.every=20 ms", "--set", "phases.1.until.time=1.2 s"]);
  const ended = new Promise((done) => going.on("exit", done));
  await expect.poll(() => going.exitCode ?? "running").toBe("running");
  await new Promise((done) => setTimeout(done, 300));
  const page = await view("live");
  allow(/422/);
  let asked = 0;
  await page.route("**/summary", async (route) => {
    if (++asked > 2) await route.continue();
    else await route.fulfill({ status: 422, json: { what: "the list was half written", hint: "Ask again." } });
  });
  await expect(page.locator(".badge")).toHaveText(/running|finished/);
  await expect.poll(() => frame(page)).toBeGreaterThan(3);
  await ended;
  await expect(page.locator(".badge")).toHaveText("finished");
  await expect.poll(() => frame(page)).toBeGreaterThan(40);
});
