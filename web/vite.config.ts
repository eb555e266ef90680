// The viewer as one HTML file: script and style stand in it, nothing is loaded.
import { defineConfig } from "vitest/config";
import { viteSingleFile } from "vite-plugin-singlefile";

export default defineConfig({
  base: "./",
  test: { include: ["tests/*.test.ts"] },
  plugins: [viteSingleFile({ removeViteModuleLoader: true })],
  esbuild: { charset: "ascii", legalComments: "none" },
  build: {
    target: "es2021",
    outDir: "../build/web",
    emptyOutDir: true,
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    rollupOptions: { input: "report.html" },
  },
});
