// Pictures of the templates for the book: the models as `riprap view SCENE` shows them before they run. Not a test that CI runs:
//   cd viewer && RIPRAP_TEMPLATES=../docs/src/img npx playwright test templates.spec.ts

import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { BINARY } from "./runs";
import { settled, stage, test } from "./serve";

/** Templates of the usual first tasks. */
const TEMPLATES = [
  "slope",
  "wet_slope",
  "wet_block",
  "dam",
  "tunnel",
  "bolted_tunnel",
  "rockfall",
  "blast",
  "shaken_wall",
  "mapped_joints",
  "voronoi",
  "caving",
  "drift",
  "pit",
  "house_wall",
  "doorway",
  "arcade",
  "vault",
  "dome",
  "buttress",
  "pit_ramp",
  "bolted_wedge",
  "wedge",
  "bricks",
  "beam",
  "pour",
  "arch",
  "wall",
  "topple",
];

for (const name of TEMPLATES) {
  test(`picture of ${name}`, async ({ view }) => {
    const folder = mkdtempSync(join(tmpdir(), "riprap-template-"));
    execFileSync(BINARY, ["new", name, "--template", name], { cwd: folder, stdio: "ignore" });
    const page = await view(join(folder, `${name}.toml`));
    await page.keyboard.press("m");
    await page.setViewportSize({ width: 660, height: 420 });
    await page.keyboard.press("f");
    await settled(page);
    await page.addStyleTag({ content: ".legend, .triad { display: none !important }" });
    const png = await stage(page).screenshot({ type: "png" });
    writeFileSync(join(process.env.RIPRAP_TEMPLATES ?? folder, `template-${name}.png`), png);
  });
}
