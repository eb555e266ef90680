/** One mesh of a report, unpacked: connectivity, positions and what is marked on it. */
import type { MeshHeader, SideName } from "./header";
import { unpackBits, Unpacker } from "./unpacker";

/** A vertex that stands out (§2.1). */
export interface Extraordinary {
  vertex: number;
  valence: number;
  boundary: boolean;
  touchesNonQuad: boolean;
}

/** From `face` on this name holds. */
export interface NameRecord {
  face: number;
  kind: number;
  name: number;
}

export const NAME_KINDS = ["object", "group", "material"];

export interface MeshData {
  path: string;
  vertexCount: number;
  faceCount: number;
  /** x, y, z of each vertex, or null where the file has none. */
  positions: Float32Array | null;
  /** Where each face's corners start, with the total at the end. */
  starts: Uint32Array;
  corners: Uint32Array;
  /** A bit for each half-edge that lies on the skeleton, where another region begins. */
  skeleton: Uint8Array;
  borders: Uint8Array;
  extraordinary: Extraordinary[];
  crossings: Uint32Array;
  /** Ends of edges that are cut, two for each. */
  seams: Uint32Array;
  names: string[];
  records: NameRecord[];
}

function unpackPositions(header: MeshHeader, bytes: Uint8Array): Float32Array | null {
  if (header.positions === "none") return null;
  const positions = new Float32Array(3 * header.vertices);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let i = 0; i < positions.length; ++i) {
    positions[i] = header.positions === "grid" ? view.getUint16(2 * i, true) * header.step : view.getFloat32(4 * i, true);
  }
  return positions;
}

function unpackStarts(header: MeshHeader, bytes: Uint8Array): Uint32Array {
  const starts = new Uint32Array(header.faces + 1);
  const unpacker = new Unpacker(bytes);
  for (let f = 0; f < header.faces; ++f) starts[f + 1] = starts[f] + (header.all_quads ? 4 : unpacker.number());
  return starts;
}

function unpackCorners(header: MeshHeader, bytes: Uint8Array): Uint32Array {
  if (header.corner_bits > 0) return unpackBits(bytes, header.corner_bits, header.corners);
  const corners = new Uint32Array(header.corners);
  const unpacker = new Unpacker(bytes);
  let before = 0;
  for (let h = 0; h < corners.length; ++h) corners[h] = before = unpacker.step(before);
  return corners;
}

function unpackExtraordinary(bytes: Uint8Array): Extraordinary[] {
  const unpacker = new Unpacker(bytes);
  const found: Extraordinary[] = [];
  let vertex = 0;
  for (let left = unpacker.number(); left > 0; --left) {
    vertex = unpacker.step(vertex);
    const code = unpacker.number();
    found.push({ vertex, valence: code >> 2, boundary: (code & 2) !== 0, touchesNonQuad: (code & 1) !== 0 });
  }
  return found;
}

function unpackRecords(bytes: Uint8Array): NameRecord[] {
  const unpacker = new Unpacker(bytes);
  const records: NameRecord[] = [];
  let face = 0;
  while (!unpacker.done) {
    face = unpacker.step(face);
    records.push({ face, kind: unpacker.number(), name: unpacker.number() });
  }
  return records;
}

export function unpackMesh(header: MeshHeader, side: SideName, blocks: Map<string, Uint8Array>): MeshData {
  const block = (name: string): Uint8Array => {
    const bytes = blocks.get(`${side}.${name}`);
    if (!bytes) throw new Error(`the report lacks ${side}.${name}; make the report again`);
    return bytes;
  };
  return {
    path: header.path,
    vertexCount: header.vertices,
    faceCount: header.faces,
    positions: unpackPositions(header, block("positions")),
    starts: unpackStarts(header, block("sizes")),
    corners: unpackCorners(header, block("corners")),
    skeleton: block("skeleton"),
    borders: block("borders"),
    extraordinary: unpackExtraordinary(block("extraordinary")),
    crossings: new Unpacker(block("crossings")).list(),
    seams: new Unpacker(block("seams")).list(),
    names: header.names,
    records: unpackRecords(block("records")),
  };
}

/** "group arm, material skin": what holds at a face. */
export function namesAt(mesh: MeshData, face: number): string {
  const latest: (string | undefined)[] = [];
  for (const record of mesh.records) {
    if (record.face > face) break;
    latest[record.kind] = mesh.names[record.name];
  }
  return NAME_KINDS.map((kind, k) => (latest[k] ? `${kind} ${latest[k]}` : ""))
    .filter((text) => text !== "")
    .join(", ");
}
