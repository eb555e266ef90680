/** What stands in front of the bytes of a report: src/report/header.cpp writes it. */

export type SideName = "source" | "target";
export const SIDES: readonly SideName[] = ["source", "target"];

export function otherSide(side: SideName): SideName {
  return side === "source" ? "target" : "source";
}

export interface MeshHeader {
  path: string;
  vertices: number;
  faces: number;
  corners: number;
  all_quads: boolean;
  positions: "grid" | "float32" | "none";
  /** Bits of each corner, 0 where corners are steps. */
  corner_bits: number;
  low: [number, number, number];
  step: number;
  names: string[];
}

export interface RegionHeader {
  orientation: "preserving" | "reversing";
  faces: number;
  confidence: number;
  agreeing: number;
  source_extraordinary: number;
  target_extraordinary: number;
  ways: number;
  ambiguous: boolean;
}

export interface ReportHeader {
  format: string;
  title: string;
  program: string;
  /** Source and target are one mesh, and the match its mirror. */
  mirror: boolean;
  source: MeshHeader;
  target: MeshHeader;
  regions: RegionHeader[];
  figures: [name: string, text: string][];
  changes: [kind: string, sentence: string][];
  blocks: [name: string, size: number][];
}

const FORMAT = "quadmatch.report/1";

/** The header of a report's text; throws with a sentence for the reader where it is none. */
export function parseHeader(text: string): ReportHeader {
  if (!text.trimStart().startsWith("{")) throw new Error("this is the viewer alone, without a report in it");
  const header = JSON.parse(text) as ReportHeader;
  if (header.format !== FORMAT) throw new Error(`this viewer shows ${FORMAT}, not ${header.format}`);
  return header;
}

/** Where each block lies in the bytes. */
export function blocksOf(header: ReportHeader, bytes: Uint8Array): Map<string, Uint8Array> {
  const blocks = new Map<string, Uint8Array>();
  let at = 0;
  for (const [name, size] of header.blocks) {
    blocks.set(name, bytes.subarray(at, at + size));
    at += size;
  }
  if (at !== bytes.length) throw new Error("the report's data are not all there; make the report again");
  return blocks;
}
