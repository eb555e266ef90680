import { expect, test } from "vitest";
import type { RegionHeader } from "../src/data/header";
import { fieldColours, MATCHED, painter, REGION_COLOURS, scaleColour, UNMATCHED, WAITING } from "../src/picture/colours";
import { framed, frameOf, linesOf, normalOf, solidOf } from "../src/picture/geometry";
import { MATCH, mesh, STRIP, STRIP_AND_TRIANGLE } from "./small";

const REGIONS = [{ confidence: 1 } as RegionHeader];
const FIELD = fieldColours(STRIP);

test("a face of n corners is a fan of n - 2 triangles, and only its sides are edges", () => {
  const pentagon = mesh([[0, 1, 2, 3, 4]], [0, 0, 0, 1, 0, 0, 2, 1, 0, 1, 2, 0, 0, 1, 0]);
  const solid = solidOf(pentagon, pentagon.positions!);
  expect([...solid.faceOf]).toEqual([0, 0, 0]);
  // The edge opposite to a corner is drawn where its coordinate runs from 255 to 0.
  const drawn = [0, 1, 2].map((t) => [0, 1, 2].map((axis) => solid.edges[12 * t + 4 * ((axis + 1) % 3) + axis] === 0));
  expect(drawn).toEqual([
    [true, false, true],
    [true, false, false],
    [true, true, false],
  ]);
});

test("all of a mesh stands in the unit sphere, wherever it was", () => {
  const far = Float32Array.from([100, 100, 100, 104, 100, 100, 104, 103, 100, 100, 103, 100]);
  const frame = frameOf(far);
  expect(frame).toEqual({ centre: [102, 101.5, 100], radius: 2.5 });
  const inside = framed(far, frame);
  for (let i = 0; i < inside.length; i += 3) expect(Math.hypot(inside[i], inside[i + 1], inside[i + 2])).toBeCloseTo(1);
});

test("one point has a frame too", () => {
  expect(frameOf(Float32Array.from([1, 2, 3]))).toEqual({ centre: [1, 2, 3], radius: 1 });
});

test("lines run along the half-edges whose bits are set", () => {
  expect([...linesOf(STRIP, STRIP.positions!, Uint8Array.from([0b10001000]))]).toEqual([0, 1, 0, 0, 0, 0, 1, 1, 0, 1, 0, 0]);
});

test("counter-clockwise faces look at us", () => {
  expect(normalOf(STRIP, STRIP.positions!, [0, 1])).toEqual([0, 0, 4]);
});

test("unmatched faces are red in every mode, and only they", () => {
  for (const mode of ["match", "regions", "field", "waves", "confidence"] as const) {
    const colour = painter({ mode, wave: 1, hatch: true }, "target", MATCH, REGIONS, FIELD);
    expect(colour(2)).toEqual(UNMATCHED);
    expect(colour(0)).not.toEqual(UNMATCHED);
  }
});

test("a replay shows what is matched so far, and nothing as unmatched before it is over", () => {
  const early = painter({ mode: "match", wave: 0, hatch: true }, "target", MATCH, REGIONS, FIELD);
  expect([0, 1, 2].map(early)).toEqual([WAITING, MATCHED, WAITING]);
  const last = painter({ mode: "match", wave: 1, hatch: true }, "target", MATCH, REGIONS, FIELD);
  expect([0, 1, 2].map(last)).toEqual([MATCHED, MATCHED, UNMATCHED]);
});

test("partners have the same colour in the correspondence field", () => {
  const source = painter({ mode: "field", wave: 1, hatch: true }, "source", MATCH, REGIONS, FIELD);
  const target = painter({ mode: "field", wave: 1, hatch: true }, "target", MATCH, REGIONS, FIELD);
  expect(target(1)).toEqual(source(0));
  expect(target(0)).toEqual(source(1));
  expect(source(0)).not.toEqual(source(1));
});

test("the scale goes from dark to light, whatever is asked of it", () => {
  const lightness = [-1, 0, 0.25, 0.5, 0.75, 1, 2].map((share) => {
    const [red, green, blue] = scaleColour(share);
    return 0.21 * red + 0.72 * green + 0.07 * blue;
  });
  expect([...lightness].sort((a, b) => a - b)).toEqual(lightness);
});

test("no region's colour is near the red of the unmatched, to the colour-blind neither", () => {
  // Without the red-green axis what is left is lightness and blue against yellow.
  const seen = ([red, green, blue]: readonly number[]) => [0.5 * red + 0.5 * green, blue];
  for (const colour of [...REGION_COLOURS, MATCHED]) {
    const [a, b] = [seen(colour), seen(UNMATCHED)];
    expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeGreaterThan(35);
  }
});

test("a mesh without positions has a field of one colour", () => {
  expect(new Set(fieldColours({ ...STRIP_AND_TRIANGLE, positions: null })).size).toBe(1);
});
