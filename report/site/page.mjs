// SPDX-License-Identifier: MIT
// The site in headless Chromium: node page.mjs PLAYWRIGHT AXE CHROMIUM FOLDER. Ends with 1 and one line per fault.
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const [, , playwright, axe, executablePath, folder] = process.argv;
const { chromium } = createRequire(import.meta.url)(playwright);
const pages = ["index.html", "methods/index.html", "methods/horner_bernstein.html", "methods/quintic_isolate.html", "docs/index.html",
  "docs/introduction.html", "docs/proofs/local.html", "atlas/roots/index.html"];
const sizes = [[1400, 900, "light"], [390, 844, "dark"]];
const faults = [];
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const rules = await readFile(axe, "utf8");

async function open(name, [width, height, colorScheme]) {
  const page = await (await browser.newContext({ viewport: { width, height }, colorScheme })).newPage();
  page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || faults.push(`${name}: asks for ${request.url()}`));
  page.on("pageerror", (error) => faults.push(`${name}: ${error.message}`));
  await page.goto(`${pathToFileURL(folder)}/${name}`);
  return page;
}

for (const size of sizes) {
  for (const name of pages) {
    const page = await open(name, size);
    const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    if (wider > 0) faults.push(`${name}: ${wider} px wider than ${size[0]}`);
    await page.evaluate(rules);
    const { violations } = await page.evaluate(() => axe.run());
    for (const { id, nodes } of violations) faults.push(`${name}, ${size[2]}: ${id}: ${nodes[0].html.slice(0, 120)}`);
    await page.context().close();
  }
  const page = await open("index.html", size);
  for (const one of await page.locator(".winner, #drop").all()) {
    const box = await one.boundingBox();
    if (box.y + box.height > size[1]) faults.push(`index.html: ${await one.innerText()} is below the first screen of ${size[0]} px`);
  }
  if (await page.locator("#text").count()) {
    await page.locator("#own button").click();
    if (!(await page.locator("#said").innerText())) faults.push("index.html: is silent about an empty field");
    await page.locator("#text").fill("0,0 1,2 3,1");
    await page.locator("#own button").click();
    await page.waitForURL(/playground\/index\.html#/);
    await page.locator("#given-text").waitFor();
    await page.waitForFunction(() => document.querySelector("#given-text").value === "0,0 1,2 3,1", null, { timeout: 20000 }).catch(() =>
      faults.push("playground/index.html: does not take the curve of the start page"));
    const long = await open("index.html", size);
    await long.locator("#text").fill("ä".repeat(4e5)); // an address of 2.4 MB, which Chrome does not open
    await long.locator("#own button").click();
    const said = await long.locator("#said").innerText({ timeout: 5000 }).catch(() => "");
    if (!said.includes("1,000,000")) faults.push("index.html: does not refuse a text that is too long for an address");
    await long.context().close();
  }
  await page.context().close();
}
await browser.close();
if (faults.length) console.log(faults.join("\n"));
process.exitCode = faults.length ? 1 : 0;
