/** Two cameras that look at their meshes from the same direction and distance, as long as they are linked. */
import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { SideName } from "../data/header";
import { otherSide, SIDES } from "../data/header";

const FIELD_OF_VIEW = 30;
/** From slightly above and aside. */
const HOME = new Vector3(-0.42, 0.3, 1).normalize();
/** The unit sphere fills the view at this distance. */
const HOME_DISTANCE = 1.05 / Math.sin(((FIELD_OF_VIEW / 2) * Math.PI) / 180);

export interface Look {
  centre: Vector3;
  /** From the centre to the camera. */
  offset: Vector3;
}

export class LinkedCameras {
  readonly cameras: Record<SideName, PerspectiveCamera>;
  linked = true;
  private readonly controls: Record<SideName, OrbitControls>;
  private following = false;
  /** Where each camera looked last. */
  private readonly centres: Record<SideName, Vector3> = { source: new Vector3(), target: new Vector3() };

  constructor(surfaces: Record<SideName, HTMLElement>, private readonly changed: () => void) {
    const make = () => new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
    this.cameras = { source: make(), target: make() };
    this.controls = {
      source: new OrbitControls(this.cameras.source, surfaces.source),
      target: new OrbitControls(this.cameras.target, surfaces.target),
    };
    for (const side of SIDES) {
      const controls = this.controls[side];
      controls.minDistance = 0.02;
      controls.maxDistance = 4 * HOME_DISTANCE;
      controls.addEventListener("change", () => this.follow(side));
    }
    this.home();
  }

  home(): void {
    for (const side of SIDES) {
      this.look(side, { centre: new Vector3(), offset: HOME.clone().multiplyScalar(HOME_DISTANCE) });
    }
  }

  dispose(): void {
    for (const side of SIDES) this.controls[side].dispose();
  }

  lookOf(side: SideName): Look {
    const centre = this.controls[side].target.clone();
    return { centre, offset: this.cameras[side].position.clone().sub(centre) };
  }

  /** Move one camera, and not the other with it. */
  look(side: SideName, look: Look): void {
    this.following = true;
    this.centres[side].copy(look.centre);
    this.controls[side].target.copy(look.centre);
    this.cameras[side].position.copy(look.centre).add(look.offset);
    this.controls[side].update();
    this.following = false;
    this.changed();
  }

  /** Turn about the upright axis and tilt, in radians, and go nearer by a factor. */
  move(side: SideName, turn: number, tilt: number, nearer: number): void {
    const { offset } = this.lookOf(side);
    const upright = new Vector3(0, 1, 0);
    const aside = new Vector3().crossVectors(upright, offset).normalize();
    const steep = offset.angleTo(upright);
    const most = Math.max(-(Math.PI - 0.05 - steep), Math.min(steep - 0.05, tilt));
    offset.applyAxisAngle(aside, -most).applyAxisAngle(upright, turn).divideScalar(nearer);
    for (const moving of this.linked ? SIDES : [side]) {
      this.look(moving, { centre: this.centres[moving].clone(), offset });
    }
  }

  setAspect(aspect: number): void {
    for (const side of SIDES) {
      const camera = this.cameras[side];
      camera.aspect = aspect;
      // A narrow view shows as much as a square one.
      camera.zoom = Math.min(1, aspect);
      camera.updateProjectionMatrix();
    }
  }

  /** The other camera does as this one did. */
  private follow(side: SideName): void {
    if (this.following) return;
    const { offset, centre } = this.lookOf(side);
    const moved = centre.clone().sub(this.centres[side]);
    this.centres[side].copy(centre);
    if (this.linked) {
      const other = otherSide(side);
      this.look(other, { centre: this.centres[other].clone().add(moved), offset });
    }
    this.changed();
  }
}
