// Reports of merge and symmetry, seen by a browser and held against what the verbs say of themselves.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { checkRed, drawn, EXAMPLES, folder, launch, open, partners, places, run, said } from "./support.mjs";

const SIDES = ["source", "target"];
let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

test("a merge is shown as the base beside the result: red what a side added, listed by side, and conflicts first", async () => {
  const base = join(EXAMPLES, "bear.obj");
  const [ours, theirs] = [join(folder, "mine.obj"), join(folder, "yours.obj")];
  run("edit_mesh", base, ours, "extrude:24", "--seed", "24");
  run("edit_mesh", base, theirs, "loop:1", "renumber", "--seed", "4");
  const path = join(folder, "merge.html");
  const { origins, merged } = JSON.parse(
    run("quadmatch", "merge", base, ours, theirs, "-o", join(folder, "merged.obj"), "--report", path, "--json", "--origins"),
  );
  const page = await open(browser, path);
  await page.uncheck("#layer-wireframe");
  await page.uncheck("#layer-ambiguous");
  await drawn(page);
  assert.equal(await page.title(), "bear.obj and merged.obj");
  assert.deepEqual(await page.locator("[data-change]").allTextContents().then((texts) => texts.map((text) => /by (OURS|THEIRS)/.exec(text)[1])), ["OURS", "THEIRS"]);
  const { red, other } = await checkRed(browser, page, "target", (face) => origins[face][0] !== null, 60);
  assert.ok(red >= 8 && other > 400, `${red} red places, ${other} others`);
  assert.equal((await checkRed(browser, page, "source", () => true, 60)).red, 0);
  assert.match(await page.textContent(".figures"), new RegExp(`${merged.faces.toLocaleString("en")} faces: `));
  await page.keyboard.press("n");
  assert.match(await said(page), new RegExp(`^added by OURS: ${merged.from_ours} faces around f\\d+ of OUT$`));
  assert.deepEqual(page.troubles, []);
  await page.close();

  run("edit_mesh", base, theirs, "delete:30", "--seed", "24");
  run("quadmatch", "merge", base, ours, theirs, "-o", join(folder, "merged.obj"), "--report", path);
  const second = await open(browser, path);
  assert.match(await second.locator("[data-change='0']").textContent(), /conflict/);
  await second.click("[data-change='0']");
  assert.match(await said(second), /^conflict: .* of BASE/);
  assert.deepEqual(second.troubles, []);
  await second.close();
});

test("a mirror is shown as a mesh beside itself: pairs light up on both, the line is drawn, and red has no partner", async () => {
  const bear = join(EXAMPLES, "bear_posed.obj");
  const path = join(folder, "mirror.html");
  const figures = JSON.parse(run("quadmatch", "symmetry", bear, "-o", join(folder, "mirror.json"), "--report", path, "--json"));
  const map = JSON.parse(readFileSync(join(folder, "mirror.json"), "utf8"));
  const partner = partners(map, 0);
  const page = await open(browser, path);
  await drawn(page);
  const missing = await page.evaluate((line) => {
    const { points, layers } = window.quadmatch.picture.panes.source;
    const name = (array, at) => Array.from(array.slice(at, at + 3)).join();
    const drawn = layers.get("seams")[0].geometry.getAttribute("position").array;
    const ends = new Set();
    for (let at = 0; at < drawn.length; at += 6) ends.add(`${name(drawn, at)} ${name(drawn, at + 3)}`);
    return line.filter(([v, w]) => !ends.has(`${name(points, 3 * v)} ${name(points, 3 * w)}`) && !ends.has(`${name(points, 3 * w)} ${name(points, 3 * v)}`));
  }, map.symmetry.centre_line.edges);
  assert.ok(map.symmetry.centre_line.edges.length > 90);
  assert.deepEqual(missing, [], "edges of the line that are not drawn");
  assert.match(await page.locator("[data-change='0']").textContent(), /centre line/);
  assert.equal(await page.locator("[data-change]").count(), 1 + figures.unpaired_areas.length);

  let met = 0;
  for (const [x, y] of await places(page, "source", 8)) {
    await page.evaluate(() => (document.getElementById("said").textContent = ""));
    await page.mouse.move(x, y);
    await drawn(page);
    const text = await said(page);
    if (text === "") continue;
    const face = Number(/^f(\d+) of the source/.exec(text)[1]);
    const expected = partner.has(face) ? `lies on f${partner.get(face)} of the target` : "has no partner";
    assert.ok(text.startsWith(`f${face} of the source ${expected}`), text);
    const lit = await page.evaluate(() => ["source", "target"].map((side) => window.quadmatch.picture.panes[side].marks.pointed[0].geometry.getAttribute("position").count / 6));
    assert.deepEqual(lit, partner.has(face) ? [2, 2] : [1, 1]);
    ++met;
  }
  assert.ok(met > 8, `only ${met} faces were met`);
  await page.mouse.move(2, 2);
  await page.uncheck("#layer-wireframe");
  await page.uncheck("#layer-seams");
  await drawn(page);
  for (const side of SIDES) {
    const { red, other } = await checkRed(browser, page, side, (face) => partner.has(face), 60);
    assert.ok(red >= 3 && other > 400, `${side}: ${red} red places, ${other} others`);
  }
  assert.deepEqual(page.troubles, []);
  await page.close();
});
