/** What stands above the report: places for files, options, progress, and what can be saved. It shows, and says what was
 *  asked for; page.ts knows what to do. */
import { button, element, grouped } from "../panel/dom";
import type { Slot } from "./engine";
import { SLOTS } from "./engine";
import { EXAMPLES } from "./examples";
import type { Files } from "./files";
import { endingOf } from "./files";
import type { Choice } from "./messages";

/** More faces than these of one mesh are not drawn: without a graphics card it would take seconds a picture. */
export const MOST_FACES = 100_000;

export type SaveKind = "match file" | "transfer" | "merge";

export interface DeskEvents {
  chosen(files: readonly File[], slot: Slot | null): void;
  example(index: number): void;
  swapped(): void;
  start(): void;
  cancel(): void;
  save(kind: SaveKind, ending: string): void;
}

const TITLES: Record<Slot, string> = {
  source: "Source",
  target: "Target",
  other: "Another edit of the source, to merge with the target",
};
const FORMATS = ["obj", "ply", "off", "usda"];
const LARGE_FILES =
  `Meshes of a million faces and more are matched in full. Of one of more than ${grouped(MOST_FACES)} faces the picture shows fewer. ` +
  "A browser gives a page 4 GB of memory at most; where that is too little, the page says so, and the command line does it.";
const ACCEPTED = ".obj,.ply,.off,.usda,.usd";

function select(id: string, label: string, values: readonly string[]): HTMLElement {
  return element("label", {}, `${label} `, element("select", { id }, ...values.map((value) => element("option", { value }, value))));
}

function number(id: string, label: string, attributes: Record<string, string>): HTMLElement {
  return element("label", {}, `${label} `, element("input", { id, type: "number", ...attributes }));
}

const control = (id: string) => document.getElementById(id) as HTMLInputElement | HTMLSelectElement;

export class Desk {
  readonly element = element("div", { class: "desk" });
  private readonly names = new Map<Slot, HTMLElement>();
  private readonly status = element("p", { id: "status", role: "status", "aria-live": "polite" });
  private readonly trouble = element("p", { id: "trouble", role: "alert" });
  private readonly warnings = element("ul", { id: "warnings", "aria-label": "Warnings" });
  private readonly bar = element("progress", { id: "progress", "aria-label": "Progress" });
  private readonly start: HTMLButtonElement;
  private readonly cancel: HTMLButtonElement;
  private readonly swap: HTMLButtonElement;
  private readonly results = element("div", { class: "row", id: "results", hidden: true });
  private readonly merge = element("span", { class: "row" });
  private readonly summary = element("pre", { id: "summary", tabindex: "0", "aria-label": "What was done", hidden: true });

  constructor(private readonly events: DeskEvents) {
    this.start = button("Match", { id: "start", disabled: true }, () => events.start());
    this.cancel = button("Cancel", { id: "cancel", hidden: true }, () => events.cancel());
    this.swap = button("Swap", { id: "swap", disabled: true, title: "Source becomes target" }, () => events.swapped());
    this.bar.hidden = true;
    this.makeResults();
    this.element.append(
      element("h1", {}, "quadmatch"),
      element(
        "p",
        {},
        "Finds which parts of two quad meshes are the same, from connectivity alone. Drop two files here: OBJ, PLY, OFF or USDA. " +
          "All is done by this browser; nothing is sent anywhere.",
      ),
      element("div", { class: "slots" }, ...SLOTS.map((slot) => this.makeSlot(slot))),
      element("div", { class: "row" }, this.start, this.cancel, this.swap, this.makeExamples()),
      this.makeOptions(),
      element("details", {}, element("summary", {}, "Large files"), element("p", {}, LARGE_FILES)),
      element("div", { class: "row" }, this.bar, this.status),
      this.trouble,
      this.warnings,
      this.results,
      this.summary,
    );
  }

  /** The options as they stand, by their names on the command line. */
  choices(): Choice[] {
    const algorithm = control("algorithm").value;
    const choices: Choice[] = [
      ["algorithm", algorithm],
      ["orientation", control("orientation").value],
      ["positions", String((control("positions") as HTMLInputElement).checked)],
      ["min-region", control("min-region").value || "1"],
    ];
    if (algorithm === "exact") choices.push(["time-limit", control("time-limit").value || "0"]);
    return choices;
  }

