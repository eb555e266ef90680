/** The numbers, the regions and the changes beside the picture. */
import type { ReportHeader } from "../data/header";
import type { Change } from "../data/report";
import { css, regionColour } from "../picture/colours";
import { button, counted, element, grouped } from "./dom";

/** More are listed when asked for. */
const AT_FIRST = 200;

export function figureList(header: ReportHeader): HTMLElement {
  const list = element("dl", { class: "figures" });
  for (const [name, text] of header.figures) list.append(element("dt", {}, name), element("dd", {}, text));
  return list;
}

/** A list whose items stand as buttons, the first of them at once. */
function buttonList<Item>(items: readonly Item[], label: string, make: (item: Item, index: number) => HTMLElement): HTMLElement {
  const list = element("ol", { class: "places", "aria-label": label });
  const add = (from: number, to: number) => {
    items.slice(from, to).forEach((item, i) => list.append(element("li", {}, make(item, from + i))));
  };
  add(0, AT_FIRST);
  if (items.length > AT_FIRST) {
    const more = element("li");
    more.append(
      button(`Show ${grouped(items.length - AT_FIRST)} more`, { class: "more" }, () => {
        more.remove();
        add(AT_FIRST, items.length);
      }),
    );
    list.append(more);
  }
  return list;
}

export function regionList(header: ReportHeader, chosen: (region: number) => void): HTMLElement {
  return buttonList(header.regions, "Regions", (region, r) => {
    const doubt = region.ambiguous ? `; one of ${grouped(region.ways)} ways` : "";
    const item = button("", { class: "place", "data-region": String(r) }, () => chosen(r));
    item.append(
      element("span", { class: "swatch", style: `background: ${css(regionColour(r))}` }),
      element(
        "span",
        {},
        `${counted(region.faces, "face")}, ${region.orientation}; ${grouped(region.agreeing)} extraordinary vertices agree, ` +
          `confidence ${region.confidence.toFixed(2)}${doubt}`,
      ),
    );
    return item;
  });
}

/** "2 only in source, 1 edge loop": how many of each kind, in the order they come. */
export function countKinds(changes: readonly Change[]): string {
  const counts = new Map<string, number>();
  for (const { kind } of changes) counts.set(kind, (counts.get(kind) ?? 0) + 1);
  return [...counts].map(([kind, count]) => `${grouped(count)} ${kind}`).join(", ");
}

export function changeList(changes: readonly Change[], chosen: (change: number) => void): HTMLElement {
  return buttonList(changes, "Changes", (change, c) => {
    const item = button("", { class: "place", "data-change": String(c) }, () => chosen(c));
    item.append(element("span", { class: "kind" }, change.kind), element("span", {}, change.sentence));
    return item;
  });
}
