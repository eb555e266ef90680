/** What is typed into the search: f12, v7, or a number, which is a face. */
import type { MeshData } from "../data/mesh";

export type Query = { kind: "face" | "vertex"; index: number };

/** The element named, or a sentence that says why there is none. */
export function parseQuery(text: string, mesh: MeshData): Query | string {
  const parts = /^\s*([fv]?)\s*(\d{1,10})\s*$/i.exec(text);
  if (!parts) return "Type f and a number for a face, v and a number for a vertex; both count from 0";
  const kind = parts[1].toLowerCase() === "v" ? "vertex" : "face";
  const index = Number(parts[2]);
  const count = kind === "face" ? mesh.faceCount : mesh.vertexCount;
  if (index >= count) return `There is no ${kind} ${index}; the last is ${count - 1}`;
  return { kind, index };
}

/** Faces that touch a vertex. */
export function facesAt(mesh: MeshData, vertex: number): number[] {
  const faces: number[] = [];
  for (let f = 0; f < mesh.faceCount; ++f) {
    for (let h = mesh.starts[f]; h < mesh.starts[f + 1]; ++h) {
      if (mesh.corners[h] !== vertex) continue;
      faces.push(f);
      break;
    }
  }
  return faces;
}
