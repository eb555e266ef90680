/** The page: two files in, a report to look at and files to save out. Nothing leaves the machine. */
import "../report.css";
import "./page.css";
import { App } from "../app";
import type { Report } from "../data/report";
import type { SaveKind } from "./desk";
import { Desk, MOST_FACES } from "./desk";
import type { Slot } from "./engine";
import { EXAMPLES, exampleFiles } from "./examples";
import type { Files } from "./files";
import { dropped, stemOf } from "./files";
import type { Reply } from "./messages";
import { compiledEngine, Work } from "./work";

declare global {
  interface Window {
    /** For scripts and tests: what is shown. */
    quadmatch?: App;
  }
}

class Page {
  private files: Files = {};
  private readonly root = document.getElementById("app")!;
  private readonly desk: Desk;
  private readonly work = new Work((reply) => this.hear(reply));
  /** Counts what was begun, so that what was overtaken while it waited is let go. */
  private begun = 0;
  /** The other edit that the worker has. */
  private otherThere: File | null = null;

  constructor() {
    this.desk = new Desk({
      chosen: (files, slot) => this.take(files, slot),
      example: (index) => void this.openExample(index),
      swapped: () => this.setFiles({ ...this.files, source: this.files.target, target: this.files.source }),
      start: () => void this.start(),
      cancel: () => this.cancel(),
      save: (kind, ending) => this.save(kind, ending),
    });
    document.getElementById("desk")!.append(this.desk.element);
    this.desk.showFiles(this.files);
    this.listenToDrops();
    this.warm().catch((error: unknown) => this.desk.complain(`The engine cannot be started: ${String(error)}`));
  }

  /** Get the engine ready while files are being looked for. */
  private async warm(): Promise<void> {
    const engine = await compiledEngine();
    const [source, target] = await exampleFiles(EXAMPLES[0]);
    if (this.begun === 0) this.work.warm({ kind: "match", engine, source, target, choices: [], mostFaces: MOST_FACES });
  }

  private listenToDrops(): void {
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      const items = [...(event.dataTransfer?.items ?? [])];
      const folder = items.map((item) => item.webkitGetAsEntry?.()).find((entry) => entry?.isDirectory);
      if (folder) {
        this.desk.complain(`${folder.name}: this is a folder; drop the files in it`);
        return;
      }
      const place = event.target instanceof Element ? event.target.closest<HTMLElement>("[data-slot]") : null;
      this.take([...(event.dataTransfer?.files ?? [])], (place?.dataset.slot as Slot | undefined) ?? null);
    });
  }

  private take(files: readonly File[], slot: Slot | null): void {
    const now = dropped(this.files, files, slot);
    if (typeof now === "string") this.desk.complain(now);
    // The other edit is no part of the match: what is shown stays.
    else if (slot === "other" && this.files.source && this.files.target) {
      this.files = now;
      this.desk.showFiles(now);
    } else this.setFiles(now);
  }

  private async openExample(index: number): Promise<void> {
    const begun = this.stop();
    try {
      const files = await exampleFiles(EXAMPLES[index]);
      if (begun === this.begun) this.take(files, null);
    } catch (error) {
      this.desk.complain(`The example cannot be loaded: ${String(error)}`);
    }
  }

  private setFiles(files: Files): void {
    this.files = files;
    this.desk.showFiles(files);
    if (files.source && files.target) void this.start();
    else this.stop();
  }

  /** End what is going on, and take away what is shown. */
  private stop(): number {
    this.work.end();
    window.quadmatch?.dispose();
    window.quadmatch = undefined;
    this.otherThere = null;
    this.desk.clear();
    this.desk.working("");
    return ++this.begun;
  }

  private async start(): Promise<void> {
    const { source, target } = this.files;
    if (!source || !target) return;
    const begun = this.stop();
    this.desk.working("starting");
    try {
      const engine = await compiledEngine();
      if (begun !== this.begun) return;
      this.work.begin({ kind: "match", engine, source, target, choices: this.desk.choices(), mostFaces: MOST_FACES });
    } catch (error) {
      if (begun !== this.begun) return;
      this.desk.working("");
      this.desk.complain(`The engine cannot be started: ${String(error)}`);
    }
  }

  private cancel(): void {
    this.stop();
    this.desk.say("Cancelled");
  }

  private save(kind: SaveKind, ending: string): void {
    const { source, target, other } = this.files;
    if (!source || !target) return;
    this.desk.complain("");
    this.desk.showSummary("");
    this.desk.working("starting");
    const [a, b] = [stemOf(source.name), stemOf(target.name)];
    if (kind === "match file") this.work.ask({ kind, name: `${a}_${b}.${ending}` });
    else if (kind === "transfer") this.work.ask({ kind, name: `${b}_with_${a}.${ending}` });
    else if (other) {
      const unread = other === this.otherThere ? null : other;
      this.otherThere = other;
      this.work.ask({ kind, name: `${b}_${stemOf(other.name)}.${ending}`, other: unread, choices: this.desk.mergeChoices() });
    }
  }

  private hear(reply: Reply): void {
    switch (reply.kind) {
      case "stage":
        return this.desk.working(reply.text);
      case "progress":
        return this.desk.progress(reply.done, reply.most);
      case "warning":
        return this.desk.warn(reply.text);
      case "report":
        return this.showReport(reply.report);
      case "file":
        this.desk.working("");
        this.desk.showSummary(reply.summary);
        return download(reply.name, reply.bytes);
      case "refused":
        this.refused(reply.text, reply.lost);
    }
  }

  private showReport(report: Report): void {
    this.desk.working("");
    this.desk.showResults(true);
    window.quadmatch = new App(report, this.root);
    this.desk.say("Matched");
  }

  private refused(text: string, lost: boolean): void {
    this.otherThere = null;
    // Without a report there is nothing to go on from.
    if (lost || !window.quadmatch) this.stop();
    this.desk.working("");
    this.desk.complain(text);
  }
}

function download(name: string, bytes: Uint8Array): void {
  const address = URL.createObjectURL(new Blob([bytes as BlobPart]));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

new Page();
