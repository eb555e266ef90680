import { expect, test } from "vitest";
import { coarsened } from "../src/picture/coarse";
import { facesOf, solidOf } from "../src/picture/geometry";
import { mesh, STRIP_AND_TRIANGLE } from "./small";

/** A flat sheet of n by n quads. */
function sheet(n: number) {
  const positions: number[] = [];
  for (let i = 0; i <= n; ++i) for (let j = 0; j <= n; ++j) positions.push(j / n, i / n, 0);
  const faces: number[][] = [];
  for (let i = 0; i < n; ++i) for (let j = 0; j < n; ++j) faces.push([i * (n + 1) + j, i * (n + 1) + j + 1, (i + 1) * (n + 1) + j + 1, (i + 1) * (n + 1) + j]);
  return mesh(faces, positions);
}

const matched = (count: number) => new Int32Array(count);
const positionsOf = (flat: ReturnType<typeof sheet>, corners: ArrayLike<number>) => Array.from(corners, (v) => [...flat.positions!.subarray(3 * v, 3 * v + 2)]);

/** The area of polygons in the plane, each counter-clockwise. */
function area(flat: ReturnType<typeof sheet>, starts: Uint32Array, corners: Uint32Array): number {
  let sum = 0;
  for (let f = 0; f + 1 < starts.length; ++f) {
    const places = positionsOf(flat, corners.subarray(starts[f], starts[f + 1]));
    places.forEach(([x, y], i) => {
      const [u, v] = places[(i + 1) % places.length];
      sum += (x * v - u * y) / 2;
    });
  }
  return sum;
}

test("a mesh of few faces is drawn as it is, and so is one without positions", () => {
  expect(coarsened(sheet(10), matched(100), 100)).toBeNull();
  const nowhere = { ...sheet(10), positions: null };
  expect(coarsened(nowhere, matched(100), 50)).toBeNull();
});

test("what is left has as many faces as asked for at most, no corner twice, and covers nearly all", () => {
  const flat = sheet(60);
  const coarse = coarsened(flat, matched(3600), 400)!;
  expect(coarse.faces.length).toBeLessThanOrEqual(400);
  expect(coarse.faces.length).toBeGreaterThan(100);
  expect(coarse.starts.length).toBe(coarse.faces.length + 1);
  for (let f = 0; f < coarse.faces.length; ++f) {
    const corners = coarse.corners.subarray(coarse.starts[f], coarse.starts[f + 1]);
    expect(new Set(corners).size).toBe(corners.length);
    expect(corners.length).toBeGreaterThanOrEqual(3);
  }
  expect(area(flat, coarse.starts, coarse.corners)).toBeGreaterThan(0.8);
  expect(area(flat, coarse.starts, coarse.corners)).toBeLessThan(1.001);
});

test("faces without a partner are kept as they are", () => {
  const flat = sheet(60);
  const partner = matched(3600);
  const lost = [1830, 1831, 1890, 7];
  for (const face of lost) partner[face] = -1;
  const coarse = coarsened(flat, partner, 400)!;
  for (const face of lost) {
    const at = coarse.faces.indexOf(face);
    expect([...coarse.corners.subarray(coarse.starts[at], coarse.starts[at + 1])]).toEqual([...flat.corners.subarray(4 * face, 4 * face + 4)]);
  }
  expect(coarse.faces.length).toBeLessThanOrEqual(400);
});

test("where most has no partner there is an end to what is drawn too", () => {
  const coarse = coarsened(sheet(60), new Int32Array(3600).fill(-1), 400)!;
  expect(coarse.faces.length).toBeLessThanOrEqual(400);
  expect(coarse.faces.length).toBeGreaterThan(100);
});

test("triangles tell the face they belong to, drawn in part or in whole", () => {
  const solid = solidOf(facesOf(STRIP_AND_TRIANGLE, [2, 0]), STRIP_AND_TRIANGLE.positions!);
  expect([...solid.faceOf]).toEqual([2, 0, 0]);
  expect([...solid.positions.subarray(0, 9)]).toEqual([2, 0, 0, 3, 0.5, 0, 2, 1, 0]);
});
