import { defineConfig } from "@playwright/test";
import { existsSync } from "node:fs";

/** The distribution's browser, unless another is named. */
const browsers = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
const executablePath = browsers.find((path) => path && existsSync(path));

export default defineConfig({
  testDir: "tests",
  // Speed is measured, and pictures for the book are made, when somebody asks for it.
  testIgnore: [...(process.env.RIPRAP_LARGE ? [] : ["speed.spec.ts"]), ...(process.env.RIPRAP_TEMPLATES ? [] : ["templates.spec.ts"])],
  outputDir: "test-results",
  // Neither needs runs.
  ...(process.env.RIPRAP_TEMPLATES || process.env.RIPRAP_LARGE ? {} : { globalSetup: "./tests/runs.ts" }),
  reporter: [["list"], ["./tests/tally.ts"]],
  // The other steps keep both cores busy, and a machine may be half as fast: what is expected may take its time to come.
  timeout: 180_000,
  expect: { timeout: 30_000 },
  // Clicks and pictures depend on when a loaded machine draws. What is broken fails twice; what passes at the second try is named by the tally.
  retries: 1,
  workers: 1,
  use: {
    ...(executablePath ? { launchOptions: { executablePath, args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"] } } : {}),
    viewport: { width: 1280, height: 800 },
    acceptDownloads: true,
  },
});
