import { expect, test } from "vitest";
import { dropped, endingOf, stemOf } from "../src/page/files";
import { systemCalls } from "../src/page/wasi";

test("two files are source and target, three are a base and its edits", () => {
  expect(dropped({}, ["a", "b"], null)).toEqual({ source: "a", target: "b" });
  expect(dropped({ source: "x", other: "y" }, ["a", "b"], null)).toEqual({ source: "a", target: "b" });
  expect(dropped({}, ["a", "b", "c"], "target")).toEqual({ source: "a", target: "b", other: "c" });
});

test("one file goes where it is dropped, else it makes a pair whole or begins a new one", () => {
  expect(dropped({ source: "a" }, ["c"], "other")).toEqual({ source: "a", other: "c" });
  expect(dropped({}, ["a"], null)).toEqual({ source: "a" });
  expect(dropped({ source: "a" }, ["b"], null)).toEqual({ source: "a", target: "b" });
  expect(dropped({ source: "a", target: "b" }, ["c"], null)).toEqual({ source: "c" });
});

test("no file and too many are answered with a sentence", () => {
  expect(dropped({}, [], null)).toMatch(/two meshes/);
  expect(dropped({}, ["a", "b", "c", "d"], null)).toMatch(/^4 files are too many/);
});

test("a file is saved in the format of the target, where we write that", () => {
  expect(["a.PLY", "b.usda", "c.usd", "noname", "d.obj.off"].map(endingOf)).toEqual(["ply", "usda", "obj", "obj", "off"]);
  expect(["a.b.obj", "noname", ".obj"].map(stemOf)).toEqual(["a.b", "noname", ""]);
});

test("the engine's system has a clock that does not run backwards, and no files", () => {
  const memory = new WebAssembly.Memory({ initial: 1 });
  const calls = systemCalls(() => memory, () => {});
  const view = new DataView(memory.buffer);
  const read = () => {
    expect(calls.clock_time_get(1, 0n, 8)).toBe(0);
    return view.getBigUint64(8, true);
  };
  const first = read();
  expect(read()).toBeGreaterThanOrEqual(first);
  expect(calls.path_open()).not.toBe(0);
  expect(calls.fd_read()).not.toBe(0);
});

test("what a failing engine prints is kept", () => {
  const memory = new WebAssembly.Memory({ initial: 1 });
  let said = "";
  const calls = systemCalls(() => memory, (text) => (said += text));
  const view = new DataView(memory.buffer);
  new Uint8Array(memory.buffer).set(new TextEncoder().encode("no memory"), 100);
  [100, 3, 103, 6].forEach((number, i) => view.setUint32(16 + 4 * i, number, true));
  expect(calls.fd_write(2, 16, 2, 8)).toBe(0);
  expect(said).toBe("no memory");
  expect(view.getUint32(8, true)).toBe(9);
  expect(calls.fd_write(1, 16, 2, 8)).not.toBe(0);
});
