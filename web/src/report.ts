/** Where a report starts: unpack it, show it, or say why not. */
import "./report.css";
import { App } from "./app";
import { unpackReport } from "./data/report";
import { element } from "./panel/dom";

declare global {
  interface Window {
    /** For scripts and tests: what is shown. */
    quadmatch?: App;
  }
}

const root = document.getElementById("app")!;
const textOf = (id: string) => document.getElementById(id)?.textContent ?? "";

try {
  window.quadmatch = new App(unpackReport(textOf("report-header"), textOf("report-data")), root);
} catch (error) {
  const reason = error instanceof Error ? error.message : String(error);
  root.append(element("p", { class: "excuse", role: "alert" }, `The report cannot be shown: ${reason}`));
}
