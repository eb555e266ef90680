// How long the page's engine takes for a pair: engine_times.mjs SOURCE TARGET TIMES, as JSON: milliseconds of each run to read
// both, to match (with verifying and making the report), bytes of memory, and the match file.
import { readInto, startEngine } from "./engine.mjs";

const [source, target, times] = process.argv.slice(2);
const found = { reading: [], matching: [], memory: 0, match: "" };
for (let i = 0; i < Number(times); ++i) {
  const stages = new Map();
  const engine = await startEngine({ stage: (text) => stages.set(text, performance.now()), progress() {} });
  const began = performance.now();
  await readInto(engine, "source", source);
  await readInto(engine, "target", target);
  found.reading.push(performance.now() - began);
  engine.match();
  found.matching.push(stages.get("verifying") - stages.get("matching"));
  found.memory = engine.memoryBytes;
  found.match = new TextDecoder().decode(engine.matchFile());
}
console.log(JSON.stringify(found));
