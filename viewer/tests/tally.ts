// The closing line that `cargo xtask test` adds up.

import type { Reporter, TestCase, TestResult } from "@playwright/test/reporter";

export default class Tally implements Reporter {
  private readonly last = new Map<string, string>();
  private readonly tests = new Map<string, TestCase>();

  onTestEnd(test: TestCase, result: TestResult): void {
    this.last.set(test.id, result.status);
    this.tests.set(test.id, test);
  }

  onEnd(): void {
    const all = [...this.last.values()];
    const passed = all.filter((s) => s === "passed").length;
    const skipped = all.filter((s) => s === "skipped").length;
    for (const [id, test] of this.tests) {
      const status = this.last.get(id);
      const name = test.titlePath().filter(Boolean).join(" › ");
      if (status !== "passed" && status !== "skipped") process.stdout.write(`failed: ${name}\n`);
      // Passed at the second try only: to be looked at, not to be stopped for.
      else if (test.outcome() === "flaky") process.stdout.write(`unsteady: ${name}\n`);
    }
    process.stdout.write(`${passed} passed, ${all.length - passed - skipped} failed, ${skipped} skipped\n`);
  }
}
