// The engine of the page without a browser: the same bytes as of the program, and plain words where memory ends.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { readInto, startEngine } from "./engine.mjs";
import { ROOT } from "./root.mjs";
import { EXAMPLES, folder, run } from "./support.mjs";

const example = (name) => join(EXAMPLES, `${name}.obj`);

/** Match files of both, but for the names of the files. */
async function bothWays(source, target, choices) {
  const engine = await startEngine();
  for (const [name, value] of choices) engine.choose(name, value);
  await readInto(engine, "source", source);
  await readInto(engine, "target", target);
  engine.match();
  const path = join(folder, "match.json");
  run("quadmatch", "match", source, target, "-o", path, "--quiet", ...choices.flatMap(([name, value]) => [`--${name}`, value]));
  const named = (bytes) => bytes.toString("utf8").replaceAll(/"path": "[^"]*\//g, '"path": "');
  return [named(Buffer.from(engine.matchFile())), named(readFileSync(path))];
}

test("WebAssembly finds the same as the program by every algorithm, on examples and on edited copies", async () => {
  const pairs = [["bear", "bear_no_ears_posed"], ["shirt_long", "shirt_short"], ["fig_4_1", "fig_4_2"], ["dog_toy", "dog_toy"]].map((pair) => pair.map(example));
  for (const seed of [1, 2, 3]) {
    const edited = join(folder, `edited_${seed}.obj`);
    run("edit_mesh", example("bear"), edited, "delete:30", "extrude:20", "loop:1", "twist:1", "renumber", "--seed", String(seed));
    pairs.push([example("bear_posed"), edited]);
  }
  for (const [source, target] of pairs) {
    for (const algorithm of ["regions", "lazy-greedy", "greedy"]) {
      const [web, native] = await bothWays(source, target, [["algorithm", algorithm]]);
      assert.equal(web, native, `${source} ${target} ${algorithm}`);
    }
  }
});

test("where memory ends there is a sentence for it, wherever it ends", () => {
  const sphere = join(folder, "sphere.obj");
  run("make_shape", "sphere:100", sphere);
  const seen = new Set();
  for (const pages of [40, 100, 130, 160, 190, 220, 260, 320]) {
    const { status, stderr } = spawnSync("node", [`--wasm-max-mem-pages=${pages}`, join(ROOT, "web/browser/engine_times.mjs"), sphere, sphere, "1"], { encoding: "utf8", stdio: ["ignore", "ignore", "pipe"] });
    if (status === 0) continue;
    const [sentence] = /there is not enough memory: a page has 4 GB at most|sphere\.obj: the file does not fit into memory; split it/.exec(stderr) ?? [];
    assert.ok(sentence, `${pages} pages: ${stderr.slice(-600)}`);
    seen.add(sentence);
  }
  assert.equal(seen.size, 2);
});

test("a file larger than WebAssembly can count is refused before it is read", async () => {
  const engine = await startEngine();
  const vast = { size: 5e9, piece: () => assert.fail("read all the same") };
  await assert.rejects(engine.read("source", "vast.obj", vast), { message: "vast.obj: the file does not fit into memory; split it" });
});

test("the engine says how far it is", async () => {
  const stages = [];
  let most = 0;
  const engine = await startEngine({ stage: (text) => stages.push(text), progress: (_, all) => (most = Math.max(most, all)) });
  await readInto(engine, "source", example("bear"));
  await readInto(engine, "target", example("bear_no_ears_posed"));
  engine.match();
  assert.deepEqual(stages, ["matching", "verifying", "making the report"]);
  assert.equal(most, 2688);
});
