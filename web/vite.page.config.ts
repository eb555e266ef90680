// The page as a static folder. Its addresses are relative, so any folder of any web server will do.
import { defineConfig } from "vite";

export default defineConfig({
  base: "./",
  esbuild: { charset: "ascii", legalComments: "none" },
  worker: { format: "iife" },
  build: {
    target: "es2021",
    outDir: "../build/page",
    emptyOutDir: true,
    modulePreload: false,
    // The engine stands in a script: the page's policy lets scripts in, and allows no request for anything else.
    assetsInlineLimit: (file) => (file.endsWith(".wasm") ? true : undefined),
    chunkSizeWarningLimit: 4000,
    rollupOptions: { input: "index.html" },
  },
});
