// SPDX-License-Identifier: MIT
// What somebody gives: an example, text, a file, one of its curves. `load(curve, more)` shows it; faults stand below the field.

import { degreeOf, sameCurve } from "./curve.mjs";
import { byId, late, make, say } from "./dom.mjs";
import { examples } from "./examples.mjs";
import { overview } from "./picture.mjs";
import { read } from "./read.mjs";

const largestFile = 16e6;
const mostShown = 20000; // characters of a file in the field
const mostPictured = 3000; // curves of a file in the picture of all

let load;
let file = null; // { curves, chosen, down, number } of what was read, where that is several curves
let newest = null; // the file that was read last, which going back may leave and going forward may find again

const fault = (sentence = "") => { byId("given-fault").textContent = sentence; };

function setFile(next) {
  file = next;
  newest = file ?? newest;
  byId("others").hidden = !file;
}

function mark(chosen) {
  const { curves, down } = file;
  file.chosen = chosen;
  byId("others-list").value = String(chosen);
  byId("others-count").textContent = `curve ${chosen + 1} of ${curves.length}${curves.length > mostPictured ? `; the picture has the first ${mostPictured}` : ""}`;
  overview(byId("overview"), curves.slice(0, mostPictured), chosen, down, pick);
}

function pick(wanted) {
  const { curves, down } = file;
  mark((wanted + curves.length) % curves.length);
  load(curves[file.chosen].curve, { down });
}

// Which file and curve of it the page shows, and the way back there.
export const placeInFile = () => file && { number: file.number, chosen: file.chosen };
export function showPlace(place) {
  setFile(newest && place?.number === newest.number ? newest : null);
  if (file) mark(place.chosen);
}

// Shows the curves of a text; one that breaks a rule leaves all as it is.
export function take(source) {
  try {
    const { curves, down } = read(source);
    fault();
    byId("given-text").removeAttribute("aria-invalid");
    setFile(curves.length > 1 ? { curves, down, chosen: 0, number: Date.now() } : null);
    if (!file) { load(curves[0].curve, { down }); return; }
    const words = ({ id, curve }) => `${id}, degree ${degreeOf(curve)}${curve.weights ? ", rational" : ""}`;
    byId("others-list").replaceChildren(...curves.map((one, value) => make("option", { value }, words(one))));
    pick(0);
    say(`${curves.length} curves; the first is shown.`);
  } catch (wrong) {
    fault(wrong.message);
    byId("given-text").setAttribute("aria-invalid", "true");
  }
}

export function takeText(words) {
  byId("given-text").value = words;
  take(words);
}

async function takeFile(one) {
  if (one.size > largestFile) {
    fault(`${one.name} has ${Math.round(one.size / 1e6)} MB, here a file has at most ${largestFile / 1e6}; use the program.`);
    return;
  }
  const isFont = /\.(ttf|otf|ttc|woff2?)$/i.test(one.name);
  const words = isFont ? "\0" : await one.text();
  if (isFont || words.length > mostShown) {
    byId("given-text").value = "";
    take(words);
  } else takeText(words);
}

export function markExample(curve) {
  [...byId("examples").children].forEach((button, k) => button.setAttribute("aria-pressed", String(sameCurve(examples[k].curve, curve))));
}

export function listenToGiven(loader) {
  load = loader;
  byId("examples").append(...examples.map(({ name, what, curve, down = false, t = 0.3, view = "points" }) => make("button", { type: "button", title: what, click: () => {
    setFile(null);
    fault();
    load(curve, { down, t, view });
    say(`${name}: ${what}.`);
  } }, name)));
  const text = byId("given-text");
  text.addEventListener("input", late(() => (text.value.trim() ? take(text.value) : fault()), 350));
  byId("file").addEventListener("change", ({ target }) => {
    if (target.files[0]) takeFile(target.files[0]);
    target.value = "";
  });
  const dropping = (is) => document.body.classList.toggle("dropping", is);
  document.addEventListener("dragover", (event) => { event.preventDefault(); dropping(true); });
  document.addEventListener("dragleave", (event) => { if (!event.relatedTarget) dropping(false); });
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    dropping(false);
    const [one] = event.dataTransfer.files;
    if (one) takeFile(one);
    else takeText(event.dataTransfer.getData("text/plain"));
  });
  byId("others-list").addEventListener("change", ({ target }) => pick(Number(target.value)));
  byId("previous").addEventListener("click", () => pick(file.chosen - 1));
  byId("next").addEventListener("click", () => pick(file.chosen + 1));
}
