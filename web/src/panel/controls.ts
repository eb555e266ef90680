/** What colours tell, what lies on top, and where to look. */
import { SIDES, type SideName } from "../data/header";
import { MODES, type Mode } from "../picture/colours";
import { LAYERS, type Layer } from "../picture/pane";
import { button, element } from "./dom";

export interface ControlEvents {
  mode(mode: Mode): void;
  layer(layer: Layer, visible: boolean): void;
  link(linked: boolean): void;
  home(): void;
  search(side: SideName, text: string): void;
}

export const SHOWN_AT_FIRST: readonly Layer[] = ["wireframe", "ambiguous", "seams"];

function modeChoice(events: ControlEvents): HTMLElement {
  const select = element("select", { id: "mode" });
  for (const [mode, name] of Object.entries(MODES)) select.append(element("option", { value: mode }, name));
  select.addEventListener("change", () => events.mode(select.value as Mode));
  return element("label", {}, "Colours ", select);
}

function layerBoxes(events: ControlEvents): HTMLElement {
  const group = element("fieldset", { class: "layers" }, element("legend", {}, "Show"));
  for (const [layer, name] of Object.entries(LAYERS) as [Layer, string][]) {
    const box = element("input", {
      type: "checkbox",
      id: `layer-${layer}`,
      checked: SHOWN_AT_FIRST.includes(layer),
    });
    box.addEventListener("change", () => events.layer(layer, box.checked));
    group.append(element("label", {}, box, ` ${name}`));
  }
  return group;
}

function cameraButtons(events: ControlEvents): HTMLElement {
  const box = element("input", { type: "checkbox", id: "link", checked: true });
  box.addEventListener("change", () => events.link(box.checked));
  return element(
    "div",
    { class: "row" },
    element("label", {}, box, " Linked cameras"),
    button("Whole view", { id: "home", "aria-keyshortcuts": "0" }, events.home),
  );
}

function searchForm(events: ControlEvents): HTMLElement {
  const side = element("select", { id: "search-side", "aria-label": "Mesh to search" });
  for (const name of SIDES) side.append(element("option", { value: name }, name));
  const text = element("input", {
    type: "search",
    id: "search",
    placeholder: "f12 or v7",
    "aria-label": "Face or vertex by number",
    "aria-keyshortcuts": "/",
    size: "9",
  });
  const form = element("form", { class: "row", role: "search" }, side, text, element("button", { type: "submit" }, "Find"));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    events.search(side.value as SideName, text.value);
  });
  return form;
}

export function makeControls(events: ControlEvents): HTMLElement {
  return element(
    "div",
    { class: "controls" },
    element("div", { class: "row" }, modeChoice(events)),
    layerBoxes(events),
    cameraButtons(events),
    searchForm(events),
  );
}
