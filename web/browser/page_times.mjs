// What a large pair does to the page: page_times.mjs SOURCE TARGET, as JSON: milliseconds until the report stands, the longest the
// page did not listen meanwhile and for a while after, faces drawn of each side.
import { serve } from "./server.mjs";
import { launch, watched } from "./support.mjs";

const AFTERWARDS = 5000;
const LONG = { timeout: 600000 };

const [source, target] = process.argv.slice(2);
const [server, browser] = await Promise.all([serve(), launch()]);
const page = await watched(browser, () => true);
await page.addInitScript(() => {
  window.tasks = [];
  const note = (list) => list.getEntries().forEach((entry) => window.tasks.push(entry.duration));
  new PerformanceObserver(note).observe({ type: "longtask", buffered: true });
});
await page.goto(server.address);
await page.setInputFiles("#input-source", source);
const began = Date.now();
await page.setInputFiles("#input-target", target);
await page.waitForFunction(() => window.quadmatch !== undefined, null, LONG);
const report = Date.now() - began;
await page.waitForTimeout(AFTERWARDS);
const found = await page.evaluate(() => ({
  longest: Math.round(Math.max(0, ...window.tasks)),
  drawn: ["source", "target"].map((side) => window.quadmatch.report.shown[side]?.faces.length ?? window.quadmatch.report.meshes[side].faceCount),
}));
console.log(JSON.stringify({ report, ...found }));
await browser.close();
server.end();
