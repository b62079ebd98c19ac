import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { BINARY, RUNS, run } from "./runs";
import { PICTURES, expect, frame, pickSome, pixels, shoot, test } from "./serve";

test("a report is one file that plays and prints", async ({ page, allow }) => {
  void allow;
  const file = join(RUNS, "blast.html");
  execFileSync(BINARY, ["report", run("blast"), "-o", file], { stdio: ["ignore", "ignore", "ignore"] });
  const asked: string[] = [];
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) asked.push(request.url());
  });
  await page.goto(`file://${file}`);
  await page.waitForSelector("html[data-ready]");
  for (const head of ["Checks", "Replay", "Plots", "Energy ledger", "The scene as run", "Versions and hashes"]) {
    await expect(page.locator("h2", { hasText: head })).toBeVisible();
  }
  await expect(page.locator("tr.passed").first()).toBeVisible();
  expect(await page.locator("article > figure img").count()).toBeGreaterThan(4);
  const first = await pixels(page);
  await page.locator(".stage > canvas").click();
  await page.keyboard.press("End");
  await expect.poll(() => frame(page)).toBeGreaterThan(5);
  await expect.poll(() => pixels(page)).not.toBe(first);
  await page.getByLabel("field", { exact: true }).selectOption("velocity");
  await expect(page.locator(".legend .title")).toHaveText(/^velocity/);
  // Arrows, contacts, and numbers of single blocks.
  await page.keyboard.press("v");
  await expect(page.locator(".legend")).toContainText("longest velocity");
  await page.keyboard.press("c");
  await expect(page.locator(".legend")).toContainText(/broken \d+/);
  await page.keyboard.press("k");
  await shoot(page, "report-cracks");
  await page.keyboard.press("k");
  await pickSome(page);
  await expect(page.locator(".pickhead b")).toHaveText(/\D/);
  await expect(page.locator(".numbers")).toContainText("peak_speed");
  await page.locator(".pickhead").getByText("history").click();
  await expect(page.locator(".chart .u-title")).toHaveText(/displacement/);
  await page.getByRole("tab", { name: "Histories" }).click();
  await expect(page.locator(".chart").first()).toBeVisible();
  await shoot(page, "report");
  await page.emulateMedia({ media: "print" });
  await page.screenshot({ path: join(PICTURES, "report-print.png"), fullPage: true });
  expect(asked).toEqual([]);
});
