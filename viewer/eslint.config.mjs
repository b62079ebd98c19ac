import tseslint from "typescript-eslint";

export default tseslint.config(
  { ignores: ["node_modules/", "test-results/", "playwright-report/"] },
  ...tseslint.configs.strict,
  {
    rules: {
      eqeqeq: "error",
      "no-console": "error",
      "prefer-const": "error",
      // Typed arrays are read by index all over; a check at each would hide the computation.
      "@typescript-eslint/no-non-null-assertion": "off",
    },
  },
);
