// SPDX-License-Identifier: MIT
// Opens a rendered page in Chromium and tries every control. Arguments: playwright-core's folder, axe's script, Chromium, the rendered folder
// of a bundle with all chapters, that of a large bundle, and that of one with many methods. Prints one line per check that fails; exit 1 where any does.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [, , library, axe, executablePath, folder, large, real] = process.argv;
const { chromium } = createRequire(`${library}/package.json`)("playwright-core");
const failures = [];
const trouble = [];
let checks = 0;

function check(holds, what) {
  checks += 1;
  if (!holds) failures.push(what);
}

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });

async function open(path, options = {}, hash = "") {
  const context = await browser.newContext({ viewport: { width: 1400, height: 900 }, ...options });
  await context.addInitScript(() => Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => { window.copied = text; } } }));
  const page = await context.newPage();
  page.setDefaultTimeout(40000);
  page.on("console", (message) => trouble.push(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => trouble.push(`error: ${error.message}`));
  page.on("request", (request) => { if (!request.url().startsWith(`file://${path}`)) trouble.push(`request: ${request.url()}`); });
  await page.goto(`file://${path}${hash}`);
  return page;
}

// Brings a table near, until it has its controls. The page's policy forbids what waitForFunction does.
async function near(page, id) {
  const tools = () => page.evaluate((one) => {
    const table = document.getElementById(one);
    table.scrollIntoView({ behavior: "instant", block: "start" });
    return table.closest(".scroll").previousElementSibling?.className === "tools";
  }, id);
  for (let tries = 0; tries < 200 && !await tools(); tries += 1) await page.waitForTimeout(50);
  return page.locator(`.scroll:has([id="${id}"])`).locator("xpath=preceding-sibling::*[1]");
}

async function tables(page) {
  const id = await page.$eval('table[data-rows="methods"][data-units]', (table) => table.id);
  const table = page.locator(`[id="${id}"]`);
  const tools = await near(page, id);
  const column = () => table.evaluate((one) => [...one.tBodies].filter((body) => !body.hidden).map((body) => Number(body.querySelector("td").dataset.v)));
  const before = await column();
  const button = table.locator("thead th button").nth(2);
  await button.click();
  const ascending = await column();
  check(ascending.every((value, at) => !at || !(value < ascending[at - 1])), `${id}: ascending is ${ascending}`);
  check(await table.locator("thead th[aria-sort=ascending]").count() === 1, "aria-sort is not set");
  await button.press("Enter");
  check((await column()).every((value, at, all) => !at || !(value > all[at - 1])), "descending is not");
  check((await page.evaluate(() => location.hash)).includes("sort."), "the address does not know the order");
  await button.press("Enter");
  check(String(await column()) === String(before), "the third press does not bring the order back");
  const held = await table.locator("td[data-v]").evaluateAll((all) => all.map((one) => one.dataset.v));
  for (const name of ["CSV", "Markdown", "LaTeX"]) {
    await tools.getByRole("button", { name }).click();
    const copied = await page.evaluate(() => window.copied);
    check(copied.includes({ CSV: ",", Markdown: "| --- |", LaTeX: "\\begin{tabular}" }[name]), `${name}: ${copied.slice(0, 60)}`);
    check(name !== "CSV" || held.every((value) => copied.includes(value)), `${id}: not all of ${held} are copied`);
  }
  const cell = table.locator("td[data-coordinate]").first();
  const [first, other] = [await cell.textContent(), await cell.getAttribute("data-coordinate")];
  await page.getByLabel("errors in").selectOption("coordinate");
  check(await cell.textContent() === other && first !== other, `in coordinate units it is ${await cell.textContent()}, not ${other}`);
  check((await table.locator("caption").textContent()).includes("in coordinate units"), "the caption does not name the unit");
  await page.getByLabel("errors in").selectOption("u");
  check(await cell.textContent() === first, "the first unit does not come back");
}

const known = new Set("de_casteljau horner_bernstein direct volk_schumaker wozny_chudy compensated_de_casteljau correctly_rounded".split(" "));
const visible = (page) => page.$$eval('table[data-rows="methods"] tbody', (all) => all.filter((body) => !body.hidden).map((body) => body.dataset.key));

