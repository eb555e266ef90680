/** One mesh in the picture: its faces, what is marked on it, what is pointed at. */
import type { Material, Object3D, PerspectiveCamera } from "three";
import { BufferAttribute, BufferGeometry, DoubleSide, LineSegments, Mesh, Points, Raycaster, Scene, Vector2 } from "three";
import { MeshBVH } from "three-mesh-bvh";
import type { MatchData } from "../data/match";
import { NONE } from "../data/match";
import type { SideName } from "../data/header";
import type { MeshData } from "../data/mesh";
import type { Rgb } from "./colours";
import { valenceColour } from "./colours";
import type { Frame, Solid } from "./geometry";
import type { Coarse } from "./coarse";
import { extentOf, facesOf, framed, frameOf, linesOf, normalOf, outlinesOf, pointsOf, solidOf } from "./geometry";
import { faceMaterial, lineMaterial, pointMaterial, veilMaterial } from "./materials";

/** What can be shown on top of the faces. */
export const LAYERS = {
  wireframe: "Wireframe",
  ambiguous: "Ambiguous, hatched",
  seams: "Seams, borders of regions",
  skeleton: "Skeleton and crossings",
  extraordinary: "Extraordinary vertices",
  anchors: "Anchors",
} as const;
export type Layer = keyof typeof LAYERS;

const SKELETON: Rgb = [20, 60, 130];
const BORDER: Rgb = [30, 30, 30];
const CUT: Rgb = [200, 0, 160];
const POINTED: Rgb = [255, 225, 60];
const PINNED: Rgb = [255, 120, 220];
const CROSSING: Rgb = [255, 255, 255];
const ANCHOR: Rgb = [60, 200, 80];

export interface PaneOptions {
  side: SideName;
  mesh: MeshData;
  match: MatchData;
  /** Drawn instead of the mesh's faces, where they are too many. */
  shown: Coarse | null;
}

function geometryOf(points: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  return geometry;
}

export class Pane {
  readonly scene = new Scene();
  private readonly points: Float32Array;
  private readonly solid: Solid;
  private readonly paint: Uint8Array;
  private readonly paintAttribute: BufferAttribute;
  private readonly faces: Mesh;
  private readonly faceMaterial = faceMaterial();
  private readonly pointMaterials = [pointMaterial(8), pointMaterial(5), pointMaterial(12)];
  private readonly layers = new Map<Layer, Object3D[]>();
  private marks: { pointed: Object3D[]; pinned: Object3D[] } = { pointed: [], pinned: [] };
  private tree: MeshBVH | null = null;

  constructor(private readonly options: PaneOptions) {
    const { mesh, shown } = options;
    const frame = frameOf(mesh.positions!);
    this.points = framed(mesh.positions!, frame);
    this.solid = solidOf(shown ?? mesh, this.points);
    this.paint = new Uint8Array(12 * this.solid.faceOf.length);
    this.paintAttribute = new BufferAttribute(this.paint, 4, true);
    const geometry = geometryOf(this.solid.positions);
    geometry.setAttribute("edges", new BufferAttribute(this.solid.edges, 4, true));
    geometry.setAttribute("paint", this.paintAttribute);
    this.faces = new Mesh(geometry, this.faceMaterial);
    this.add(this.faces);
  }

  /** Give every face its colour; hatch those that are told so. */
  paintFaces(colourOf: (face: number) => Rgb, hatched: (face: number) => boolean): void {
    const { paint, solid } = this;
    let colour: Rgb = [0, 0, 0];
    let alpha = 255;
    for (let t = 0; t < solid.faceOf.length; ++t) {
      const face = solid.faceOf[t];
      if (t === 0 || face !== solid.faceOf[t - 1]) {
        colour = colourOf(face);
        alpha = hatched(face) ? 0 : 255;
      }
      for (let at = 12 * t; at < 12 * (t + 1); at += 4) {
        paint[at] = colour[0];
        paint[at + 1] = colour[1];
        paint[at + 2] = colour[2];
        paint[at + 3] = alpha;
      }
    }
    this.paintAttribute.needsUpdate = true;
  }

  /** Show or hide what is on top of the faces; it is made when it is first asked for. */
  show(layer: Layer, visible: boolean): void {
    if (layer === "wireframe") {
      this.faceMaterial.uniforms.wire.value = visible ? 1 : 0;
      return;
    }
    if (!visible && !this.layers.has(layer)) return;
    let objects = this.layers.get(layer);
    if (!objects) {
      objects = this.makeLayer(layer);
      for (const object of objects) this.add(object);
      this.layers.set(layer, objects);
    }
    for (const object of objects) object.visible = visible;
  }

