/** What is drawn of a mesh, as arrays of numbers: triangles, lines and points in a unit sphere. */
import type { MeshData } from "../data/mesh";
import { hasBit } from "../data/unpacker";

export interface Solid {
  /** x, y, z of each triangle corner. */
  positions: Float32Array;
  /** For each triangle corner 255 where it is; an edge that is none of the face's counts as far away everywhere. */
  edges: Uint8Array;
  /** The face each triangle belongs to. */
  faceOf: Uint32Array;
}

/** Where a mesh stands: the middle of its box and the radius that holds all of it. */
export interface Frame {
  centre: [number, number, number];
  radius: number;
}

export function frameOf(positions: Float32Array): Frame {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const centre: [number, number, number] = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
  let squared = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const x = positions[i] - centre[0];
    const y = positions[i + 1] - centre[1];
    const z = positions[i + 2] - centre[2];
    squared = Math.max(squared, x * x + y * y + z * z);
  }
  return { centre, radius: squared > 0 ? Math.sqrt(squared) : 1 };
}

/** Positions moved and scaled into the unit sphere. */
export function framed(positions: Float32Array, frame: Frame): Float32Array {
  const inside = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; ++i) inside[i] = (positions[i] - frame.centre[i % 3]) / frame.radius;
  return inside;
}

/** Polygons by their corners; without `faces` each is the face of its number. */
export interface Polygons {
  starts: Uint32Array;
  corners: Uint32Array;
  faces?: Uint32Array;
}

/** Every polygon as a fan of triangles from its first corner. */
export function solidOf(mesh: Polygons, points: Float32Array): Solid {
  const count = mesh.starts.length - 1;
  const triangles = mesh.corners.length - 2 * count;
  const solid: Solid = {
    positions: new Float32Array(9 * triangles),
    edges: new Uint8Array(12 * triangles),
    faceOf: new Uint32Array(triangles),
  };
  let t = 0;
  for (let f = 0; f < count; ++f) {
    const first = mesh.starts[f];
    const size = mesh.starts[f + 1] - first;
    for (let k = 1; k + 1 < size; ++k, ++t) {
      solid.faceOf[t] = mesh.faces ? mesh.faces[f] : f;
      const corners = [first, first + k, first + k + 1];
      // Opposite to the first corner lies a side of the face; to the others only at both ends of the fan.
      const isSide = [true, k + 2 === size, k === 1];
      for (let c = 0; c < 3; ++c) {
        const vertex = mesh.corners[corners[c]];
        for (let axis = 0; axis < 3; ++axis) {
          solid.positions[9 * t + 3 * c + axis] = points[3 * vertex + axis];
          solid.edges[12 * t + 4 * c + axis] = !isSide[axis] || axis === c ? 255 : 0;
        }
      }
    }
  }
  return solid;
}

/** Ends of the edges whose half-edges have a bit. */
export function linesOf(mesh: MeshData, points: Float32Array, bits: Uint8Array): Float32Array {
  const ends: number[] = [];
  for (let f = 0; f < mesh.faceCount; ++f) {
    const first = mesh.starts[f];
    const end = mesh.starts[f + 1];
    for (let h = first; h < end; ++h) {
      if (hasBit(bits, h)) ends.push(mesh.corners[h], mesh.corners[h + 1 === end ? first : h + 1]);
    }
  }
  return pointsOf(points, ends);
}

export function pointsOf(points: Float32Array, vertices: ArrayLike<number>): Float32Array {
  const chosen = new Float32Array(3 * vertices.length);
  for (let i = 0; i < vertices.length; ++i) {
    for (let axis = 0; axis < 3; ++axis) chosen[3 * i + axis] = points[3 * vertices[i] + axis];
  }
  return chosen;
}

/** Some faces of a mesh, as polygons. */
export function facesOf(mesh: MeshData, faces: readonly number[]): Polygons {
  const starts = new Uint32Array(faces.length + 1);
  faces.forEach((face, i) => (starts[i + 1] = starts[i] + mesh.starts[face + 1] - mesh.starts[face]));
  const corners = new Uint32Array(starts[faces.length]);
  faces.forEach((face, i) => corners.set(mesh.corners.subarray(mesh.starts[face], mesh.starts[face + 1]), starts[i]));
  return { starts, corners, faces: Uint32Array.from(faces) };
}

/** Ends of all sides of some faces. */
export function outlinesOf(mesh: MeshData, points: Float32Array, faces: ArrayLike<number>): Float32Array {
  const ends: number[] = [];
  for (let i = 0; i < faces.length; ++i) {
    const first = mesh.starts[faces[i]];
    const end = mesh.starts[faces[i] + 1];
    for (let h = first; h < end; ++h) ends.push(mesh.corners[h], mesh.corners[h + 1 === end ? first : h + 1]);
  }
  return pointsOf(points, ends);
}

/** The middle of all corners of some faces, and the radius around it that holds them. */
export function extentOf(mesh: MeshData, points: Float32Array, faces: ArrayLike<number>): Frame {
  const vertices: number[] = [];
  for (let i = 0; i < faces.length; ++i) {
    for (let h = mesh.starts[faces[i]]; h < mesh.starts[faces[i] + 1]; ++h) vertices.push(mesh.corners[h]);
  }
  return frameOf(pointsOf(points, vertices));
}

/** The mean normal of some faces, not of length 1; zeros where they look all ways. */
export function normalOf(mesh: MeshData, points: Float32Array, faces: ArrayLike<number>): [number, number, number] {
  const sum: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < faces.length; ++i) {
    const first = mesh.starts[faces[i]];
    const end = mesh.starts[faces[i] + 1];
    for (let h = first; h < end; ++h) {
      const a = 3 * mesh.corners[h];
      const b = 3 * mesh.corners[h + 1 === end ? first : h + 1];
      for (let axis = 0; axis < 3; ++axis) {
        const u = (axis + 1) % 3;
        const w = (axis + 2) % 3;
        sum[axis] += points[a + u] * points[b + w] - points[a + w] * points[b + u];
      }
    }
  }
  return sum;
}
