/** Keys, wherever the focus is but in a field one types into. */
import { element } from "./dom";

export interface KeyEvents {
  turn(turn: number, tilt: number, nearer: number): void;
  home(): void;
  step(by: number): void;
  play(): void;
  change(by: number): void;
  release(): void;
  search(): void;
  wireframe(): void;
}

const TURN = 0.15;
const NEARER = 1.2;

const HELP: [keys: string, does: string][] = [
  ["Arrows", "turn, with a mesh in focus"],
  ["+ and -", "nearer, farther"],
  ["0", "whole view"],
  ["Space", "play or pause the growth"],
  ["[ and ]", "a wave back, a wave on"],
  ["N and P", "next and previous change"],
  ["/", "search"],
  ["W", "wireframe"],
  ["Escape", "let go of all that is pinned"],
];

export function keyHelp(): HTMLElement {
  const list = element("dl", { class: "keys" });
  for (const [keys, does] of HELP) list.append(element("dt", {}, keys), element("dd", {}, does));
  return element("details", {}, element("summary", {}, "Keys"), list);
}

function isTypedInto(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.matches("input:not([type=checkbox]), select, textarea");
}

/** @param signal  ends it. */
export function listenToKeys(events: KeyEvents, signal: AbortSignal): void {
  const onMesh: Record<string, () => void> = {
    ArrowLeft: () => events.turn(-TURN, 0, 1),
    ArrowRight: () => events.turn(TURN, 0, 1),
    ArrowUp: () => events.turn(0, TURN, 1),
    ArrowDown: () => events.turn(0, -TURN, 1),
  };
  const anywhere: Record<string, () => void> = {
    "+": () => events.turn(0, 0, NEARER),
    "=": () => events.turn(0, 0, NEARER),
    "-": () => events.turn(0, 0, 1 / NEARER),
    "0": events.home,
    "[": () => events.step(-1),
    "]": () => events.step(1),
    n: () => events.change(1),
    p: () => events.change(-1),
    w: events.wireframe,
    "/": events.search,
    Escape: events.release,
  };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const target = event.target as HTMLElement;
    if (event.key === "Escape" && isTypedInto(target)) target.blur();
    else if (isTypedInto(target)) return;
    const onButton = target instanceof HTMLElement && target.matches("button, summary, input");
    const act =
      event.key === " " ? (onButton ? undefined : events.play) : target.closest?.(".view") && onMesh[event.key]
        ? onMesh[event.key]
        : anywhere[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }, { signal });
}