async function filters(page) {
  const all = await visible(page);
  await page.locator("#view input").fill("casteljau");
  await page.waitForTimeout(400);
  const some = await visible(page);
  check(some.length > 0 && some.length < all.length && some.every((key) => key.includes("casteljau")), `the filter leaves ${[...new Set(some)]}`);
  check((await page.evaluate(() => location.hash)).includes("method=casteljau"), "the address does not know the filter");
  await page.locator("#view input").fill("");
  const family = page.getByLabel("family");
  await family.selectOption({ index: 1 });
  await page.waitForTimeout(400);
  check((await visible(page)).length < all.length, "a family leaves everything");
  await family.selectOption("");
  await page.waitForTimeout(400);
  check((await visible(page)).length === all.length, "not everything comes back");
  await page.locator("#view input").fill("zzz");
  await page.waitForTimeout(400);
  check((await visible(page)).length === 0 && (await page.locator("#view .fault").textContent()).includes("No method"), "a filter without a match is not said");
  const drawn = await page.$$eval("main figure", (all) => all.flatMap((figure) => [...figure.querySelectorAll('svg [id*="-s"]')]
    .filter((one) => /-s\d+-\d+$/.test(one.id) && getComputedStyle(one).visibility !== "hidden").map(() => figure.id)));
  const free = await page.evaluate(() => Object.entries(JSON.parse(document.getElementById("page-data").textContent).figures)
    .filter(([, series]) => series.some((one) => !one.methods.length)).map(([id]) => id));
  check(drawn.every((id) => free.includes(id)), `a filter without a match leaves lines in ${[...new Set(drawn)].filter((id) => !free.includes(id))}`);
  await page.locator("#view input").fill("");
  await page.waitForTimeout(400);
}

async function answer(page) {
  const rows = () => page.$$eval("#answer-table tbody", (all) => all.map((body) => [body.dataset.key, ...[...body.querySelectorAll("td")].map((cell) => Number(cell.dataset.v ?? cell.textContent))]));
  const caption = () => page.locator("#answer-table caption").textContent();
  const degree = page.locator("#picker").getByLabel("degree");
  const options = await degree.locator("option").allTextContents();
  check(options.length > 1, "there is one degree only");
  for (const option of options) {
    await degree.selectOption(option);
    check((await caption()).includes(`degree ${option},`), `the caption is ${await caption()}`);
    const times = (await rows()).map((row) => [row[3] <= 5 * Number(option) ? 0 : 1, row[1]]);
    check(times.length > 0 && times.every(([group, time], at) => !at || group > times[at - 1][0] || (group === times[at - 1][0] && time >= times[at - 1][1])),
      `degree ${option}: [bound is not small, time] are ${JSON.stringify(times)}`);
  }
  const small = 5 * Number(options.at(-1));
  const worth = (await rows()).filter((row) => row[3] <= small);
  const all = await page.locator("#answer-sentence").textContent();
  const named = worth.map((row) => row[0]).filter((method) => all.includes(`${method} (`));
  check(named.length > 0 && all.includes(`at most ${small} u p~, fastest first: ${worth[0][0]} (`), `of those with a small proved bound, ${named}, the sentence has ${all}`);
  const errors = (await rows()).map((row) => row[2]).sort((a, b) => a - b);
  const middle = errors[Math.floor(errors.length / 2) - 1];
  const tolerance = page.locator("#picker").getByLabel("tolerance");
  await tolerance.fill(String(middle)); // the answer follows what is typed
  const right = (await rows()).map((row) => row[2]);
  check(right.length === errors.filter((error) => error <= middle).length, `${right.length} methods keep ${middle}`);
  check((await page.locator("#answer-sentence").textContent()).startsWith("Fastest within"), await page.locator("#answer-sentence").textContent());
  check(await page.locator("#answer-figure svg g.missed").count() > 0, "the figure shows no method that misses the tolerance");
  const unit = page.locator("#picker label", { hasText: /^in u p~/ }).locator("select");
  await unit.selectOption("coordinate");
  await tolerance.fill("1");
  const said = await page.locator("#answer-sentence").textContent();
  check(said.includes("coordinate units") && !said.includes("u p~"), `in coordinate units the sentence has two: ${said}`);
  await unit.selectOption("u");
  await tolerance.fill("1e-30");
  check((await page.locator("#answer-sentence").textContent()).startsWith("No method"), "a tolerance that none keeps has an answer");
  for (const [typed, why] of [["abc", "is not a number"], ["-1", "is negative"], ["1,5", "write 1.5"], ["1e999", "above the largest"]]) {
    await tolerance.fill(typed);
    const fault = await page.locator("#fault").textContent();
    check(fault.includes(typed) && fault.includes(why), `of ${typed} it says: ${fault}`);
    check(await tolerance.getAttribute("aria-invalid") === "true", `${typed} is not marked as wrong`);
    check((await rows()).length === errors.length, `with ${typed} there are ${(await rows()).length} methods`);
  }
  await tolerance.fill("");
  check(await page.locator("#fault").textContent() === "" && await tolerance.getAttribute("aria-invalid") === "false", "a fault stays when its cause is gone");
}

