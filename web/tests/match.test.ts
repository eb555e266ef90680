import { expect, test } from "vitest";
import type { ReportHeader } from "../src/data/header";
import { blocksOf, parseHeader } from "../src/data/header";
import { counterpart, unpackMatch, vertexPartners } from "../src/data/match";
import { namesAt } from "../src/data/mesh";
import { MATCH, STRIP, STRIP_AND_TRIANGLE } from "./small";

const MESHES = { source: STRIP, target: STRIP_AND_TRIANGLE };

function headerOf(faces: number[]): ReportHeader {
  const region = { orientation: "preserving", confidence: 1, ways: 1, ambiguous: false };
  return {
    source: { faces: 4 },
    target: { faces: 5 },
    regions: faces.map((count) => ({ ...region, faces: count })),
  } as unknown as ReportHeader;
}

test("pairs, regions and waves come back in the order in which they were packed", () => {
  const blocks = new Map([
    // f2 on f3, f1 on f2, f0 on f4; then, in a region of its own without waves, f3 on f0.
    ["pairs", Uint8Array.from([4, 6, 1, 1, 1, 0, 1, 4, 2, 6, 7, 3])],
    ["waves", Uint8Array.from([2, 2, 4, 0])],
  ]);
  const match = unpackMatch(headerOf([3, 1]), blocks);
  expect([...match.source.partner]).toEqual([4, 2, 3, 0]);
  expect([...match.target.partner]).toEqual([3, -1, 1, 2, 0]);
  expect([...match.source.region]).toEqual([0, 0, 0, 1]);
  expect([...match.source.wave]).toEqual([1, 1, 0, 0]);
  expect([...match.rotation]).toEqual([2, 0, 1, 3]);
  expect(match.seeds).toEqual([
    { source: 2, target: 3 },
    { source: 3, target: 0 },
  ]);
  expect([...match.matchedAfter]).toEqual([2, 4]);
});

test("a match of nothing has one wave, in which nothing is matched", () => {
  const match = unpackMatch(headerOf([]), new Map());
  expect(match.waveCount).toBe(1);
  expect([...match.matchedAfter]).toEqual([0]);
});

test("vertices follow the corners of their faces, forth and back", () => {
  expect([...vertexPartners(MATCH, MESHES, "source")]).toEqual([0, 1, 2, 3, 4, 5]);
  expect([...vertexPartners(MATCH, MESHES, "target")]).toEqual([0, 1, 2, 3, 4, 5, -1]);
});

test("where the target is turned over, corners run the other way", () => {
  const mirrored = { ...MATCH, reversing: [true], rotation: Uint32Array.from([1, 1]) };
  // Corner i of f0 = (v0 v1 v4 v3) lies on corner 1 - i of f1 = (v0 v1 v4 v3).
  expect([...vertexPartners(mirrored, MESHES, "source")].slice(0, 2)).toEqual([1, 0]);
});

test("what has no partner lies where its neighbours' partners are", () => {
  expect(counterpart(MATCH, MESHES, "target", [2])).toEqual([1]);
  expect(counterpart(MATCH, MESHES, "source", [0, 1])).toEqual([1, 0]);
});

test("the names that hold at a face are the latest before it", () => {
  const named = {
    ...STRIP,
    names: ["arm", "skin", "<b>leg</b>"],
    records: [
      { face: 0, kind: 1, name: 0 },
      { face: 0, kind: 2, name: 1 },
      { face: 1, kind: 1, name: 2 },
    ],
  };
  expect(namesAt(named, 0)).toBe("group arm, material skin");
  expect(namesAt(named, 1)).toBe("group <b>leg</b>, material skin");
});

test("a page that is no report, of another format or cut short says so", () => {
  expect(() => parseHeader("@NOTHING@")).toThrow("this is the viewer alone, without a report in it");
  expect(() => parseHeader('{"format": "quadmatch.report/9"}')).toThrow(/quadmatch.report\/9/);
  const header = { blocks: [["pairs", 3]] } as unknown as ReportHeader;
  expect(() => blocksOf(header, new Uint8Array(2))).toThrow(/not all there/);
});
