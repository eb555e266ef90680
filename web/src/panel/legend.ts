/** What the colours mean. */
import type { ReportHeader } from "../data/header";
import type { Mode, Rgb } from "../picture/colours";
import { css, MATCHED, REGION_COLOURS, scaleColour, UNMATCHED, valenceColour } from "../picture/colours";
import { element } from "./dom";

function swatch(colour: Rgb, text: string): HTMLElement {
  return element("li", {}, element("span", { class: "swatch", style: `background: ${css(colour)}` }), text);
}

function scale(low: string, high: string): HTMLElement {
  const stops = [0, 0.2, 0.4, 0.6, 0.8, 1].map((share) => css(scaleColour(share)));
  return element(
    "li",
    {},
    low,
    element("span", { class: "scale", style: `background: linear-gradient(to right, ${stops.join(", ")})` }),
    high,
  );
}

function linesOf(mode: Mode, header: ReportHeader): HTMLElement[] {
  switch (mode) {
    case "match":
      return [swatch(MATCHED, "matched")];
    case "regions":
      return REGION_COLOURS.slice(0, header.regions.length).map((colour, r) =>
        swatch(colour, header.regions.length > REGION_COLOURS.length ? `region ${r}, and every eighth after` : `region ${r}`),
      );
    case "field":
      return [element("li", {}, "the same colour, the same place: it is the source's place in its box")];
    case "waves":
      return [scale("first wave", "last wave")];
    case "confidence":
      return [scale("0", "1: all extraordinary vertices agree")];
  }
}

export function legend(mode: Mode, header: ReportHeader, valences: boolean): HTMLElement {
  const items = [swatch(UNMATCHED, "no partner"), ...linesOf(mode, header)];
  if (header.regions.some((region) => region.ambiguous)) {
    items.push(element("li", {}, element("span", { class: "swatch hatched" }), "ambiguous: could as well lie otherwise"));
  }
  if (valences) {
    for (const [valence, name] of [
      [3, "valence 3"],
      [5, "valence 5"],
      [6, "valence 6"],
      [7, "other"],
    ] as const) {
      items.push(swatch(valenceColour(valence), name));
    }
  }
  return element("ul", { class: "legend", "aria-label": "Legend" }, ...items);
}
