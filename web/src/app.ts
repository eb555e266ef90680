/** The whole of a report on a page: the picture, the panel beside it, and what one does to the other. */
import type { SideName } from "./data/header";
import { otherSide, SIDES } from "./data/header";
import { NONE, vertexPartners } from "./data/match";
import type { Report } from "./data/report";
import { makeControls, SHOWN_AT_FIRST } from "./panel/controls";
import { element, grouped } from "./panel/dom";
import { keyHelp, listenToKeys } from "./panel/keyboard";
import { legend } from "./panel/legend";
import { changeList, countKinds, figureList, regionList } from "./panel/lists";
import { facesAt, parseQuery } from "./panel/query";
import { makeReplay } from "./panel/replay";
import type { Pin } from "./panel/selection";
import { describeFace, pinList } from "./panel/selection";
import { themeButton } from "./panel/theme";
import type { Mode, Painting } from "./picture/colours";
import type { Layer } from "./picture/pane";
import { LAYERS } from "./picture/pane";
import { Picture } from "./picture/picture";

type Faces = Record<SideName, number[]>;

export class App {
  /** Null where there is nothing to draw, or nothing to draw with. */
  picture: Picture | null = null;
  private readonly painting: Painting = { mode: "match", wave: 0, hatch: true };
  private readonly layers = new Set<Layer>(SHOWN_AT_FIRST);
  private readonly canvas = element("canvas", { "aria-hidden": "true" });
  private readonly views: Record<SideName, HTMLElement>;
  private readonly stage = element("div", { class: "stage" });
  private readonly said = element("p", { class: "said", id: "said", role: "status", "aria-live": "polite" });
  private readonly pinned = element("div", { id: "pinned" });
  private readonly legendPlace = element("div");
  private pins: Pin[] = [];
  private focus: Faces = { source: [], target: [] };
  private change = NONE;
  private focusedSide: SideName = "source";
  private replay!: ReturnType<typeof makeReplay>;

  private readonly ended = new AbortController();

  constructor(readonly report: Report, private readonly root: HTMLElement) {
    this.views = { source: this.makeView("source"), target: this.makeView("target") };
    this.stage.append(this.canvas, this.views.source, this.views.target);
    this.replay = makeReplay(report.match, (wave) => {
      this.painting.wave = wave;
      this.repaint();
    });
    const left = element("div", { class: "left" }, this.stage, ...this.reduction(), this.replay.element, this.said);
    root.append(this.header(), element("main", {}, left, this.aside()));
    this.startPicture();
    this.applyBackground();
    this.repaint();
    for (const layer of Object.keys(LAYERS) as Layer[]) this.picture?.show(layer, this.layers.has(layer));
    this.listen();
  }

  /** Take it off the page; it cannot be used after. */
  dispose(): void {
    this.ended.abort();
    this.replay.stop();
    this.picture?.dispose();
    this.root.replaceChildren();
  }

  /** Pin a face and its partner, or let go of it. */
  togglePin(side: SideName, face: number): void {
    const partner = this.report.match[side].partner[face];
    const isSame = (pin: Pin) =>
      (pin.side === side && pin.face === face) || (pin.side === otherSide(side) && pin.face === partner);
    const at = this.pins.findIndex(isSame);
    if (at >= 0) this.pins.splice(at, 1);
    else this.pins.push({ side, face });
    this.said.textContent = describeFace(this.report, side, face);
    this.showPins();
  }

  /** Show what a face lies on, and light it up. */
  pointAt(side: SideName, face: number): void {
    const faces: Faces = { source: [], target: [] };
    if (face !== NONE) this.addPair(faces, side, face);
    this.picture?.mark("pointed", faces);
    if (face !== NONE) this.said.textContent = describeFace(this.report, side, face);
  }

  flyToChange(index: number): void {
    const change = this.report.changes[index];
    if (!change) return;
    this.change = index;
    this.goTo({ source: Array.from(change.faces.source), target: Array.from(change.faces.target) });
    this.said.textContent = `${change.kind}: ${change.sentence}`;
    document.querySelectorAll("[data-change]").forEach((item) => {
      item.toggleAttribute("aria-current", item.getAttribute("data-change") === String(index));
    });
  }

  private header(): HTMLElement {
    const { header } = this.report;
    document.title = header.title;
    return element(
      "header",
      {},
      element("h1", {}, header.title),
      element("span", { class: "program" }, header.program),
      themeButton(() => this.applyBackground(), this.ended.signal),
    );
  }

  private aside(): HTMLElement {
    const { header, changes } = this.report;
    const controls = makeControls({
      mode: (mode) => this.setMode(mode),
      layer: (layer, visible) => this.setLayer(layer, visible),
      link: (linked) => {
        if (this.picture) this.picture.cameras.linked = linked;
      },
      home: () => this.goHome(),
      search: (side, text) => this.search(side, text),
    });
    const section = (title: string, ...parts: Node[]) => element("section", {}, element("h2", {}, title), ...parts);
    const aside = element("aside", { "aria-label": "Figures and lists" });
    aside.append(
      section("Picture", controls, this.legendPlace, keyHelp(), this.pinned),
      section("Figures", figureList(header)),
      section(`Changes: ${grouped(changes.length)}`, element("p", {}, countKinds(changes)), changeList(changes, (c) => this.flyToChange(c))),
      section(`Regions: ${grouped(header.regions.length)}`, regionList(header, (r) => this.flyToRegion(r))),
    );
    return aside;
  }

