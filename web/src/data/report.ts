/** All of a report, unpacked. */
import type { ReportHeader, SideName } from "./header";
import { blocksOf, parseHeader } from "./header";
import type { MatchData } from "./match";
import { unpackMatch } from "./match";
import type { MeshData } from "./mesh";
import { unpackMesh } from "./mesh";
import { fromBase64, Unpacker } from "./unpacker";
import type { Coarse } from "../picture/coarse";

export interface Change {
  kind: string;
  sentence: string;
  faces: Record<SideName, Uint32Array>;
}

export interface Report {
  header: ReportHeader;
  meshes: Record<SideName, MeshData>;
  match: MatchData;
  changes: Change[];
  /** What is drawn of each mesh: null for all of it. */
  shown: Record<SideName, Coarse | null>;
}

export function unpackReport(headerText: string, data: string): Report {
  return unpackBytes(headerText, fromBase64(data.trim()));
}

export function unpackBytes(headerText: string, bytes: Uint8Array): Report {
  const header = parseHeader(headerText);
  const blocks = blocksOf(header, bytes);
  const unpacker = new Unpacker(blocks.get("changes") ?? new Uint8Array());
  const meshes = {
    source: unpackMesh(header.source, "source", blocks),
    target: unpackMesh(header.target, "target", blocks),
  };
  return {
    header,
    meshes,
    match: unpackMatch(header, blocks),
    changes: header.changes.map(([kind, sentence]) => ({
      kind,
      sentence,
      faces: { source: unpacker.list(), target: unpacker.list() },
    })),
    shown: { source: null, target: null },
  };
}
