/** What the page and its worker tell each other. */
import type { Report } from "../data/report";

/** One option by its name on the command line, and its value. */
export type Choice = [name: string, value: string];

/** A file somebody chose: a File, or what stands for one. */
export type Chosen = File;

export type Request =
  /** First of all, and once: match these. */
  | { kind: "match"; engine: WebAssembly.Module; source: Chosen; target: Chosen; choices: Choice[]; mostFaces: number }
  | { kind: "match file"; name: string }
  | { kind: "transfer"; name: string }
  /** `other` only where it was not handed in before. */
  | { kind: "merge"; name: string; other: Chosen | null; choices: Choice[] };

export type Reply =
  | { kind: "stage"; text: string }
  | { kind: "progress"; done: number; most: number }
  | { kind: "warning"; text: string }
  | { kind: "report"; report: Report }
  | { kind: "file"; name: string; bytes: Uint8Array; summary: string }
  /** `lost`: this worker is of no use any more. */
  | { kind: "refused"; text: string; lost: boolean };
