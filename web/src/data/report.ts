/** All of a report, unpacked. */
import type { ReportHeader, SideName } from "./header";
import { blocksOf, parseHeader } from "./header";
import type { MatchData } from "./match";
import { unpackMatch } from "./match";
import type { MeshData } from "./mesh";
import { unpackMesh } from "./mesh";
import { fromBase64, Unpacker } from "./unpacker";

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
}

export function unpackReport(headerText: string, data: string): Report {
  const header = parseHeader(headerText);
  const blocks = blocksOf(header, fromBase64(data.trim()));
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
  };
}
