// Pictures of the templates for the book: the models as `riprap view SCENE` shows them before they run. Not a test that CI runs:
//   cd viewer && RIPRAP_TEMPLATES=../docs/src/img npx playwright test templates.spec.ts

import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { BINARY } from "./runs";
import { settled, stage, test } from "./serve";

/** Templates of the usual first tasks, the field that colours them (none: one colour). */
const TEMPLATES: [string, string][] = [
  ["slope", "block"],
  ["wet_slope", "block"],
  ["wet_block", "block"],
  ["dam", "block"],
  ["tunnel", "block"],
  ["bolted_tunnel", "block"],
  ["rockfall", "material"],
  ["blast", ""],
  ["shaken_wall", "material"],
  ["mapped_joints", "block"],
  ["voronoi", "block"],
  ["caving", "material"],
  ["drift", "block"],
  ["pit", "block"],
  ["house_wall", "block"],
  ["doorway", "block"],
  ["vault", "block"],
  ["dome", "block"],
  ["buttress", "block"],
  ["pit_ramp", "block"],
];

for (const [name, field] of TEMPLATES) {
  test(`picture of ${name}`, async ({ view }) => {
    const folder = mkdtempSync(join(tmpdir(), "riprap-template-"));
    execFileSync(BINARY, ["new", name, "--template", name], { cwd: folder, stdio: "ignore" });
    const page = await view(join(folder, `${name}.toml`));
    await page.getByLabel("field", { exact: true }).selectOption(field);
    await page.keyboard.press("m");
    await page.setViewportSize({ width: 660, height: 420 });
    await page.keyboard.press("f");
    await settled(page);
    await page.addStyleTag({ content: ".legend, .triad { display: none !important }" });
    const png = await stage(page).screenshot({ type: "png" });
    writeFileSync(join(process.env.RIPRAP_TEMPLATES ?? folder, `template-${name}.png`), png);
  });
}