// The figure of all degrees shows what the answer has: nothing where no method keeps the tolerance, all where there is none.
async function narrowed(path) {
  for (const [tolerance, wanted] of [["", "all"], ["abc", "all"], ["1e999", "all"], ["1e-30", "none"]]) {
    const page = await open(path, {}, `#?tolerance=${tolerance}`);
    const marks = await page.$$eval('#time-against-error > svg [id*="-s"]', (all) => all.map((one) => [getComputedStyle(one).visibility, one.classList.contains("dim")].join()));
    const seen = marks.filter((one) => one === "visible,false").length;
    check(marks.length > 0 && seen === (wanted === "all" ? marks.length : 0), `with the tolerance "${tolerance}" the figure shows ${seen} of ${marks.length} marks`);
    await page.context().close();
  }
}

// Each entry of the contents leads to its heading, also where what lies between has not been laid out yet.
async function contents(path, options) {
  const page = await open(path, options);
  const links = await page.$$eval("nav li a", (all) => all.map((one) => one.getAttribute("href").slice(1)));
  check(links.length > 10, `only ${links.length} entries in the contents`);
  for (const id of links) {
    await page.evaluate(() => scrollTo({ top: 0, behavior: "instant" }));
    await page.$eval("nav details", (one) => { one.open = true; });
    await page.locator(`nav a[href="#${id}"]`).click();
    const place = () => page.evaluate((one) => [document.getElementById(one).getBoundingClientRect().top,
      document.documentElement.scrollHeight - innerHeight - scrollY], id);
    const there = () => top > -1 && (top < 120 || left < 2);
    let [top, left] = await place();
    for (let [tries, times] = [0, 0]; tries < 50 && times < 3; tries += 1) { // until it is there and stays
      await page.waitForTimeout(60);
      [top, left] = await place();
      times = there() ? times + 1 : 0;
    }
    check(there(), `the link to ${id} lands ${Math.round(top)} px above its heading`);
  }
  await page.context().close();
}

async function figures(page) {
  const figure = page.locator("#answer-figure");
  await figure.scrollIntoViewIfNeeded();
  const mark = figure.locator("svg g path").nth(1);
  const box = await mark.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  check((await page.locator(".tip").textContent()).includes("observed errors of at most"), "no values under the pointer");
  await figure.focus();
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Tab");
  check(await page.locator(".tip").isVisible(), "a figure that has the focus shows no values");
  await page.keyboard.press("ArrowRight");
  const one = await page.locator("#said").textContent();
  await page.keyboard.press("ArrowRight");
  check(one && one !== await page.locator("#said").textContent(), "the arrow keys do not read the points");
  const inPage = await page.$$eval("main figure", (all) => all.filter((one) => one.querySelector(".legend [data-name]")).map((one) => one.id));
  check(inPage.length > 8, `only ${inPage.length} figures have a legend`);
  for (const id of inPage) {
    const legend = page.locator(`[id="${id}"] .legend button`).first();
    const dim = () => page.locator(`[id="${id}"] .dim`).count();
    const before = await dim();
    await legend.evaluate((button) => button.click());
    check(await dim() !== before, `${id}: the legend isolates nothing`);
    await legend.evaluate((button) => button.click());
    check(await dim() === before, `${id}: the legend does not let go`);
  }
  const replay = await page.evaluate(() => Object.entries(JSON.parse(document.getElementById("page-data").textContent).figures)
    .flatMap(([id, series]) => series.flatMap((one) => one.points.filter((point) => point[3]).map((point) => [id, point[0], point[1], point[3]])))[0]);
  check(replay, "no point knows what to replay");
  if (replay) {
    const onScreen = () => page.evaluate(([id, x, y]) => {
      const matrix = document.getElementById(id).querySelector("svg").getScreenCTM();
      return [matrix.a * x + matrix.e, matrix.d * y + matrix.f];
    }, replay);
    for (let tries = 0; tries < 5; tries += 1) { // parts of the page that come near are laid out, and move the others
      await page.evaluate((y) => scrollBy({ top: y - innerHeight / 2, behavior: "instant" }), (await onScreen())[1]);
      await page.waitForTimeout(100);
    }
    const at = await onScreen();
    await page.evaluate(() => { window.copied = ""; });
    await page.mouse.click(...at);
    check(/^bezierbench replay \S+ \w+$/.test(await page.evaluate(() => window.copied)), `copied: ${await page.evaluate(() => window.copied)}`);
  }
}

