// Bundles the page into crates/riprap-view/assets and records of which sources it was made.
// A Rust test computes the same hash, so that a stale bundle is found without Node.
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = fileURLToPath(new URL(".", import.meta.url));
const out = join(here, "../crates/riprap-view/assets");

/** Everything that the bundle is made of, in the order of the names. */
function sources() {
  const src = readdirSync(join(here, "src"), { recursive: true, withFileTypes: true })
    .filter((e) => e.isFile())
    .map((e) => join(e.parentPath, e.name).slice(here.length).replaceAll("\\", "/"));
  return [...src, "build.mjs", "package.json", "package-lock.json", "tsconfig.json"].sort();
}

const hash = createHash("sha256");
for (const name of sources()) {
  hash.update(name + "\n");
  hash.update(readFileSync(join(here, name), "utf8").replaceAll("\r\n", "\n"));
}

await build({
  entryPoints: { app: join(here, "src/main.ts") },
  outdir: out,
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  legalComments: "inline",
  logLevel: "info",
});
writeFileSync(join(out, "index.html"), readFileSync(join(here, "src/index.html")));
writeFileSync(join(out, "sources.sha256"), hash.digest("hex") + "\n");
