/** What colour a face has, by what is shown. Colours are sRGB, 0 ... 255. */
import type { RegionHeader, SideName } from "../data/header";
import type { MatchData } from "../data/match";
import { NONE } from "../data/match";
import type { MeshData } from "../data/mesh";

export type Rgb = readonly [number, number, number];

/** What colours tell; unmatched faces are red in all of them. */
export const MODES = {
  match: "Matched and unmatched",
  regions: "Regions",
  field: "Correspondence",
  waves: "Waves of growth",
  confidence: "Confidence",
} as const;
export type Mode = keyof typeof MODES;

export const UNMATCHED: Rgb = [214, 39, 40];
export const MATCHED: Rgb = [142, 180, 212];
/** Faces that a replay has not reached yet. */
export const WAITING: Rgb = [216, 216, 210];

/** Told apart with every common colour blindness, and none near the red (after Okabe and Ito). */
export const REGION_COLOURS: readonly Rgb[] = [
  [86, 180, 233],
  [230, 189, 60],
  [0, 158, 115],
  [204, 151, 187],
  [60, 110, 178],
  [178, 214, 150],
  [148, 136, 118],
  [120, 210, 205],
];

/** Cividis, from low to high: the same order in grey and to the colour-blind. */
const SCALE: readonly Rgb[] = [
  [0, 34, 78],
  [53, 69, 108],
  [102, 105, 112],
  [148, 142, 119],
  [200, 184, 102],
  [254, 232, 56],
];

/** A colour of the scale; share from 0 to 1. */
export function scaleColour(share: number): Rgb {
  const place = Math.min(Math.max(share, 0), 1) * (SCALE.length - 1);
  const k = Math.min(Math.floor(place), SCALE.length - 2);
  const mix = (axis: 0 | 1 | 2) => Math.round(SCALE[k][axis] + (place - k) * (SCALE[k + 1][axis] - SCALE[k][axis]));
  return [mix(0), mix(1), mix(2)];
}

export function regionColour(region: number): Rgb {
  return REGION_COLOURS[region % REGION_COLOURS.length];
}

/** For each source face a colour of its place: left to right red grows, bottom to top green, back to front blue. */
export function fieldColours(source: MeshData): Uint8Array {
  const field = new Uint8Array(3 * source.faceCount).fill(160);
  const positions = source.positions;
  if (!positions) return field;
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  for (let f = 0; f < source.faceCount; ++f) {
    const first = source.starts[f];
    const size = source.starts[f + 1] - first;
    for (let axis = 0; axis < 3; ++axis) {
      let sum = 0;
      for (let h = first; h < first + size; ++h) sum += positions[3 * source.corners[h] + axis];
      const span = high[axis] - low[axis];
      const share = span > 0 ? (sum / size - low[axis]) / span : 0.5;
      // Red stays low, so that nothing looks unmatched.
      field[3 * f + axis] = Math.round(axis === 0 ? 30 + 130 * share : 60 + 190 * share);
    }
  }
  return field;
}

export interface Painting {
  mode: Mode;
  /** Faces matched in this wave and before are shown as matched. */
  wave: number;
  hatch: boolean;
}

/** A function that gives each face of a side its colour. */
export function painter(
  painting: Painting,
  side: SideName,
  match: MatchData,
  regions: readonly RegionHeader[],
  field: Uint8Array,
): (face: number) => Rgb {
  const { partner, region, wave } = match[side];
  const last = Math.max(1, match.waveCount - 1);
  return (face) => {
    if (partner[face] === NONE) return painting.wave >= match.waveCount - 1 ? UNMATCHED : WAITING;
    if (wave[face] > painting.wave) return WAITING;
    switch (painting.mode) {
      case "match":
        return MATCHED;
      case "regions":
        return regionColour(region[face]);
      case "waves":
        return scaleColour(wave[face] / last);
      case "confidence":
        return scaleColour(regions[region[face]].confidence);
      case "field": {
        const at = 3 * (side === "source" ? face : partner[face]);
        return [field[at], field[at + 1], field[at + 2]];
      }
    }
  };
}

export function css(colour: Rgb): string {
  return `rgb(${colour.join(" ")})`;
}

/** Colours of extraordinary vertices, by valence. */
export function valenceColour(valence: number): Rgb {
  const colours: Record<number, Rgb> = {
    2: [90, 60, 160],
    3: [0, 114, 178],
    5: [230, 130, 0],
    6: [204, 90, 160],
  };
  return colours[valence] ?? (valence < 3 ? colours[2] : [40, 40, 40]);
}
