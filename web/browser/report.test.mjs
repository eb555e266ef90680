// What a report shows, seen by a browser and held against the match file.
import assert from "node:assert/strict";
import { existsSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import {
  checkRed, drawn, EXAMPLES, folder, isRed, launch, open, partners, pixels, places, report, ROOT, said,
} from "./support.mjs";

const BEARS = [join(EXAMPLES, "bear.obj"), join(EXAMPLES, "bear_no_ears_posed.obj")];
const SIDES = ["source", "target"];
let browser;
let bears;

before(async () => {
  browser = await launch();
  bears = report(...BEARS);
});
after(() => browser?.close());

test("a report opens from disk, asks nothing of the network and has no error in the console", async () => {
  const page = await open(browser, bears.page);
  await drawn(page);
  assert.deepEqual(page.troubles, []);
  assert.equal(await page.title(), "bear.obj and bear_no_ears_posed.obj");
  assert.match(await page.textContent(".figures"), /2,944 faces, 89\.8 % matched, 300 unmatched in 2 areas/);
  assert.equal(await page.locator("[data-change]").count(), 4);
  assert.equal(await page.locator("[data-region]").count(), bears.match.regions.length);
  await page.close();
});

test("pointing at a face tells its partner, as the match file has it", async () => {
  const page = await open(browser, bears.page);
  for (const [index, side] of SIDES.entries()) {
    const partner = partners(bears.match, index);
    const seen = new Set();
    for (const [x, y] of await places(page, side, 9)) {
      await page.evaluate(() => (document.getElementById("said").textContent = ""));
      await page.mouse.move(x, y);
      await drawn(page);
      const text = await said(page);
      if (text === "") continue;  // beside the bear
      const face = Number(/^f(\d+) of the (source|target)/.exec(text)[1]);
      const expected = partner.has(face) ? `lies on f${partner.get(face)} of the ${SIDES[1 - index]}` : "has no partner";
      assert.ok(text.startsWith(`f${face} of the ${side} ${expected}`), text);
      seen.add(face);
    }
    assert.ok(seen.size > 12, `only ${seen.size} faces of the ${side} were met`);
  }
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("what is unmatched is red, and nothing else is", async () => {
  const page = await open(browser, bears.page);
  await page.uncheck("#layer-wireframe");
  await drawn(page);
  for (const [index, side] of SIDES.entries()) {
    const partner = partners(bears.match, index);
    const { red, other } = await checkRed(browser, page, side, (face) => partner.has(face), 70);
    assert.ok(red >= (index === 0 ? 60 : 10) && other > 500, `${side}: ${red} red places, ${other} others`);
  }
  await page.close();
});

test("the slider goes wave by wave as the match file, and its last wave is the match", async () => {
  for (const algorithm of ["greedy", "lazy-greedy", "regions"]) {
    const { page: path, match } = algorithm === "regions" ? bears : report(...BEARS, "--algorithm", algorithm);
    const page = await open(browser, path);
    const waves = Math.max(...match.regions.map((region) => region.waves.length));
    assert.equal(await page.getAttribute("#wave", "max"), String(waves - 1));
    for (const wave of [0, 1, Math.floor(waves / 2), waves - 1]) {
      await page.locator("#wave").fill(String(wave));
      const matched = match.regions.reduce((sum, region) => sum + region.waves[Math.min(wave, region.waves.length - 1)], 0);
      const text = `wave ${wave + 1} of ${waves}: ${matched.toLocaleString("en")} faces matched`;
      assert.equal(await page.textContent("#wave-text"), text);
    }
    const all = match.regions.reduce((sum, region) => sum + region.faces.length, 0);
    assert.match(await page.textContent("#wave-text"), new RegExp(`: ${all.toLocaleString("en")} faces matched$`));
    await page.close();
  }
});

test("in the first wave only the seed is painted as matched, in the last all is as before", async () => {
  const page = await open(browser, bears.page);
  await drawn(page);
  const whole = (await page.locator(".stage").screenshot()).toString("base64");
  await page.locator("#wave").fill("0");
  await drawn(page);
  const first = await pixels(browser, page, await places(page, "source", 60));
  assert.ok(!first.some(isRed));
  const early = (await page.locator(".stage").screenshot()).toString("base64");
  assert.notEqual(early, whole);
  await page.locator("#wave").fill(await page.getAttribute("#wave", "max"));
  await drawn(page);
  assert.equal((await page.locator(".stage").screenshot()).toString("base64"), whole);
  await page.close();
});

test("play replays the growth to its end and stops there", async () => {
  const page = await open(browser, bears.page);
  await page.click("#play");
  assert.equal(await page.textContent("#play"), "Pause");
  await page.waitForFunction(() => document.getElementById("play").textContent === "Play", null, { timeout: 60000 });
  assert.equal(await page.inputValue("#wave"), await page.getAttribute("#wave", "max"));
  await page.close();
});

test("keys: search finds a face, n flies to a change, Escape lets go, space plays", async () => {
  const page = await open(browser, bears.page);
  const [source, target] = bears.match.regions[0].faces[5];
  await page.keyboard.press("/");
  await page.keyboard.type(`f${source}`);
  await page.keyboard.press("Enter");
  assert.ok((await said(page)).startsWith(`f${source} of the source lies on f${target} of the target`));
  await page.keyboard.press("Escape");
  await page.keyboard.press("n");
  assert.match(await said(page), /^only in source: 151 faces around f\d+ have no partner$/);
  assert.equal(await page.locator("[data-change='0'][aria-current]").count(), 1);
  await page.keyboard.press("p");
  assert.match(await said(page), /^only in target: 21 faces around/);
  await page.keyboard.press("[");
  assert.equal(await page.inputValue("#wave"), String(Number(await page.getAttribute("#wave", "max")) - 1));
  // From the first wave, so that it is still playing when it is looked at.
  await page.locator("#wave").fill("0");
  await page.locator("#wave").blur();
  await page.keyboard.press(" ");
  assert.equal(await page.textContent("#play"), "Pause");
  await page.close();
});

test("a search that finds nothing says why", async () => {
  const page = await open(browser, bears.page);
  await page.fill("#search", "v999999");
  await page.keyboard.press("Enter");
  assert.equal(await said(page), "There is no vertex 999999; the last is 2945");
  const [source, target] = bears.match.vertices[7];
  await page.fill("#search", `v${source}`);
  await page.keyboard.press("Enter");
  assert.equal(await said(page), `v${source} of the source lies on v${target} of the target`);
  await page.close();
});

test("a click pins a face and its partner, a second one lets go", async () => {
  const page = await open(browser, bears.page);
  const box = await page.locator("#view-source").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.click(x, y);
  assert.equal(await page.locator(".pins li").count(), 1);
  assert.equal(await page.textContent(".pins li span"), await said(page));
  await page.mouse.click(x, y);
  assert.equal(await page.locator(".pins li").count(), 0);
  await page.close();
});

test("cameras are linked until they are not", async () => {
  const page = await open(browser, bears.page);
  const looks = () =>
    page.evaluate(() => ["source", "target"].map((side) => window.quadmatch.picture.cameras.lookOf(side).offset.toArray().map((part) => part.toFixed(4)).join()));
  const drag = async () => {
    const box = await page.locator("#view-source").boundingBox();
    await page.mouse.move(box.x + 100, box.y + 300);
    await page.mouse.down();
    await page.mouse.move(box.x + 180, box.y + 330, { steps: 3 });
    await page.mouse.up();
  };
  const [home] = await looks();
  await drag();
  const [turned, follower] = await looks();
  assert.notEqual(turned, home);
  assert.equal(follower, turned);
  await page.focus("#view-target");
  await page.keyboard.press("ArrowLeft");
  const [third, fourth] = await looks();
  assert.notEqual(third, turned);
  assert.equal(third, fourth);
  await page.uncheck("#link");
  await drag();
  const [alone, left] = await looks();
  assert.notEqual(alone, left);
  assert.equal(left, fourth);
  await page.keyboard.press("0");
  assert.deepEqual(await looks(), [home, home]);
  await page.close();
});

test("every layer and every way of colouring draws without an error, and changes the picture", async () => {
  const page = await open(browser, bears.page);
  const seen = new Set();
  const look = async () => {
    await drawn(page);
    seen.add((await page.locator(".stage").screenshot()).toString("base64"));
  };
  for (const mode of ["match", "regions", "field", "waves", "confidence"]) {
    await page.selectOption("#mode", mode);
    await look();
  }
  for (const layer of ["skeleton", "extraordinary", "anchors"]) {
    await page.check(`#layer-${layer}`);
    await look();
  }
  await page.uncheck("#layer-wireframe");
  await look();
  assert.equal(seen.size, 9);
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("ambiguous parts are hatched, and only with their box checked", async () => {
  const cubes = join(folder, "cubes.obj");
  const quad = (x) => `v ${x} 0 0\nv ${x + 1} 0 0\nv ${x + 1} 1 0\nv ${x} 1 0\n`;
  writeFileSync(cubes, `${quad(0)}${quad(2)}f 1 2 3 4\nf 5 6 7 8\n`);
  const { page: path, match } = report(cubes, cubes, "--no-positions");
  assert.ok(match.regions.every((region) => region.ambiguous));
  const page = await open(browser, path);
  await drawn(page);
  const hatched = (await page.locator(".stage").screenshot()).toString("base64");
  assert.match(await page.textContent(".legend"), /ambiguous/);
  await page.uncheck("#layer-ambiguous");
  await drawn(page);
  assert.notEqual((await page.locator(".stage").screenshot()).toString("base64"), hatched);
  await page.close();
});

test("names that contain markup are shown as text", async () => {
  const name = "<img src=x onerror=window.broken=1>";
  const group = "</script><script>window.broken=2</script><!--";
  const path = join(folder, `${name}.obj`);
  writeFileSync(path, `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng ${group}\nusemtl ${name}\nf 1 2 3 4\n`);
  const { page: made } = report(path, path);
  const page = await open(browser, made);
  await page.fill("#search", "f0");
  await page.keyboard.press("Enter");
  const text = await said(page);
  assert.ok(text.includes(`group ${group}`) && text.includes(`material ${name}`), text);
  assert.equal(await page.title(), `${name}.obj and ${name}.obj`);
  assert.ok((await page.textContent("#view-source .name")).includes(name));
  assert.equal(await page.evaluate(() => window.broken), undefined);
  assert.equal(await page.locator("img").count(), 0);
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("without WebGL the figures and the lists are still there", async () => {
  const page = await open(browser, bears.page, { script: () => (HTMLCanvasElement.prototype.getContext = () => null) });
  assert.match(await page.textContent("[role=alert]"), /no WebGL/);
  assert.match(await page.textContent(".figures"), /2,944 faces/);
  await page.click("[data-change='1']");
  assert.match(await said(page), /^only in source/);
  await page.locator("#wave").fill("3");
  assert.match(await page.textContent("#wave-text"), /^wave 4 of/);
  await page.close();
});

test("on a phone the views stand one above the other, and nothing is wider than the screen", async () => {
  const page = await open(browser, bears.page, { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  const [source, target] = [await page.locator("#view-source").boundingBox(), await page.locator("#view-target").boundingBox()];
  assert.ok(target.y >= source.y + source.height);
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 360);
  await page.touchscreen.tap(source.x + source.width / 2, source.y + source.height / 2);
  assert.equal(await page.locator(".pins li").count(), 1);
  await page.close();
});

test("dark and light follow the system until the reader chooses", async () => {
  const page = await open(browser, bears.page, { colorScheme: "dark" });
  await drawn(page);
  const box = await page.locator("#view-source").boundingBox();
  const corner = async () => {
    await drawn(page);
    const [colour] = await pixels(browser, page, [[Math.round(box.x + 20), Math.round(box.y + box.height - 20)]]);
    return colour[0];
  };
  assert.ok((await corner()) < 80);
  await page.click("#theme");
  assert.ok((await corner()) > 200);
  await page.close();
});

test("everything one can operate has a name for those who do not see it", async () => {
  const page = await open(browser, bears.page);
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, input, select, [tabindex]")]
      .filter((one) => !one.getAttribute("aria-label") && !one.textContent.trim() && !(one.labels && one.labels.length > 0))
      .map((one) => one.outerHTML),
  );
  assert.deepEqual(nameless, []);
  await page.close();
});

const PAIRS = join(ROOT, "../shared/meshes/pairs");
test("every pair of real models opens without an error", { skip: !existsSync(PAIRS) && "the real models are not here" }, async () => {
  for (const name of readdirSync(PAIRS).sort()) {
    const files = readdirSync(join(PAIRS, name)).filter((file) => file.endsWith(".obj")).sort();
    const { page: path, match } = report(...files.slice(0, 2).map((file) => join(PAIRS, name, file)));
    const page = await open(browser, path);
    await page.waitForFunction(() => performance.getEntriesByName("first-frame").length > 0);
    assert.deepEqual(page.troubles, [], name);
    assert.equal(await page.locator("[data-region]").count(), Math.min(200, match.regions.length), name);
    const all = match.regions.reduce((sum, region) => sum + region.faces.length, 0);
    assert.match(await page.textContent("#wave-text"), new RegExp(`: ${all.toLocaleString("en")} faces matched$`), name);
    await page.close();
  }
});