// The page of a bundle with many methods: at most eight lines at first, each with values, in one colour throughout.
async function leading(path) {
  const page = await open(path);
  const series = await page.evaluate(() => JSON.parse(document.getElementById("page-data").textContent).figures);
  const colours = new Map();
  for (const [id, lines] of Object.entries(series)) {
    const methods = lines.filter((one) => one.methods.length);
    check(lines.some((one) => one.points.length), `${id}: no point has values`);
    if (id.endsWith("-all")) continue;
    check(new Set(methods.map((one) => one.colour)).size >= Math.min(8, methods.length), `${id}: two lines have one colour`);
    for (const one of methods.filter((line) => known.has(line.methods[0]))) {
      check((colours.get(one.methods[0]) ?? one.colour) === one.colour, `${one.methods[0]} has two colours, one in ${id}`);
      colours.set(one.methods[0], one.colour);
    }
  }
  const whole = Object.keys(series).filter((id) => id.endsWith("-all")).map((id) => id.slice(0, -4));
  check(whole.length > 2, `only ${whole} show some of their methods`);
  for (const id of whole) {
    const names = () => page.locator(`[id="${id}"] .legend button[data-name]`).count();
    const button = page.locator(`[id="${id}"] .legend button.all`);
    const few = await names();
    check(few <= 8 || id === "time-against-error", `${id} has ${few} lines at first`);
    await button.evaluate((one) => one.click());
    check(await names() === series[`${id}-all`].length, `${id}: all are ${series[`${id}-all`].length}, shown are ${await names()}`);
    await button.evaluate((one) => one.click());
    check(await names() === few, `${id} does not go back`);
  }
  const answer = page.locator("#answer-figure");
  check(await answer.locator(".legend button[data-name]").count() <= 8 && await answer.locator("svg .other").count() > 0, "the answer draws more than eight in colour");
  const out = await answer.locator("svg").evaluate((svg) => [...svg.querySelectorAll("g path")].filter((one) => one.getBBox().y < 0).length);
  check(out === 0, `${out} bounds lie outside the frame`);
  await page.context().close();
}

// No violation that axe knows of, in either colour scheme.
async function accessible(path) {
  for (const colorScheme of ["light", "dark"]) {
    const page = await open(path, { colorScheme });
    await page.evaluate(() => document.querySelectorAll("section").forEach((section) => { section.style.contentVisibility = "visible"; }));
    await page.evaluate(readFileSync(axe, "utf8"));
    const { violations } = await page.evaluate(() => window.axe.run({ resultTypes: ["violations"] }));
    for (const one of violations) check(false, `${colorScheme}: ${one.id}, ${one.help}: ${one.nodes.slice(0, 3).map((node) => node.html.slice(0, 160)).join(" | ")} (${one.nodes.length})`);
    check(violations.length === 0, `${colorScheme}: ${violations.length} violations`);
    await page.context().close();
  }
}

async function permalinks(path, page) {
  await page.locator("#view input").fill("direct");
  await page.locator("#picker").getByLabel("degree").selectOption({ index: 0 });
  await page.waitForTimeout(400);
  const [hash, left, caption] = [await page.evaluate(() => location.hash), await visible(page), await page.locator("#answer-table caption").textContent()];
  const again = await open(path, {}, hash);
  check(String(await visible(again)) === String(left), "a link does not bring the filter back");
  check(await again.locator("#answer-table caption").textContent() === caption, "a link does not bring the answer back");
  await again.context().close();
}

