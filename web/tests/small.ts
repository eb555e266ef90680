/** A strip of two quads, and the same with a triangle more: small enough to be written down. */
import type { MatchData } from "../src/data/match";
import type { MeshData } from "../src/data/mesh";

export function mesh(faces: number[][], positions: number[] | null): MeshData {
  const starts = new Uint32Array(faces.length + 1);
  faces.forEach((face, f) => (starts[f + 1] = starts[f] + face.length));
  const corners = Uint32Array.from(faces.flat());
  const bytes = Math.ceil(corners.length / 8);
  return {
    path: "strip.obj",
    vertexCount: Math.max(...corners) + 1,
    faceCount: faces.length,
    positions: positions ? Float32Array.from(positions) : null,
    starts,
    corners,
    skeleton: new Uint8Array(bytes),
    borders: new Uint8Array(bytes),
    extraordinary: [],
    crossings: new Uint32Array(),
    seams: new Uint32Array(),
    names: [],
    records: [],
  };
}

export const STRIP = mesh(
  [
    [0, 1, 4, 3],
    [1, 2, 5, 4],
  ],
  [0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0],
);

export const STRIP_AND_TRIANGLE = mesh(
  [
    [1, 2, 5, 4],
    [0, 1, 4, 3],
    [2, 6, 5],
  ],
  [0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 3, 0.5, 0],
);

/** Both quads of the strip on those of the other, the second a wave later. */
export const MATCH: MatchData = {
  source: { partner: Int32Array.from([1, 0]), region: Int32Array.from([0, 0]), wave: Int32Array.from([0, 1]) },
  target: { partner: Int32Array.from([1, 0, -1]), region: Int32Array.from([0, 0, -1]), wave: Int32Array.from([1, 0, -1]) },
  rotation: Uint32Array.from([0, 0]),
  reversing: [false],
  waveCount: 2,
  seeds: [{ source: 0, target: 1 }],
  matchedAfter: Uint32Array.from([1, 2]),
};