  mergeChoices(): Choice[] {
    return [["prefer", control("prefer").value]];
  }

  showFiles(files: Files): void {
    for (const slot of SLOTS) this.names.get(slot)!.textContent = files[slot]?.name ?? "none yet";
    this.swap.disabled = this.start.disabled = !files.source || !files.target;
    this.merge.hidden = !files.other;
    for (const id of ["transfer-format", "merge-format"]) control(id).value = endingOf(files.target?.name ?? "");
  }

  /** What is being done; empty: nothing. */
  working(text: string): void {
    const works = text !== "";
    this.cancel.hidden = this.bar.hidden = !works;
    this.status.textContent = text;
    this.bar.removeAttribute("value");
    for (const one of this.results.querySelectorAll("button")) one.disabled = works;
  }

  say(text: string): void {
    this.status.textContent = text;
  }

  progress(done: number, most: number): void {
    this.bar.max = Math.max(1, most);
    this.bar.value = done;
  }

  complain(text: string): void {
    this.trouble.textContent = text;
  }

  warn(text: string): void {
    this.warnings.append(element("li", {}, text));
  }

  /** Nothing said, nothing to save. */
  clear(): void {
    this.trouble.textContent = "";
    this.warnings.replaceChildren();
    this.showResults(false);
  }

  showResults(visible: boolean): void {
    this.results.hidden = !visible;
    this.showSummary("");
  }

  showSummary(text: string): void {
    this.summary.textContent = text;
    this.summary.hidden = text === "";
  }

  private makeSlot(slot: Slot): HTMLElement {
    const name = element("span", { class: "file", id: `file-${slot}` }, "none yet");
    const input = element("input", { type: "file", id: `input-${slot}`, accept: ACCEPTED });
    this.names.set(slot, name);
    input.addEventListener("change", () => {
      this.events.chosen([...(input.files ?? [])], slot);
      input.value = "";  // so that the same file can be chosen again
    });
    return element("label", { class: "slot", "data-slot": slot }, element("span", { class: "slot-title" }, TITLES[slot]), name, input);
  }

  private makeExamples(): HTMLElement {
    const list = element("select", { id: "example", "aria-label": "Example" });
    EXAMPLES.forEach(({ title }, index) => list.append(element("option", { value: String(index) }, title)));
    const open = button("Open example", { id: "open-example" }, () => this.events.example(Number(list.value)));
    return element("span", { class: "row examples" }, list, open);
  }

  private makeOptions(): HTMLElement {
    const positions = element("input", { id: "positions", type: "checkbox", checked: true });
    return element(
      "details",
      { id: "options" },
      element("summary", {}, "Options"),
      element(
        "div",
        { class: "row" },
        select("algorithm", "Algorithm", ["regions", "lazy-greedy", "greedy", "exact"]),
        select("orientation", "Orientation", ["auto", "preserving", "reversing"]),
        element("label", {}, positions, " Positions decide where connectivity leaves a choice"),
        number("min-region", "Regions of at least so many faces", { min: "1", step: "1", value: "1" }),
        number("time-limit", "exact: end after so many seconds, 0: never", { min: "0", step: "1", value: "10" }),
      ),
    );
  }

  private makeResults(): void {
    const save = (kind: SaveKind, text: string, format?: string) =>
      button(text, { id: `save-${kind.replace(" ", "-")}` }, () => this.events.save(kind, format ? control(format).value : "json"));
    this.merge.append(
      save("merge", "Save merge of target and other edit", "merge-format"),
      select("merge-format", "as", FORMATS),
      select("prefer", "where edits meet take", ["ours", "theirs"]),
    );
    this.results.append(
      save("match file", "Save match file"),
      element("span", { class: "row" }, save("transfer", "Save target with the source's data", "transfer-format"), select("transfer-format", "as", FORMATS)),
      this.merge,
    );
  }
}
