// The page that matches in the browser, served on loopback and held against the command line.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { after, before, test } from "node:test";
import { serve } from "./server.mjs";
import { BUILD, drawn, EXAMPLES, folder, launch, run, watched } from "./support.mjs";

const BEARS = [join(EXAMPLES, "bear.obj"), join(EXAMPLES, "bear_no_ears_posed.obj")];
const LONG = { timeout: 120000 };
let browser;
let server;

before(async () => {
  [browser, server] = await Promise.all([launch(), serve()]);
});
after(async () => {
  await browser?.close();
  server?.end();
});

async function openPage(options = {}, other = browser) {
  const page = await watched(other, (address) => address.startsWith(server.address), { acceptDownloads: true, ...options });
  await page.goto(server.address);
  await page.waitForSelector("#start", { state: "attached" });
  return page;
}

/** Drop files on an element, as a hand would. */
async function drop(page, paths, place = ".desk") {
  const files = paths.map((path) => ({ name: basename(path), data: readFileSync(path).toString("base64") }));
  await page.evaluate(
    async ([selector, list]) => {
      const transfer = new DataTransfer();
      for (const { name, data } of list) {
        const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
        transfer.items.add(new File([bytes], name));
      }
      document.querySelector(selector).dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
    },
    [place, files],
  );
}

const matched = (page) => page.waitForFunction(() => window.quadmatch !== undefined, null, LONG);
const sentence = (page) => page.textContent("#trouble");
const complained = (page) => page.waitForSelector("#trouble:not(:empty)", LONG);

