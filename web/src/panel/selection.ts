/** What is pointed at and what is pinned, in words. */
import type { SideName } from "../data/header";
import { otherSide } from "../data/header";
import { NONE } from "../data/match";
import { namesAt } from "../data/mesh";
import type { Report } from "../data/report";
import { button, element } from "./dom";

export interface Pin {
  side: SideName;
  face: number;
}

/** "f12 of the source lies on f90 of the target; group arm". */
export function describeFace(report: Report, side: SideName, face: number): string {
  const partner = report.match[side].partner[face];
  const region = report.match[side].region[face];
  const names = namesAt(report.meshes[side], face);
  const lies =
    partner === NONE ? "has no partner" : `lies on f${partner} of the ${otherSide(side)}, region ${region}`;
  const doubt = region !== NONE && report.header.regions[region].ambiguous ? ", ambiguous" : "";
  return `f${face} of the ${side} ${lies}${doubt}${names ? `; ${names}` : ""}`;
}

export function pinList(report: Report, pins: readonly Pin[], released: (index: number) => void): HTMLElement {
  const list = element("ul", { class: "pins", "aria-label": "Pinned" });
  pins.forEach((pin, i) => {
    const text = describeFace(report, pin.side, pin.face);
    list.append(
      element("li", {}, element("span", {}, text), button("\u00d7", { "aria-label": `Let go of ${text}` }, () => released(i))),
    );
  });
  return list;
}
