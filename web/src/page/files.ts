/** Which of the files that were dropped is which. */
import type { Slot } from "./engine";

export type Files<Kind = File> = Partial<Record<Slot, Kind>>;

/** What is there after files were dropped on the page, or a sentence that says why they cannot be taken. */
export function dropped<Kind>(there: Files<Kind>, files: readonly Kind[], on: Slot | null): Files<Kind> | string {
  if (files.length === 0) return "Drop files: two meshes to match, or three to merge";
  if (files.length > 3) return `${files.length} files are too many: drop two meshes to match, or three to merge`;
  if (on && files.length === 1) return { ...there, [on]: files[0] };
  if (files.length === 1) {
    // The first of a new pair, unless it makes an old one whole.
    if (there.source && !there.target) return { ...there, target: files[0] };
    return { source: files[0] };
  }
  const [source, target, other] = files;
  return other === undefined ? { source, target } : { source, target, other };
}

const ENDINGS = ["obj", "ply", "off", "usda"];

/** The ending of a format we write: that of a file, else OBJ. */
export function endingOf(name: string): string {
  const ending = /\.([^.]+)$/.exec(name)?.[1].toLowerCase() ?? "";
  return ENDINGS.includes(ending) ? ending : "obj";
}

/** The name without its ending. */
export function stemOf(name: string): string {
  return name.replace(/\.[^.]+$/, "");
}