  private makeView(side: SideName): HTMLElement {
    const { path, faceCount } = this.report.meshes[side];
    const name = `${side}: ${path === "-" ? "standard input" : path}, ${grouped(faceCount)} faces`;
    const view = element("div", {
      class: "view",
      id: `view-${side}`,
      tabindex: "0",
      role: "img",
      "aria-label": `${name}. Arrow keys turn it, plus and minus move nearer and farther.`,
    });
    view.append(element("span", { class: "name" }, name));
    view.addEventListener("focus", () => (this.focusedSide = side));
    return view;
  }

  /** Says where the picture has less than the meshes. */
  private reduction(): HTMLElement[] {
    const { shown, meshes } = this.report;
    const parts = SIDES.flatMap((side) =>
      shown[side] ? [`${grouped(shown[side].faces.length)} of the ${side}'s ${grouped(meshes[side].faceCount)} faces`] : [],
    );
    if (parts.length === 0) return [];
    const text = `Drawn are ${parts.join(" and ")}, what has no partner first. Matching, figures, lists and files have all of them.`;
    return [element("p", { class: "reduction", role: "note" }, text)];
  }

  private startPicture(): void {
    const { meshes } = this.report;
    const without = SIDES.filter((side) => meshes[side].positions === null || meshes[side].faceCount === 0);
    if (without.length > 0) {
      this.excuse(`There is no picture: the ${without.join(" and the ")} has no positions. Figures and lists are complete.`);
      return;
    }
    try {
      this.picture = new Picture(this.report, this.canvas, this.views, {
        pointed: (side, face) => this.pointAt(side, face),
        clicked: (side, face) => this.togglePin(side, face),
      });
    } catch {
      this.excuse("There is no picture: this browser has no WebGL, or it is switched off. Figures and lists are complete.");
    }
  }

  private excuse(text: string): void {
    this.stage.replaceChildren(element("p", { class: "excuse", role: "alert" }, text));
  }

  private repaint(): void {
    this.legendPlace.replaceChildren(legend(this.painting.mode, this.report.header, this.layers.has("extraordinary")));
    this.picture?.paint(this.painting);
  }

  private applyBackground(): void {
    this.picture?.setBackground(getComputedStyle(document.documentElement).getPropertyValue("--stage").trim());
  }

  private setMode(mode: Mode): void {
    this.painting.mode = mode;
    this.repaint();
  }

  private setLayer(layer: Layer, visible: boolean): void {
    if (visible) this.layers.add(layer);
    else this.layers.delete(layer);
    this.painting.hatch = this.layers.has("ambiguous");
    if (layer === "ambiguous" || layer === "extraordinary") this.repaint();
    this.picture?.show(layer, visible);
  }

  private addPair(faces: Faces, side: SideName, face: number): void {
    faces[side].push(face);
    const partner = this.report.match[side].partner[face];
    if (partner !== NONE) faces[otherSide(side)].push(partner);
    if (!this.report.header.mirror) return;
    // One mesh twice: both are on both sides.
    faces[otherSide(side)].push(face);
    if (partner !== NONE && partner !== face) faces[side].push(partner);
  }

  private showPins(): void {
    const faces: Faces = { source: [...this.focus.source], target: [...this.focus.target] };
    for (const pin of this.pins) this.addPair(faces, pin.side, pin.face);
    this.picture?.mark("pinned", faces);
    this.pinned.replaceChildren(
      pinList(this.report, this.pins, (index) => {
        this.pins.splice(index, 1);
        this.showPins();
      }),
    );
  }

  private goTo(faces: Faces): void {
    this.focus = faces;
    this.showPins();
    this.picture?.flyTo(faces);
  }

  private goHome(): void {
    this.picture?.cameras.home();
  }

  private flyToRegion(region: number): void {
    const { source } = this.report.match;
    const faces: Faces = { source: [], target: [] };
    source.region.forEach((r, f) => {
      if (r === region) this.addPair(faces, "source", f);
    });
    this.goTo(faces);
  }

  private search(side: SideName, text: string): void {
    const mesh = this.report.meshes[side];
    const query = parseQuery(text, mesh);
    if (typeof query === "string") {
      this.said.textContent = query;
      return;
    }
    const faces: Faces = { source: [], target: [] };
    if (query.kind === "face") {
      this.addPair(faces, side, query.index);
      this.said.textContent = describeFace(this.report, side, query.index);
    } else {
      const partner = vertexPartners(this.report.match, this.report.meshes, side)[query.index];
      const lies = partner === NONE ? "has no partner" : `lies on v${partner} of the ${otherSide(side)}`;
      const around = facesAt(mesh, query.index);
      for (const face of around) this.addPair(faces, side, face);
      this.said.textContent = `v${query.index} of the ${side} ${lies}${around.length > 0 ? "" : "; no face uses it"}`;
    }
    this.goTo(faces);
  }

  private listen(): void {
    listenToKeys({
      turn: (turn, tilt, nearer) => this.picture?.cameras.move(this.focusedSide, turn, tilt, nearer),
      home: () => this.goHome(),
      step: (by) => this.replay.step(by),
      play: () => this.replay.toggle(),
      change: (by) => {
        const count = this.report.changes.length;
        if (count > 0) this.flyToChange(this.change === NONE && by < 0 ? count - 1 : (this.change + by + count) % count);
      },
      release: () => {
        this.pins = [];
        this.focus = { source: [], target: [] };
        this.showPins();
      },
      search: () => document.getElementById("search")?.focus(),
      wireframe: () => {
        const box = document.getElementById("layer-wireframe") as HTMLInputElement;
        box.checked = !box.checked;
        this.setLayer("wireframe", box.checked);
      },
    }, this.ended.signal);
  }
}
