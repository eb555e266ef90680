/** The match of a report: for every face its partner, its region and the wave it was matched in. */
import type { ReportHeader, SideName } from "./header";
import { otherSide } from "./header";
import type { MeshData } from "./mesh";
import { Unpacker } from "./unpacker";

export const NONE = -1;

/** What the match says of the faces of one mesh; NONE where it says nothing. */
export interface FaceMap {
  partner: Int32Array;
  region: Int32Array;
  wave: Int32Array;
}

export interface MatchData {
  source: FaceMap;
  target: FaceMap;
  /** For each source face the target corner that its corner 0 lies on. */
  rotation: Uint8Array | Uint32Array;
  reversing: boolean[];
  /** At least 1; regions without waves are matched in the first. */
  waveCount: number;
  /** The first pair of each region: where it began to grow. */
  seeds: { source: number; target: number }[];
  /** Faces matched when a wave is over. */
  matchedAfter: Uint32Array;
}

function emptyMap(faces: number): FaceMap {
  return {
    partner: new Int32Array(faces).fill(NONE),
    region: new Int32Array(faces).fill(NONE),
    wave: new Int32Array(faces).fill(NONE),
  };
}

export function unpackMatch(header: ReportHeader, blocks: Map<string, Uint8Array>): MatchData {
  const pairs = new Unpacker(blocks.get("pairs") ?? new Uint8Array());
  const waves = new Unpacker(blocks.get("waves") ?? new Uint8Array());
  const match: MatchData = {
    source: emptyMap(header.source.faces),
    target: emptyMap(header.target.faces),
    rotation: new Uint32Array(header.source.faces),
    reversing: header.regions.map((region) => region.orientation === "reversing"),
    waveCount: 1,
    seeds: [],
    matchedAfter: new Uint32Array(1),
  };
  const inWave: number[] = [];
  let source = 0;
  let target = 0;
  header.regions.forEach((region, r) => {
    const ends = waves.list();
    let wave = 0;
    for (let i = 0; i < region.faces; ++i) {
      source = pairs.step(source);
      target = pairs.step(target);
      match.rotation[source] = pairs.number();
      while (wave < ends.length - 1 && i >= ends[wave]) ++wave;
      if (i === 0) match.seeds.push({ source, target });
      match.source.partner[source] = target;
      match.target.partner[target] = source;
      match.source.region[source] = match.target.region[target] = r;
      match.source.wave[source] = match.target.wave[target] = wave;
      inWave[wave] = (inWave[wave] ?? 0) + 1;
    }
  });
  match.waveCount = Math.max(1, inWave.length);
  match.matchedAfter = new Uint32Array(match.waveCount);
  let sum = 0;
  for (let w = 0; w < match.waveCount; ++w) match.matchedAfter[w] = sum += inWave[w] ?? 0;
  return match;
}

/** The matched faces of the source, region by region, each by number. */
function byRegion(match: MatchData): Uint32Array {
  const { region } = match.source;
  const starts = new Uint32Array(match.reversing.length + 1);
  for (const r of region) if (r !== NONE) ++starts[r + 1];
  for (let r = 0; r < match.reversing.length; ++r) starts[r + 1] += starts[r];
  const faces = new Uint32Array(starts[match.reversing.length]);
  region.forEach((r, f) => {
    if (r !== NONE) faces[starts[r]++] = f;
  });
  return faces;
}

/** The partner of each vertex of `side`; where regions disagree the larger one, which stands first, wins. */
export function vertexPartners(
  match: MatchData,
  meshes: Record<SideName, MeshData>,
  side: SideName,
): Int32Array {
  const { source, target } = meshes;
  const forth = new Int32Array(source.vertexCount).fill(NONE);
  const back = new Int32Array(target.vertexCount).fill(NONE);
  for (const f of byRegion(match)) {
    const g = match.source.partner[f];
    const size = source.starts[f + 1] - source.starts[f];
    for (let i = 0; i < size; ++i) {
      const turned = match.reversing[match.source.region[f]] ? match.rotation[f] - i + size : match.rotation[f] + i;
      const v = source.corners[source.starts[f] + i];
      const w = target.corners[target.starts[g] + (turned % size)];
      if (forth[v] !== NONE || back[w] !== NONE) continue;
      forth[v] = w;
      back[w] = v;
    }
  }
  return side === "source" ? forth : back;
}

/** Faces of the other mesh that lie where these are: their partners, else those of faces that touch them. */
export function counterpart(
  match: MatchData,
  meshes: Record<SideName, MeshData>,
  side: SideName,
  faces: ArrayLike<number>,
): number[] {
  const partner = match[side].partner;
  const direct = Array.from(faces, (f) => partner[f]).filter((g) => g !== NONE);
  if (direct.length > 0) return direct;
  const mesh = meshes[side];
  const touched = new Uint8Array(mesh.vertexCount);
  for (let i = 0; i < faces.length; ++i) {
    for (let h = mesh.starts[faces[i]]; h < mesh.starts[faces[i] + 1]; ++h) touched[mesh.corners[h]] = 1;
  }
  const found: number[] = [];
  for (let f = 0; f < mesh.faceCount; ++f) {
    if (partner[f] === NONE) continue;
    for (let h = mesh.starts[f]; h < mesh.starts[f + 1]; ++h) {
      if (touched[mesh.corners[h]] === 0) continue;
      found.push(partner[f]);
      break;
    }
  }
  return found;
}

/** "f12 of the target", for the reader. */
export function partnerText(match: MatchData, side: SideName, face: number): string {
  const partner = match[side].partner[face];
  return partner === NONE ? "has no partner" : `lies on f${partner} of the ${otherSide(side)}`;
}
