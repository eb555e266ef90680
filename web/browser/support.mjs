/** The real program makes reports, and a real browser opens them from disk. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { ROOT } from "./root.mjs";

export { ROOT };
export const EXAMPLES = join(ROOT, "examples");
export const BUILD = resolve(process.env.QUADMATCH_BUILD ?? join(ROOT, "build/release"));

/** A folder that is gone when the tests are over. */
export const folder = mkdtempSync(join(tmpdir(), "quadmatch-web-"));
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));

export function run(program, ...words) {
  const { status, stdout, stderr, error } = spawnSync(join(BUILD, program), words, { encoding: "utf8", cwd: folder });
  if (error) throw error;
  if (status > 1) throw new Error(`${program} ${words.join(" ")}: ${stderr}`);
  return stdout;
}

let made = 0;
/** Match two files: the report's path, and the match file with its waves. */
export function report(source, target, ...more) {
  const name = join(folder, `report-${++made}`);
  run("quadmatch", "match", source, target, "-o", `${name}.json`, "--report", `${name}.html`, "--waves", "--quiet", ...more);
  return { page: `${name}.html`, match: JSON.parse(readFileSync(`${name}.json`, "utf8")) };
}

const BY_SOFTWARE = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

export function launch(...flags) {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", ...(flags.length > 0 ? flags : BY_SOFTWARE)],
  });
}

/** A page whose `troubles` keep what goes wrong in it, and what it asks of the network that `allowed` does not allow. */
export async function watched(browser, allowed, options = {}) {
  const { script, ...context } = options;
  const page = await browser.newPage({ viewport: { width: 1200, height: 760 }, reducedMotion: "reduce", ...context });
  page.troubles = [];
  page.on("console", (message) => {
    if (message.type() === "error") page.troubles.push(message.text());
  });
  page.on("pageerror", (error) => page.troubles.push(error.message));
  page.on("dialog", (dialog) => {
    page.troubles.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  page.on("request", (request) => {
    if (!allowed(request.url()) && !/^(data|blob):/.test(request.url())) page.troubles.push(request.url());
  });
  if (script) await page.addInitScript(script);
  return page;
}

/** Open a report from disk, which may ask for nothing else. */
export async function open(browser, path, options = {}) {
  const page = await watched(browser, (address) => address === pathToFileURL(path).href, options);
  await page.goto(pathToFileURL(path).href);
  await page.waitForFunction(() => window.quadmatch !== undefined || document.querySelector("[role=alert]"));
  return page;
}

/** Wait until all that was asked for is drawn. */
export function drawn(page) {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))));
}

/** The pixels of the page as it is, at some places: red, green, blue. */
export async function pixels(browser, page, places) {
  const shot = (await page.screenshot()).toString("base64");
  const blank = await browser.newPage();
  const found = await blank.evaluate(
    async ([data, list]) => {
      const picture = new Image();
      picture.src = `data:image/png;base64,${data}`;
      await picture.decode();
      const canvas = document.createElement("canvas");
      canvas.width = picture.width;
      canvas.height = picture.height;
      const context = canvas.getContext("2d");
      context.drawImage(picture, 0, 0);
      const { data: rgba } = context.getImageData(0, 0, canvas.width, canvas.height);
      return list.map(([x, y]) => [...rgba.slice(4 * (y * canvas.width + x), 4 * (y * canvas.width + x) + 3)]);
    },
    [shot, places],
  );
  await blank.close();
  return found;
}

/** The partner of each face of one side (0: source, 1: target). */
export function partners(match, side) {
  return new Map(match.regions.flatMap((region) => region.faces.map((pair) => [pair[side], pair[1 - side]])));
}

/** What the report says of what is pointed at. */
export const said = (page) => page.textContent("#said");

export const isRed = ([red, green, blue]) => red > 90 && red > 2.4 * green && red > 2.4 * blue;

/** Points all over a view, in pixels of the page. */
export async function places(page, side, count) {
  const box = await page.locator(`#view-${side}`).boundingBox();
  const found = [];
  for (let i = 1; i < count; ++i) {
    for (let j = 1; j < count; ++j) found.push([Math.round(box.x + (box.width * i) / count), Math.round(box.y + (box.height * j) / count)]);
  }
  return found;
}

/** How many faces of either kind were met at so many places a side; a pixel is red exactly where its face has no partner. */
export async function checkRed(browser, page, side, hasPartner, count) {
  const sought = await places(page, side, count);
  const colours = await pixels(browser, page, sought);
  const picked = await page.evaluate(
    ([name, list]) =>
      list.map(([x, y]) => {
        // A pixel at the border of a face may be of either colour, so its neighbours are looked at too.
        const around = [[0.5, 0.5], [-1, -1], [-1, 2], [2, -1], [2, 2]];
        return around.map(([dx, dy]) => window.quadmatch.picture.pick(name, x + dx, y + dy));
      }),
    [side, sought],
  );
  let red = 0;
  let other = 0;
  sought.forEach(([x, y], i) => {
    const unmatched = picked[i].map((face) => face >= 0 && !hasPartner(face));
    if (unmatched.some((answer) => answer !== unmatched[0])) return;
    assert.equal(isRed(colours[i]), unmatched[0], `pixel ${x}, ${y} of the ${side}: ${colours[i]}, face ${picked[i][0]}`);
    if (unmatched[0]) ++red;
    else if (picked[i][0] >= 0) ++other;
  });
  return { red, other };
}