  /** Mark faces through all that is in front of them. */
  mark(kind: "pointed" | "pinned", faces: readonly number[]): void {
    for (const object of this.marks[kind]) this.remove(object);
    this.marks[kind] = [];
    if (faces.length === 0) return;
    const rgb = kind === "pointed" ? POINTED : PINNED;
    const veil = new Mesh(geometryOf(solidOf(facesOf(this.options.mesh, faces), this.points).positions), veilMaterial(rgb, faces.length === 1 ? 0.85 : 0.35));
    const outline = new LineSegments(
      geometryOf(outlinesOf(this.options.mesh, this.points, faces)),
      lineMaterial([20, 20, 20], true),
    );
    veil.renderOrder = 10;
    outline.renderOrder = 11;
    this.marks[kind] = [veil, outline];
    for (const object of this.marks[kind]) this.add(object);
  }

  /** The face under a point of the pane, each coordinate from -1 to 1; NONE where there is none. */
  pick(place: Vector2, camera: PerspectiveCamera): number {
    // Made when first asked for: the first picture does not wait for it.
    this.tree ??= new MeshBVH(this.faces.geometry, { indirect: true });
    const caster = new Raycaster();
    caster.setFromCamera(place, camera);
    const hit = this.tree.raycastFirst(caster.ray, DoubleSide, camera.near, camera.far);
    return hit && typeof hit.faceIndex === "number" ? this.solid.faceOf[hit.faceIndex] : NONE;
  }

  /** Where some faces lie in the pane's space. */
  extent(faces: ArrayLike<number>): Frame {
    return extentOf(this.options.mesh, this.points, faces);
  }

  normal(faces: ArrayLike<number>): [number, number, number] {
    return normalOf(this.options.mesh, this.points, faces);
  }

  setPixelRatio(pixels: number): void {
    this.faceMaterial.uniforms.pixels.value = pixels;
    for (const material of this.pointMaterials) material.uniforms.pixels.value = pixels;
  }

  private makeLayer(layer: Layer): Object3D[] {
    const { mesh, match, side } = this.options;
    switch (layer) {
      case "skeleton":
        return [
          this.lines(linesOf(mesh, this.points, mesh.skeleton), SKELETON),
          this.dots(mesh.crossings, () => CROSSING, 1),
        ];
      case "seams":
        return [
          this.lines(linesOf(mesh, this.points, mesh.borders), BORDER),
          this.lines(pointsOf(this.points, mesh.seams), CUT),
        ];
      case "extraordinary":
        return [
          this.dots(
            mesh.extraordinary.map((found) => found.vertex),
            (i) => valenceColour(mesh.extraordinary[i].valence),
            0,
          ),
        ];
      case "anchors":
        return [this.seedDots(match.seeds.map((seed) => seed[side]))];
      default:
        return [];
    }
  }

  private lines(ends: Float32Array, rgb: Rgb): Object3D {
    return new LineSegments(geometryOf(ends), lineMaterial(rgb));
  }

  private dots(vertices: ArrayLike<number>, colourOf: (index: number) => Rgb, material: number): Object3D {
    return this.coloured(pointsOf(this.points, vertices), colourOf, material);
  }

  /** A dot in the middle of each face. */
  private seedDots(faces: number[]): Object3D {
    const middles = new Float32Array(3 * faces.length);
    faces.forEach((face, i) => middles.set(this.extent([face]).centre, 3 * i));
    return this.coloured(middles, () => ANCHOR, 2);
  }

  private coloured(places: Float32Array, colourOf: (index: number) => Rgb, material: number): Object3D {
    const geometry = geometryOf(places);
    const colours = new Uint8Array(places.length);
    for (let i = 0; i < places.length / 3; ++i) colours.set(colourOf(i), 3 * i);
    geometry.setAttribute("paint", new BufferAttribute(colours, 3, true));
    return new Points(geometry, this.pointMaterials[material]);
  }

  private add(object: Object3D): void {
    object.frustumCulled = false;
    this.scene.add(object);
  }

  /** Give the memory of the graphics card back. */
  dispose(): void {
    for (const object of [...this.scene.children]) this.remove(object);
  }

  private remove(object: Object3D): void {
    this.scene.remove(object);
    if (!(object instanceof Mesh || object instanceof LineSegments || object instanceof Points)) return;
    object.geometry.dispose();
    (object.material as Material).dispose();
  }
}
