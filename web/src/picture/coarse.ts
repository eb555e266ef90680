/**
 * A mesh with fewer faces to look at, where all of them would take too long to draw. Vertices that share a cell of a grid
 * become one; of faces that lie on each other then, one is kept. What has no partner is kept as it is, as far as there is
 * room: it is what one looks for.
 */
import { NONE } from "../data/match";
import type { MeshData } from "../data/mesh";

/** The polygons drawn instead of a mesh's faces; their corners are vertices of the mesh. */
export interface Coarse {
  /** The face each polygon stands for. */
  faces: Uint32Array;
  starts: Uint32Array;
  corners: Uint32Array;
}

/** At most this share of the polygons are faces without a partner, kept as they are. */
const SHARE_KEPT = 0.5;
const MOST_TRIALS = 5;

/** For each vertex the one that stands for all in its cell: the nearest to its middle, and of such the first. */
function representatives(positions: Float32Array, cell: number, low: number[], sizes: number[], kept: Uint8Array): Uint32Array {
  const across = Math.floor(sizes[0] / cell) + 1;
  const deep = Math.floor(sizes[1] / cell) + 1;
  const count = positions.length / 3;
  const cells = new Map<number, number>();
  const nearest: number[] = [];
  const distances: number[] = [];
  const cellOf = new Uint32Array(count);
  for (let v = 0; v < count; ++v) {
    if (kept[v] !== 0) continue;
    const x = (positions[3 * v] - low[0]) / cell;
    const y = (positions[3 * v + 1] - low[1]) / cell;
    const z = (positions[3 * v + 2] - low[2]) / cell;
    const [i, j, k] = [Math.floor(x), Math.floor(y), Math.floor(z)];
    const distance = (x - i - 0.5) ** 2 + (y - j - 0.5) ** 2 + (z - k - 0.5) ** 2;
    const key = i + across * (j + deep * k);
    let found = cells.get(key);
    if (found === undefined) {
      found = nearest.length;
      cells.set(key, found);
      nearest.push(v);
      distances.push(distance);
    } else if (distance < distances[found]) {
      nearest[found] = v;
      distances[found] = distance;
    }
    cellOf[v] = found;
  }
  const stands = new Uint32Array(count);
  for (let v = 0; v < count; ++v) stands[v] = kept[v] !== 0 ? v : nearest[cellOf[v]];
  return stands;
}

/** The corners of a face after that, without those that fell together with the one before. */
function cornersOf(mesh: MeshData, face: number, stands: Uint32Array): number[] {
  const corners: number[] = [];
  for (let h = mesh.starts[face]; h < mesh.starts[face + 1]; ++h) {
    const v = stands[mesh.corners[h]];
    if (corners[corners.length - 1] !== v) corners.push(v);
  }
  if (corners.length > 1 && corners[0] === corners[corners.length - 1]) corners.pop();
  return corners;
}

function withCells(mesh: MeshData, order: Uint32Array, stands: Uint32Array): Coarse {
  const seen = new Set<string>();
  const faces: number[] = [];
  const starts: number[] = [0];
  const corners: number[] = [];
  for (const face of order) {
    const polygon = cornersOf(mesh, face, stands);
    if (new Set(polygon).size < 3) continue;
    const name = [...polygon].sort((a, b) => a - b).join();
    if (seen.has(name)) continue;
    seen.add(name);
    faces.push(face);
    for (const v of polygon) corners.push(v);
    starts.push(corners.length);
  }
  return { faces: Uint32Array.from(faces), starts: Uint32Array.from(starts), corners: Uint32Array.from(corners) };
}

/** Faces without a partner before the others, each by number: of two that fall together the first stays. */
function unmatchedFirst(partner: Int32Array): { order: Uint32Array; unmatched: number } {
  const order = new Uint32Array(partner.length);
  let at = 0;
  for (let f = 0; f < partner.length; ++f) if (partner[f] === NONE) order[at++] = f;
  const unmatched = at;
  for (let f = 0; f < partner.length; ++f) if (partner[f] !== NONE) order[at++] = f;
  return { order, unmatched };
}

/** @returns about `most` polygons or fewer; null where the mesh has no more faces than that, or no positions. */
export function coarsened(mesh: MeshData, partner: Int32Array, most: number): Coarse | null {
  const { positions } = mesh;
  if (!positions || mesh.faceCount <= most) return null;
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const sizes = low.map((from, axis) => high[axis] - from);
  const { order, unmatched } = unmatchedFirst(partner);
  const kept = new Uint8Array(mesh.vertexCount);
  if (unmatched <= SHARE_KEPT * most) {
    for (const face of order.subarray(0, unmatched)) {
      for (let h = mesh.starts[face]; h < mesh.starts[face + 1]; ++h) kept[mesh.corners[h]] = 1;
    }
  }
  const longest = Math.max(...sizes);
  // As if the mesh were a square of its longest side; what comes of it tells how far off that is.
  let cell = longest > 0 ? longest / Math.sqrt(most / 2) : 1;
  for (let trial = 1; ; ++trial) {
    const coarse = withCells(mesh, order, representatives(positions, cell, low, sizes, kept));
    const free = Math.max(1, most - unmatched);
    const made = Math.max(1, coarse.faces.length - unmatched);
    if (trial >= MOST_TRIALS && coarse.faces.length <= 2 * most) return coarse;
    if (coarse.faces.length <= most && (made > 0.4 * free || trial >= MOST_TRIALS)) return coarse;
    cell *= Math.min(8, Math.max(0.25, Math.sqrt((1.3 * made) / free)));
    if (trial > 4 * MOST_TRIALS) return coarse;
  }
}
