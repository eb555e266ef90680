// When a report is drawn: first_frame.mjs PAGE TIMES, milliseconds after loading began, each in a browser of its own.
import { launch, open } from "./support.mjs";

const [page, times] = process.argv.slice(2);
const found = [];
for (let i = 0; i < Number(times); ++i) {
  const browser = await launch();
  const opened = await open(browser, page);
  const entry = await opened.waitForFunction(() => performance.getEntriesByName("first-frame")[0]?.startTime, null, { timeout: 60000 });
  found.push(Math.round(await entry.jsonValue()));
  await browser.close();
}
console.log(JSON.stringify(found));