/** What a button saves: its name, and the bytes. */
async function saved(page, id) {
  const [download] = await Promise.all([page.waitForEvent("download", LONG), page.click(id)]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** The command line in a folder of its own, where the files have bare names, as on the page. */
let folders = 0;
function beside(paths, ...words) {
  const here = join(folder, `beside-${++folders}`);
  mkdirSync(here);
  for (const path of paths) copyFileSync(path, join(here, basename(path)));
  const { status, stderr } = spawnSync(join(BUILD, "quadmatch"), words, { cwd: here, encoding: "utf8" });
  return { status, stderr, file: (name) => readFileSync(join(here, name)) };
}


test("two dropped files give the same match file as the command line, byte for byte", async () => {
  const page = await openPage();
  await drop(page, BEARS);
  await matched(page);
  await drawn(page);
  const { name, bytes } = await saved(page, "#save-match-file");
  assert.equal(name, "bear_bear_no_ears_posed.json");
  const { file } = beside(BEARS, "match", "bear.obj", "bear_no_ears_posed.obj", "-o", "m.json", "--quiet");
  assert.ok(bytes.equals(file("m.json")));
  assert.match(await page.textContent(".figures"), /2,944 faces, 89\.8 % matched, 300 unmatched in 2 areas/);
  assert.equal(await page.locator("[data-change]").count(), 4);
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("every format can be dropped, and every option says the same as on the command line", async () => {
  const page = await openPage();
  const choices = [
    ["ply", { algorithm: "lazy-greedy" }],
    ["off", { algorithm: "greedy", orientation: "preserving" }],
    ["usda", { "min-region": "500" }],
    ["obj", { positions: false, orientation: "reversing" }],
  ];
  for (const [ending, options] of choices) {
    const source = join(folder, `a.${ending}`);
    run("quadmatch", "transfer", BEARS[0], BEARS[0], "-o", source, "--quiet");
    await page.evaluate(() => document.getElementById("options").setAttribute("open", ""));
    for (const [id, value] of Object.entries({ algorithm: "regions", orientation: "auto", positions: true, "min-region": "1", ...options })) {
      if (id === "positions") await page.setChecked("#positions", value);
      else if (id === "min-region") await page.fill("#min-region", value);
      else await page.selectOption(`#${id}`, value);
    }
    await drop(page, [source, BEARS[1]]);
    await page.waitForFunction((name) => window.quadmatch?.report.header.source.path === name, `a.${ending}`, LONG);
    const words = Object.entries(options).flatMap(([id, value]) => (id === "positions" ? ["--no-positions"] : [`--${id}`, value]));
    const { bytes } = await saved(page, "#save-match-file");
    const { file } = beside([source, BEARS[1]], "match", `a.${ending}`, "bear_no_ears_posed.obj", "-o", "m.json", "--quiet", ...words);
    assert.ok(bytes.equals(file("m.json")), ending);
  }
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("an example opens and is drawn, and pointing works under the page's policy", async () => {
  const page = await openPage();
  await page.click("#open-example");
  await matched(page);
  await drawn(page);
  const box = await page.locator("#view-source").boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  assert.equal(await page.locator(".pins li").count(), 1);
  const swatch = await page.evaluate(() => getComputedStyle(document.querySelector(".legend .swatch")).backgroundColor);
  assert.notEqual(swatch, "rgba(0, 0, 0, 0)");
  assert.equal(await page.textContent("#file-target"), "bear_no_ears_posed.obj");
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("the target takes the source's data, and two edits are merged, as by the command line", async () => {
  const edits = [
    [["extrude:24"], 24, "mine.obj"],
    [["loop:1", "renumber"], 4, "yours.obj"],
  ].map(([words, seed, name]) => {
    run("edit_mesh", BEARS[0], join(folder, name), ...words, "--seed", String(seed));
    return join(folder, name);
  });
  const page = await openPage();
  await drop(page, [BEARS[0], ...edits]);
  await matched(page);
  const all = [BEARS[0], ...edits];
  const transferred = await saved(page, "#save-transfer");
  assert.equal(transferred.name, "mine_with_bear.obj");
  const transfer = beside(all, "transfer", "bear.obj", "mine.obj", "-o", "t.obj", "--quiet");
  assert.ok(transferred.bytes.equals(transfer.file("t.obj")));
  assert.match(await page.textContent("#summary"), /^source +bear\.obj/);
  for (const [ending, prefer] of [["obj", "ours"], ["ply", "theirs"]]) {
    await page.selectOption("#merge-format", ending);
    await page.selectOption("#prefer", prefer);
    const merged = await saved(page, "#save-merge");
    assert.equal(merged.name, `mine_yours.${ending}`);
    const merge = beside(all, "merge", "bear.obj", "mine.obj", "yours.obj", "-o", `m.${ending}`, "--prefer", prefer, "--quiet");
    assert.ok(merged.bytes.equals(merge.file(`m.${ending}`)), ending);
  }
  assert.match(await page.textContent("#summary"), /^base +bear\.obj/);
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("a broken file is refused with the sentence of the command line, and what it is warned of is told", async () => {
  const quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const broken = {
    "index.obj": `${quad}f 1 2 3 9\n`,
    "number.obj": "v 0 zero 0\n",
    "empty.obj": "",
    "faceless.off": "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n",
    "cut.ply": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n",
    "binary.usdc": "PXR-USDC",
    "what.xyz": "hello\n",
  };
  const page = await openPage();
  for (const [name, text] of Object.entries(broken)) {
    const path = join(folder, name);
    writeFileSync(path, text);
    const { status, stderr } = beside([path, BEARS[0]], "match", name, "bear.obj", "-o", "m.json", "--quiet");
    assert.equal(status, 2);
    await drop(page, [path, BEARS[0]]);
    await complained(page);
    assert.equal(`quadmatch: ${await sentence(page)}\n`, stderr);
    assert.equal(await page.isHidden("#results"), true);
  }
  const dirty = join(folder, "dirty.obj");
  writeFileSync(dirty, `${quad}v 5 5 5\nf 1 2 3 4\n`);
  await drop(page, [dirty, dirty]);
  await matched(page);
  const { stderr } = beside([dirty], "match", "dirty.obj", "dirty.obj", "-o", "m.json");
  const warnings = (await page.locator("#warnings li").allTextContents()).map((text) => `quadmatch: warning: ${text}\n`);
  assert.equal(warnings.join(""), stderr);
  assert.equal(await sentence(page), "");
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("a second drop while working cancels the first, and Cancel ends it at once", async () => {
  run("make_shape", "sphere:120", join(folder, "big.obj"));
  run("edit_mesh", join(folder, "big.obj"), join(folder, "big_other.obj"), "renumber", "--seed", "3");
  const big = [join(folder, "big.obj"), join(folder, "big_other.obj")];
  const page = await openPage();
  await drop(page, big);
  await page.waitForFunction(() => /^(reading|matching)/.test(document.getElementById("status").textContent), null, LONG);
  await drop(page, BEARS);
  await matched(page);
  assert.equal(await page.title(), "bear.obj and bear_no_ears_posed.obj");
  const { bytes } = await saved(page, "#save-match-file");
  assert.equal(JSON.parse(bytes).source.path, "bear.obj");
  await drop(page, big);
  await page.waitForFunction(() => document.getElementById("status").textContent === "matching", null, LONG);
  await page.click("#cancel");
  assert.equal(await page.textContent("#status"), "Cancelled");
  assert.equal(await page.isHidden("#cancel"), true);
  assert.equal(await page.evaluate(() => window.quadmatch), undefined);
  await page.click("#start");
  await matched(page);
  assert.equal(await page.title(), "big.obj and big_other.obj");
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("without WebGL the figures, the lists and the files are still there", async () => {
  const without = await launch("--disable-3d-apis");
  const page = await openPage({}, without);
  await drop(page, BEARS);
  await matched(page);
  assert.match(await page.textContent(".excuse"), /no WebGL/);
  assert.match(await page.textContent(".figures"), /2,944 faces/);
  await page.click("[data-change='1']");
  assert.match(await page.textContent("#said"), /^only in source/);
  const { bytes } = await saved(page, "#save-match-file");
  assert.equal(JSON.parse(bytes).format, "quadmatch.match/1");
  await without.close();
});

test("names that contain markup are shown as text, everywhere", async () => {
  const name = "<img src=x onerror=window.broken=1>";
  const group = "</script><script>window.broken=2</script><!--";
  const path = join(folder, `${name}.obj`);
  writeFileSync(path, `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 5 5\ng ${group}\nusemtl ${name}\nf 1 2 3 4\n`);
  const page = await openPage();
  await drop(page, [path, path]);
  await matched(page);
  await page.fill("#search", "f0");
  await page.keyboard.press("Enter");
  const text = await page.textContent("#said");
  assert.ok(text.includes(`group ${group}`) && text.includes(`material ${name}`), text);
  for (const place of ["#file-source", "#view-target .name", "#warnings", "h1 >> nth=1"]) {
    assert.ok((await page.textContent(place)).includes(name), place);
  }
  writeFileSync(path, "f 1 2 3\n");
  await drop(page, [path, path]);
  await complained(page);
  assert.ok((await sentence(page)).startsWith(`${name}.obj`));
  assert.equal(await page.evaluate(() => window.broken), undefined);
  assert.equal(await page.locator("img").count(), 0);
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("the policy lets neither the page nor its worker ask anything of a network", async () => {
  const page = await openPage();
  const asked = await page.evaluate(async () => {
    const tryIt = (what) => what().then(() => "went through", () => "was refused");
    const inWorker = new Worker(URL.createObjectURL(new Blob(["fetch(location.origin).then(() => postMessage('went through'), () => postMessage('was refused'))"])));
    return [
      await tryIt(() => fetch(location.href)),
      await tryIt(() => import("data:text/javascript,1")),
      await new Promise((done) => (inWorker.onmessage = ({ data }) => done(data))),
    ];
  });
  assert.deepEqual(asked, ["was refused", "was refused", "was refused"]);
  await page.close();
});

test("a large pair is matched in full and drawn reduced, with all that has no partner in the picture", async () => {
  run("make_shape", "sphere:224", join(folder, "large.obj"));
  run("edit_mesh", join(folder, "large.obj"), join(folder, "large_edited.obj"), "delete:20", "renumber", "--seed", "2");
  const large = [join(folder, "large.obj"), join(folder, "large_edited.obj")];
  const page = await openPage();
  await drop(page, large);
  await matched(page);
  await drawn(page);
  const { match, shown, faces } = await page.evaluate(() => {
    const { report } = window.quadmatch;
    const faces = report.meshes.source.faceCount;
    const unmatched = [...report.match.source.partner.keys()].filter((f) => report.match.source.partner[f] < 0);
    const drawnFaces = new Set(report.shown.source.faces);
    return { match: unmatched.every((f) => drawnFaces.has(f)) && unmatched.length, shown: drawnFaces.size, faces };
  });
  assert.equal(faces, 6 * 224 * 224);
  assert.ok(match > 0 && shown > 30000 && shown <= 100000, `${match} unmatched, ${shown} shown`);
  assert.match(await page.textContent(".reduction"), /^Drawn are [\d,]+ of the source's 301,056 faces and /);
  const { bytes } = await saved(page, "#save-match-file");
  const { file } = beside(large, "match", "large.obj", "large_edited.obj", "-o", "m.json", "--quiet");
  assert.ok(bytes.equals(file("m.json")));
  const box = await page.locator("#view-source").boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await page.waitForSelector(".pins li", LONG);
  assert.deepEqual(page.troubles, []);
  await page.close();
});

test("files that make no pair are told what they could be", async () => {
  const page = await openPage();
  await drop(page, []);
  assert.match(await sentence(page), /two meshes to match/);
  await drop(page, [...BEARS, ...BEARS]);
  assert.match(await sentence(page), /^4 files are too many/);
  await drop(page, [BEARS[0]]);
  assert.equal(await page.textContent("#file-source"), "bear.obj");
  assert.equal(await page.isDisabled("#start"), true);
  await page.setInputFiles("#input-target", BEARS[1]);
  await matched(page);
  await page.click("#swap");
  await page.waitForFunction(() => window.quadmatch?.report.header.target.path === "bear.obj", null, LONG);
  await page.close();
});

test("the page is no wider than a phone, and all one can operate has a name", async () => {
  const page = await openPage({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  await drop(page, BEARS);
  await matched(page);
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 360);
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, input, select, [tabindex]")]
      .filter((one) => !one.getAttribute("aria-label") && !one.textContent.trim() && !(one.labels && one.labels.length > 0))
      .map((one) => one.outerHTML),
  );
  assert.deepEqual(nameless, []);
  await page.close();
});
