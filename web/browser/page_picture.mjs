// The picture of the page in its documentation: page_picture.mjs OUT.png, the first example as the page shows it.
import { serve } from "./server.mjs";
import { drawn, launch, watched } from "./support.mjs";

const [server, browser] = await Promise.all([serve(), launch()]);
const page = await watched(browser, () => true, { viewport: { width: 1200, height: 980 }, deviceScaleFactor: 1 });
await page.goto(server.address);
await page.click("#open-example");
await page.waitForFunction(() => window.quadmatch !== undefined);
// The report is as high as the window; here both have to fit into one picture.
await page.evaluate(() => (document.getElementById("app").style.height = `${980 - document.querySelector(".desk").offsetHeight}px`));
await page.waitForTimeout(300);
await drawn(page);
await page.screenshot({ path: process.argv[2] });
await browser.close();
server.end();
