import { expect, test } from "vitest";
import { countKinds } from "../src/panel/lists";
import { counted, grouped } from "../src/panel/dom";
import { facesAt, parseQuery } from "../src/panel/query";
import { describeWave } from "../src/panel/replay";
import { MATCH, STRIP, STRIP_AND_TRIANGLE } from "./small";

test("a search names a face, a vertex, or why there is none", () => {
  expect(parseQuery("1", STRIP)).toEqual({ kind: "face", index: 1 });
  expect(parseQuery(" F0 ", STRIP)).toEqual({ kind: "face", index: 0 });
  expect(parseQuery("v5", STRIP)).toEqual({ kind: "vertex", index: 5 });
  expect(parseQuery("f2", STRIP)).toBe("There is no face 2; the last is 1");
  expect(parseQuery("v6", STRIP)).toBe("There is no vertex 6; the last is 5");
  for (const nonsense of ["", "e3", "f", "-1", "1.5", "f99999999999"]) expect(typeof parseQuery(nonsense, STRIP)).toBe("string");
});

test("a vertex is found by the faces around it", () => {
  expect(facesAt(STRIP_AND_TRIANGLE, 5)).toEqual([0, 2]);
});

test("changes are counted by kind, in the order they come", () => {
  const faces = { source: new Uint32Array(), target: new Uint32Array() };
  const change = (kind: string) => ({ kind, sentence: "", faces });
  expect(countKinds([change("removed"), change("added"), change("removed")])).toBe("2 removed, 1 added");
});

test("numbers read as on a terminal", () => {
  expect(grouped(1234567)).toBe("1,234,567");
  expect(counted(1, "face")).toBe("1 face");
  expect(counted(13378, "face")).toBe("13,378 faces");
  expect(describeWave(MATCH, 1)).toBe("wave 2 of 2: 2 faces matched");
});