async function looks(path) {
  const desk = await open(path);
  const clipped = await desk.$$eval("main .scroll", (all) => all.filter((one) => {
    one.scrollIntoView({ behavior: "instant" });
    return one.querySelector("caption").getBoundingClientRect().right > one.getBoundingClientRect().right + 1;
  }).map((one) => one.querySelector("table").id));
  check(clipped.length === 0, `the caption is cut of ${clipped}`);
  await desk.context().close();
  const phone = await open(path, { viewport: { width: 390, height: 844 } });
  await phone.evaluate(() => document.querySelectorAll("section").forEach((section) => { section.style.contentVisibility = "visible"; }));
  const broken = await phone.$$eval("main :is(th, td.words, td.verbal, caption, p, li)", (all) => all.flatMap((element) => {
    const found = [];
    const texts = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      for (const word of node.data.matchAll(/[A-Za-z]{2,}/g)) {
        const range = document.createRange();
        range.setStart(node, word.index);
        range.setEnd(node, word.index + word[0].length);
        if ([...range.getClientRects()].filter((one) => one.width > 0.5).length > 1) found.push(word[0]);
      }
    }
    return found;
  }));
  check(broken.length === 0, `at 390 px these words are broken: ${[...new Set(broken)]}`);
  const width = await phone.evaluate(() => { // ids and cells of any length
    document.querySelector("#picker option").textContent += ", and what else tells this cell from the others of this bundle";
    document.querySelectorAll("main p code").forEach((code) => { code.textContent = "forward_substitution:compensated_volk_schumaker"; });
    document.querySelectorAll("section").forEach((section) => { section.style.contentVisibility = "visible"; });
    return document.documentElement.scrollWidth;
  });
  check(width <= 390, `at 390 px the page is ${width} wide`);
  const cut = await phone.$$eval("main table", (all) => all.filter((table) => {
    table.scrollIntoView({ behavior: "instant" });
    const cell = table.querySelector("tbody td");
    return cell && cell.getBoundingClientRect().right > innerWidth + (cell.className.includes("words") ? 200 : 40);
  }).map((table) => table.id));
  check(cut.length === 0, `at 390 px no number is seen of ${cut}`);
  const over = await phone.$$eval("main tbody th", (all) => all.filter((label) => label.scrollWidth > label.clientWidth + 1).map((label) => label.textContent));
  check(over.length === 0, `at 390 px these labels reach into the numbers: ${[...new Set(over)]}`);
  await phone.context().close();
  const dark = await open(path, { colorScheme: "dark" });
  const paper = () => dark.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const night = await paper();
  await dark.emulateMedia({ media: "print", colorScheme: "light" });
  check(night !== await paper(), "dark and print have one paper");
  check(!await dark.locator("#view").isVisible() && !await dark.locator(".tools").first().isVisible(), "controls are printed");
  check(await dark.locator("button.sort").first().evaluate((one) => getComputedStyle(one).display) === "contents", "heads that are repeated on paper are empty");
  const sticking = await dark.$$eval("main table *", (all) => all.filter((one) => getComputedStyle(one).position === "sticky").length);
  check(sticking === 0, `${sticking} cells stick on paper, where a head is repeated`);
  check(await dark.locator("#answer-figure .legend").isVisible(), "the figure of the answer is printed without its legend");
  await dark.context().close();
}

// A hundred thousand rows: what a reader does takes no longer than a breath, on a busy machine too.
async function many(path) {
  const page = await open(path);
  const rows = await page.$$eval("main tbody tr", (all) => all.length);
  check(rows >= 100000, `the large page has ${rows} rows`);
  const took = await page.evaluate(async () => {
    const from = performance.now();
    const input = document.querySelector("#view input");
    input.value = "casteljau";
    input.dispatchEvent(new Event("input"));
    await new Promise((done) => setTimeout(() => requestAnimationFrame(done), 200));
    return performance.now() - from;
  });
  check((await visible(page)).every((key) => key.includes("casteljau")), "the large page is not filtered");
  check(took < 5000, `filtering took ${Math.round(took)} ms`);
  const table = page.locator("main table").nth(5);
  await near(page, await table.getAttribute("id"));
  await table.locator("thead th button").nth(1).click();
  check(await table.locator("tbody:not([hidden]) td").first().textContent() === "0", "the large page is not sorted");
  await page.context().close();
}

const path = `${folder}/report.html`;
const page = await open(path);
for (const [name, part] of Object.entries({ tables, filters, answer, figures })) {
  try {
    await part(page);
  } catch (error) {
    failures.push(`${name}: ${error.message.split("\n")[0]}`);
  }
}
for (const [name, part] of Object.entries({ permalinks: () => permalinks(path, page), narrowed: () => narrowed(path), contents: () => contents(path), small: () => contents(path, { viewport: { width: 390, height: 844 } }), looks: () => looks(path), many: () => many(`${large}/report.html`), leading: () => leading(`${real}/report.html`), accessible: () => accessible(path), real: () => accessible(`${real}/report.html`) })) {
  try {
    await part();
  } catch (error) {
    failures.push(`${name}: ${error.message.split("\n")[0]}`);
  }
}
await browser.close();
failures.push(...new Set(trouble));
console.log(failures.length ? failures.join("\n") : `${checks} checks`);
process.exit(failures.length ? 1 : 0);
