/** The page's engine without a browser: src/page/engine.ts over build/wasm/quadmatch.wasm, in node. */
import { readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { build } from "esbuild";
import { ROOT } from "./root.mjs";

async function engineClass() {
  const entry = join(ROOT, "web/src/page/engine.ts");
  const { outputFiles } = await build({ entryPoints: [entry], bundle: true, format: "esm", target: "es2021", write: false });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`);
}

const { Engine } = await engineClass();
const module = await WebAssembly.compile(readFileSync(join(ROOT, "build/wasm/quadmatch.wasm")));

export function startEngine(listener = { stage() {}, progress() {} }) {
  return Engine.start(module, listener);
}

/** Read a file into a slot, under its name without the folder; returns warnings. */
export function readInto(engine, slot, path) {
  const bytes = readFileSync(path);
  return engine.read(slot, basename(path), { size: bytes.length, piece: async (from, to) => bytes.subarray(from, to) });
}
