/** Both meshes side by side on one canvas, drawn only when something has changed. */
import { Vector2, Vector3, WebGLRenderer } from "three";
import type { SideName } from "../data/header";
import { otherSide, SIDES } from "../data/header";
import { counterpart, NONE } from "../data/match";
import type { Report } from "../data/report";
import type { Painting } from "./colours";
import { fieldColours, painter } from "./colours";
import { LinkedCameras } from "./linked_cameras";
import type { Layer } from "./pane";
import { Pane } from "./pane";

/** So many faces of one mesh are marked at most when a change is flown to. */
const MOST_MARKED = 200000;
const FLIGHT_MILLISECONDS = 450;

export interface PictureEvents {
  pointed(side: SideName, face: number): void;
  clicked(side: SideName, face: number): void;
}

export class Picture {
  private readonly renderer: WebGLRenderer;
  private readonly panes: Record<SideName, Pane>;
  readonly cameras: LinkedCameras;
  private readonly field: Uint8Array;
  private readonly sizes: ResizeObserver;
  private waiting = false;
  /** Set when faces have their colours; before, there is nothing to see. */
  private painted = false;
  private flight = 0;
  private background = "#ffffff";

  /** Throws where the browser has no WebGL. */
  constructor(
    private readonly report: Report,
    private readonly canvas: HTMLCanvasElement,
    private readonly surfaces: Record<SideName, HTMLElement>,
    private readonly events: PictureEvents,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.setScissorTest(true);
    const { meshes, match, shown } = report;
    this.panes = {
      source: new Pane({ side: "source", mesh: meshes.source, match, shown: shown.source }),
      target: new Pane({ side: "target", mesh: meshes.target, match, shown: shown.target }),
    };
    this.field = fieldColours(meshes.source);
    this.cameras = new LinkedCameras(surfaces, () => this.draw());
    for (const side of SIDES) this.listen(side);
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(canvas);
    this.resize();
  }

  /** Let go of the graphics card: a browser has few of its contexts. */
  dispose(): void {
    this.painted = false;
    ++this.flight;
    this.sizes.disconnect();
    for (const side of SIDES) this.panes[side].dispose();
    this.cameras.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  setBackground(colour: string): void {
    this.background = colour;
    this.draw();
  }

  paint(painting: Painting): void {
    const { match, header } = this.report;
    for (const side of SIDES) {
      const { region } = match[side];
      const ambiguous = (face: number) => region[face] !== NONE && header.regions[region[face]].ambiguous;
      this.panes[side].paintFaces(
        painter(painting, side, match, header.regions, this.field),
        painting.hatch ? ambiguous : () => false,
      );
    }
    this.painted = true;
    this.draw();
  }

  show(layer: Layer, visible: boolean): void {
    for (const side of SIDES) this.panes[side].show(layer, visible);
    this.draw();
  }

  mark(kind: "pointed" | "pinned", faces: Record<SideName, readonly number[]>): void {
    for (const side of SIDES) this.panes[side].mark(kind, faces[side].slice(0, MOST_MARKED));
    this.draw();
  }

  /** The face drawn at a place of the page, or NONE. */
  pick(side: SideName, x: number, y: number): number {
    const box = this.surfaces[side].getBoundingClientRect();
    const place = new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2);
    return this.panes[side].pick(place, this.cameras.cameras[side]);
  }

  /** Move both cameras to some faces: to their own where a side has them, else to what lies there. */
  flyTo(faces: Record<SideName, ArrayLike<number>>): void {
    const { match, meshes } = this.report;
    const flight = ++this.flight;
    for (const side of SIDES) {
      const own = faces[side].length > 0 ? faces[side] : counterpart(match, meshes, otherSide(side), faces[otherSide(side)]);
      if (own.length > 0) this.fly(side, own, flight);
    }
  }

  private fly(side: SideName, faces: ArrayLike<number>, flight: number): void {
    const pane = this.panes[side];
    const { centre, radius } = pane.extent(faces);
    const from = this.cameras.lookOf(side);
    const direction = new Vector3(...pane.normal(faces));
    if (direction.lengthSq() === 0) direction.copy(from.offset);
    // Not so near that nothing else is seen.
    const distance = Math.min(4.2, Math.max(0.5, 7 * radius));
    const to = { centre: new Vector3(...centre), offset: direction.normalize().multiplyScalar(distance) };
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.cameras.look(side, to);
      return;
    }
    const began = performance.now();
    const step = () => {
      if (this.flight !== flight) return;  // another has begun, or a hand is on the picture
      const share = Math.min(1, (performance.now() - began) / FLIGHT_MILLISECONDS);
      const eased = share * share * (3 - 2 * share);
      const length = from.offset.length() + eased * (to.offset.length() - from.offset.length());
      const offset = from.offset.clone().normalize().lerp(to.offset.clone().normalize(), eased);
      if (offset.lengthSq() < 1e-6) offset.copy(to.offset);
      this.cameras.look(side, {
        centre: from.centre.clone().lerp(to.centre, eased),
        offset: offset.normalize().multiplyScalar(length),
      });
      if (share < 1) requestAnimationFrame(step);
    };
    step();
  }

  /** Draw with the next frame, once however often it is asked for. */
  draw(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.drawNow();
    });
  }

  private drawNow(): void {
    if (!this.painted) return;
    const canvas = this.canvas.getBoundingClientRect();
    this.renderer.setClearColor(this.background);
    for (const side of SIDES) {
      const box = this.surfaces[side].getBoundingClientRect();
      const left = box.left - canvas.left;
      const bottom = canvas.bottom - box.bottom;
      this.renderer.setViewport(left, bottom, box.width, box.height);
      this.renderer.setScissor(left, bottom, box.width, box.height);
      this.renderer.render(this.panes[side].scene, this.cameras.cameras[side]);
    }
    if (performance.getEntriesByName("first-frame").length === 0) performance.mark("first-frame");
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement!;
    if (clientWidth === 0 || clientHeight === 0) return;
    const pixels = Math.min(2, devicePixelRatio || 1);
    this.renderer.setPixelRatio(pixels);
    this.renderer.setSize(clientWidth, clientHeight, false);
    for (const side of SIDES) this.panes[side].setPixelRatio(pixels);
    const box = this.surfaces.source.getBoundingClientRect();
    this.cameras.setAspect(box.width / Math.max(1, box.height));
    this.drawNow();
  }

  private listen(side: SideName): void {
    const surface = this.surfaces[side];
    let down: PointerEvent | null = null;
    let latest: PointerEvent | null = null;
    surface.addEventListener("wheel", () => ++this.flight, { passive: true });
    surface.addEventListener("pointerdown", (event) => {
      down = event;
      ++this.flight;
    });
    surface.addEventListener("pointermove", (event) => {
      if (event.buttons !== 0 || event.pointerType === "touch") return;
      // One look for each frame, at the newest place.
      const pending = latest !== null;
      latest = event;
      if (pending) return;
      requestAnimationFrame(() => {
        if (latest) this.events.pointed(side, this.pick(side, latest.clientX, latest.clientY));
        latest = null;
      });
    });
    surface.addEventListener("pointerleave", () => {
      latest = null;
      this.events.pointed(side, NONE);
    });
    surface.addEventListener("pointerup", (event) => {
      const still = down !== null && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < 5;
      down = null;
      if (!still || event.button !== 0) return;
      const face = this.pick(side, event.clientX, event.clientY);
      if (face !== NONE) this.events.clicked(side, face);
    });
  }
}
