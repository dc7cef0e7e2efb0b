// SPDX-License-Identifier: MIT
// The page: one state, and what shows it. A change goes through update(); the library answers later.

import { axes, check, degreeOf, extentOf, inFloat, lineOf, number, pointOf, sameCurve, text } from "./curve.mjs";
import { byId, copy, late, make, numberField, say, showIn } from "./dom.mjs";
import { Engine } from "./engine.mjs";
import { examples } from "./examples.mjs";
import { addressOf, stateOf, stateOfAddress } from "./link.mjs";
import { overview, Picture } from "./picture.mjs";
import { commandFor, questions } from "./questions.mjs";
import { read } from "./read.mjs";
import { codeOf, MethodTable } from "./table.mjs";

const views = ["points", ...Object.keys(questions)];
const largestFile = 16e6;
const mostPictured = 3000; // curves of a file in the picture of all

let state;
let file = null; // { curves, chosen, down } of what was read, where that is several curves
let answers = {}; // the newest by kind
let chosen = {}; // the method that the picture shows, by view

const table = new MethodTable(byId("methods"));
const engine = new Engine((fault) => { byId("engine-fault").textContent = fault; });
const picture = new Picture(byId("picture"), (what, [x, y], done) => {
  const { curve } = state;
  if (what === "foot") update({ foot: curve.dimension === 1 ? [y] : [x, y, ...state.foot.slice(2)] });
  else {
    const points = [...curve.points];
    if (curve.dimension === 1) points[what] = y;
    else points.splice(what * curve.dimension, 2, x, y);
    update({ curve: { ...curve, points } });
  }
  if (done) byId("picture-said").textContent = `${x}, ${y}`;
});

const remember = late(() => {
  const address = addressOf(state);
  if (address !== location.hash) history.pushState(null, "", address);
}, 400);

const ends = (curve) => extentOf(lineOf(curve, 40));
const round = (x, count) => Number(x.toPrecision(count));

// What a view starts from where nobody has chosen it.
function prepare(next) {
  const { curve } = next;
  const n = degreeOf(curve) + 1;
  if (next.foot?.length !== curve.dimension) next.foot = null;
  if (next.view === "nearest" && !next.foot) next.foot = axes.slice(0, curve.dimension).map((_, axis) => round(Array.from({ length: n }, (__, i) => pointOf(curve, i)[axis]).reduce((a, b) => a + b / n, 0), 5));
  if (next.view === "chords" && next.tolerance === null) {
    const [low, high] = ends(curve);
    next.tolerance = round(0.005 * Math.max(high[0] - low[0], high[1] - low[1]), 1) || 0.01;
  }
  return next;
}

function update(change, { refit = false, keepAddress = false } = {}) {
  const before = state;
  state = prepare({ ...state, ...change });
  const moved = !before || !sameCurve(before.curve, state.curve) || before.scalar !== state.scalar;
  showFields();
  picture.show(state, overlay(), refit || !before || before.view !== state.view);
  ask(moved);
  if (!keepAddress) remember();
}

// ---- Questions and answers ----

function given() {
  const float = state.scalar === "float";
  return { curve: float ? inFloat(state.curve) : state.curve, t: float ? Math.fround(state.t) : state.t, float };
}

const askShares = late(() => {
  const { curve, float } = given();
  engine.ask("shares", { curve, float }, (answer) => {
    if (answer?.id) { table.share(answer.id, answer.share); return; }
    byId("methods").classList.remove("waiting");
    byId("share-note").textContent = answer?.fault ? `The share that is not nearest is ${answer.fault}.` : "";
    table.arrange();
  });
}, 300);

function ask(moved) {
  const question = given();
  if (moved) {
    byId("methods").classList.add("waiting");
    askShares();
  }
  if (state.view === "points") {
    engine.ask("points", question, (answer, fault) => {
      byId("fault").textContent = fault ?? "";
      byId("panel").classList.remove("stale");
      if (fault) return;
      table.show(answer, question.curve.dimension);
      speak(byId("verdict").textContent);
      byId("fractions").replaceChildren(...answer.fractions.map((one, axis) => make("p", {}, make("b", {}, `${axes[axis]} = `), one || "too long to show")));
      document.documentElement.dataset.answered = "points";
    });
    return;
  }
  const asked = state.view;
  const view = questions[asked];
  const without = view.without(state);
  byId("without").textContent = without;
  byId("answers-part").hidden = Boolean(without) || !answers[asked];
  if (without) { answers[asked] = null; byId("panel").classList.remove("stale"); showMore(); return; }
  const askedState = state;
  engine.ask(asked, view.ask(state), (answer, fault) => {
    if (state.view !== asked) return;
    byId("fault").textContent = fault ?? "";
    byId("answers-part").hidden = Boolean(fault);
    byId("panel").classList.remove("stale");
    answers[asked] = fault ? null : answer;
    if (!fault) showAnswer(view, answer, askedState);
    picture.show(state, overlay());
    document.documentElement.dataset.answered = asked;
  });
}

const speak = late((words) => { byId("spoken").textContent = words; }, 900);

function chosenRow(view) {
  const rows = answers[view]?.rows.filter((row) => !row.fault) ?? [];
  return rows.find((row) => row.id === chosen[view]) ?? rows[0];
}

function overlay() {
  const { view } = state;
  return view === "points" || !answers[view] ? {} : questions[view].draw(answers[view], state, chosenRow(view));
}

function showAnswer(view, answer, of) {
  const { head, rows, exact } = view.table(answer, of);
  const cells = (values) => values.map((value) => make("td", {}, ...[value].flat()));
  const name = ({ id, label, bitStable, fault }) => {
    const varies = bitStable ? [] : [make("b", { class: "badge", title: "The C library decides its last digits; another one may give others." }, "last digits vary")];
    const words = [codeOf(id), ...varies, make("small", {}, label)];
    if (!view.choose || fault) return make("th", { scope: "row" }, ...words);
    const radio = make("input", { type: "radio", name: "drawn", value: id, checked: chosenRow(of.view)?.id === id, change: () => { chosen[of.view] = id; picture.show(state, overlay()); showMore(); } });
    return make("th", { scope: "row" }, make("label", {}, radio, ...words));
  };
  const focused = document.activeElement?.name === "drawn" ? document.activeElement.value : null;
  const [first, body] = [byId("answers").tHead, byId("answers").tBodies[0]];
  first.replaceChildren(make("tr", {}, make("th", { scope: "col", class: "label" }, view.choose ? `drawn: ${view.choose}` : "method"), ...head.map((one) => make("th", { scope: "col" }, one))));
  const filled = (list) => [...list, ...Array.from({ length: head.length - list.length }, () => "")];
  body.replaceChildren(...(exact ? [make("tr", { class: "exact" }, make("th", { scope: "row" }, "true value, rounded once"), ...cells(filled(exact)))] : []),
    ...rows.map(([row, list, value]) => make("tr", { "data-id": row.id, "data-varies": !row.bitStable, "data-v": row.fault ? "" : String(value) }, name(row),
      ...(row.fault ? [make("td", { class: "fault", colspan: head.length }, row.fault)] : cells(filled(list))))));
  if (focused) body.querySelector(`input[value="${focused}"]`)?.focus();
  showMore();
}

function showMore() {
  const more = state.view === "points" ? undefined : questions[state.view].more;
  byId("more").replaceChildren(...(more && answers[state.view] ? more(chosenRow(state.view)).map((one) => make("p", {}, one)) : []));
}

// ---- Fields ----

const inUnit = (what) => (words) => { const x = number(words, what); if (x < 0 || x > 1) throw Error(`${what} is outside [0, 1]; write a number between.`); return x; };
const positive = (what) => (words) => { const x = number(words, what); if (!(x > 0)) throw Error(`${what} must be above 0; write one such as 0.01.`); return x; };
const fields = {
  from: { label: "from t", read: (words) => { const x = inUnit("The start")(words); if (x > state.to) throw Error("The start is behind the end; write a smaller number."); return x; } },
  to: { label: "to t", read: (words) => { const x = inUnit("The end")(words); if (x < state.from) throw Error("The end is before the start; write a larger number."); return x; } },
  precision: { label: "tolerance, relative to the length", read: positive("The tolerance") },
  tolerance: { label: "tolerance, farthest from the curve", read: positive("The tolerance") },
  x: { label: "x, the time", read: (words) => number(words, "x") },
};

function makeFields() {
  for (const [name, { label, read: what }] of Object.entries(fields)) {
    const input = make("input", { id: `field-${name}`, inputmode: "decimal", autocomplete: "off", "aria-describedby": "field-fault" });
    byId("fields").append(make("label", { "data-field": name }, label, input));
    numberField(input, byId("field-fault"), what, (value) => update({ [name]: value }));
  }
  axes.forEach((axis, k) => {
    const input = make("input", { id: `field-foot-${axis}`, inputmode: "decimal", autocomplete: "off", "aria-describedby": "field-fault" });
    byId("fields").append(make("label", { "data-field": "foot", "data-axis": k }, `${axis} of the point`, input));
    numberField(input, byId("field-fault"), (words) => number(words, axis), (value) => update({ foot: state.foot.with(k, value) }));
  });
}

function coordinateField(i, k, name) {
  const input = make("input", { id: `c-${i}-${name}`, inputmode: "decimal", autocomplete: "off", "aria-label": `${name} of point ${i + 1}`, "aria-describedby": "coordinate-fault" });
  numberField(input, byId("coordinate-fault"), (words) => number(words, `${name} of point ${i + 1}`), (value) => {
    const { curve } = state;
    update({ curve: check(name === "w" ? { ...curve, weights: curve.weights.with(i, value) } : { ...curve, points: curve.points.with(i * curve.dimension + k, value) }) });
  });
  return make("td", {}, input);
}

function showCoordinates() {
  const { curve } = state;
  const names = [...axes.slice(0, curve.dimension), ...(curve.weights ? ["w"] : [])];
  const count = degreeOf(curve) + 1;
  const shape = `${names} ${count}`;
  const body = byId("coordinates").tBodies[0];
  if (body.dataset.shape !== shape) {
    body.dataset.shape = shape;
    byId("coordinate-fault").textContent = "";
    byId("coordinates").tHead.replaceChildren(make("tr", {}, make("th", { scope: "col" }, "i"), ...names.map((name) => make("th", { scope: "col" }, name))));
    body.replaceChildren(...Array.from({ length: count }, (_, i) => make("tr", {}, make("th", { scope: "row" }, String(i)), ...names.map((name, k) => coordinateField(i, k, name)))));
  }
  for (let i = 0; i < count; i += 1) {
    names.forEach((name, k) => showIn(byId(`c-${i}-${name}`), text(name === "w" ? curve.weights[i] : curve.points[i * curve.dimension + k])));
  }
}

function showFields() {
  const { curve, t, view, scalar } = state;
  showCoordinates();
  byId("t").value = String(Math.min(1, Math.max(0, t)));
  showIn(byId("t-number"), text(t));
  byId("form").value = curve.form;
  byId("down").checked = state.down;
  for (const radio of document.getElementsByName("scalar")) radio.checked = radio.value === scalar;
  byId("scalar-note").textContent = scalar === "float" ? "Coordinates, weights and t are rounded to float first." : "";
  byId("degree").textContent = `degree ${degreeOf(curve)}, ${curve.dimension === 1 ? "one coordinate, drawn over t" : curve.dimension === 3 ? "in space, drawn from above" : "in the plane"}`;
  byId("remove").disabled = degreeOf(curve) < 1;
  for (const tab of byId("tabs").children) { const is = tab.dataset.view === view; tab.setAttribute("aria-selected", String(is)); tab.tabIndex = is ? 0 : -1; }
  byId("panel").setAttribute("aria-labelledby", `tab-${view}`);
  byId("points-part").hidden = view !== "points";
  byId("question-part").hidden = view === "points";
  const names = view === "points" ? [] : questions[view].fields;
  for (const label of byId("fields").children) label.hidden = !names.includes(label.dataset.field) || Number(label.dataset.axis ?? 0) >= curve.dimension;
  for (const name of Object.keys(fields)) if (state[name] !== null) showIn(byId(`field-${name}`), text(state[name]));
  if (state.foot) state.foot.forEach((value, k) => showIn(byId(`field-foot-${axes[k]}`), text(value)));
  byId("question-hint").textContent = questions[view]?.hint ?? "";
  byId("command").value = commandFor(state);
  for (const button of byId("examples").children) button.setAttribute("aria-pressed", String(sameCurve(examples[button.dataset.number].curve, curve)));
  byId("others").hidden = !file;
}

// ---- What is read ----

function load(curve, more = {}) {
  chosen = {};
  answers = {};
  table.forget();
  byId("panel").classList.add("stale"); // until it is answered
  for (const place of ["coordinate-fault", "field-fault", "link-fault"]) byId(place).textContent = "";
  const { scalar = "double", view = "points" } = state ?? {};
  update(stateOf(curve, { scalar, view, ...more }), { refit: true });
}

function pick(number_) {
  file.chosen = (number_ + file.curves.length) % file.curves.length;
  byId("others-list").value = String(file.chosen);
  byId("others-count").textContent = `curve ${file.chosen + 1} of ${file.curves.length}`;
  overview(byId("overview"), file.curves.slice(0, mostPictured), Math.min(file.chosen, mostPictured - 1), file.down, pick);
  load(file.curves[file.chosen].curve, { down: file.down });
}

// Takes what somebody gave; the line below the field says what is wrong with it.
function take(source) {
  try {
    const { curves, down } = read(source);
    byId("given-fault").textContent = "";
    byId("given-text").removeAttribute("aria-invalid");
    file = curves.length > 1 ? { curves, down, chosen: 0 } : null;
    if (!file) { load(curves[0].curve, { down }); return; }
    byId("others-list").replaceChildren(...curves.map(({ id, curve }, k) => make("option", { value: k }, `${id}, degree ${degreeOf(curve)}${curve.weights ? ", rational" : ""}`)));
    pick(0);
    say(`${curves.length} curves; the first is shown.`);
  } catch (wrong) {
    byId("given-fault").textContent = wrong.message;
    byId("given-text").setAttribute("aria-invalid", "true");
  }
}

async function takeFile(one) {
  if (one.size > largestFile) { byId("given-fault").textContent = `${one.name} has ${Math.round(one.size / 1e6)} MB; a file has at most ${largestFile / 1e6} MB here, the program reads larger ones.`; return; }
  const words = /\.(ttf|otf|ttc|woff2?)$/i.test(one.name) ? "\0" : await one.text();
  if (words !== "\0" && words.length < 20000) byId("given-text").value = words;
  take(words);
}

function listen() {
  byId("examples").append(...examples.map(({ name, what }, k) => make("button", { type: "button", title: what, "data-number": k, click: () => {
    const { curve, down = false, t = 0.3, view = "points" } = examples[k];
    file = null;
    byId("given-fault").textContent = "";
    load(curve, { down, t, view });
    say(`${name}: ${what}.`);
  } }, name)));
  const typed = late(() => { if (byId("given-text").value.trim()) take(byId("given-text").value); else byId("given-fault").textContent = ""; }, 350);
  byId("given-text").addEventListener("input", typed);
  byId("file").addEventListener("change", ({ target }) => { if (target.files[0]) takeFile(target.files[0]); target.value = ""; });
  document.addEventListener("dragover", (event) => { event.preventDefault(); document.body.classList.add("dropping"); });
  document.addEventListener("dragleave", (event) => { if (!event.relatedTarget) document.body.classList.remove("dropping"); });
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("dropping");
    const [one] = event.dataTransfer.files;
    if (one) takeFile(one);
    else { byId("given-text").value = event.dataTransfer.getData("text/plain"); take(byId("given-text").value); }
  });
  byId("t").addEventListener("input", ({ target }) => update({ t: Number(target.value) }));
  numberField(byId("t-number"), byId("t-fault"), (words) => number(words, "t"), (t) => update({ t }));
  byId("form").addEventListener("change", ({ target }) => {
    const { curve } = state;
    load({ ...curve, form: target.value, weights: target.value === "rational" ? Array(degreeOf(curve) + 1).fill(1) : null }, { t: state.t, down: state.down });
  });
  byId("down").addEventListener("change", ({ target }) => update({ down: target.checked }, { refit: true }));
  byId("fit").addEventListener("click", () => update({}, { refit: true }));
  for (const radio of document.getElementsByName("scalar")) radio.addEventListener("change", () => { table.forget(); update({ scalar: radio.value }); });
  byId("add").addEventListener("click", () => {
    const { curve } = state;
    const [low, high] = ends(curve);
    const last = pointOf(curve, degreeOf(curve)).map((x, axis) => (axis ? x : round(x + 0.25 * (high[0] - low[0] || 1), 6)));
    load({ ...curve, points: [...curve.points, ...last], weights: curve.weights && [...curve.weights, 1] }, { t: state.t, down: state.down });
  });
  byId("remove").addEventListener("click", () => {
    const { curve } = state;
    load({ ...curve, points: curve.points.slice(0, -curve.dimension), weights: curve.weights && curve.weights.slice(0, -1) }, { t: state.t, down: state.down });
  });
  byId("tabs").append(...views.map((view) => make("button", { type: "button", role: "tab", id: `tab-${view}`, "aria-controls": "panel", "data-view": view, click: () => update({ view }) }, questions[view]?.label ?? "Points")));
  byId("tabs").addEventListener("keydown", (event) => {
    const to = { ArrowLeft: -1, ArrowRight: 1, Home: -views.indexOf(state.view), End: views.length - 1 - views.indexOf(state.view) }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    update({ view: views[(views.indexOf(state.view) + to + views.length) % views.length] });
    byId(`tab-${state.view}`).focus();
  });
  byId("others-list").addEventListener("change", ({ target }) => pick(Number(target.value)));
  byId("previous").addEventListener("click", () => pick(file.chosen - 1));
  byId("next").addEventListener("click", () => pick(file.chosen + 1));
  byId("link").addEventListener("click", () => {
    history.replaceState(null, "", addressOf(state));
    copy(location.href, "The link");
  });
  byId("copy-command").addEventListener("click", () => copy(byId("command").value, "The command"));
  addEventListener("popstate", follow);
  makeFields();
}

// Shows what the address says, and the first example where it says no curve.
function follow() {
  byId("link-fault").textContent = "";
  let next = null;
  try {
    const words = /^#text=(.*)$/s.exec(location.hash);
    if (words) {
      byId("given-text").value = decodeURIComponent(words[1]);
      take(byId("given-text").value);
      if (state) return;
    } else next = stateOfAddress(location.hash, views);
  } catch (wrong) {
    byId("link-fault").textContent = wrong instanceof URIError ? "The link is damaged; copy it again." : wrong.message;
    if (state) return;
  }
  if (state && addressOf(state) === location.hash) return;
  chosen = {};
  answers = {};
  table.forget();
  update(next ?? stateOf(examples[0].curve), { refit: true, keepAddress: true });
}

listen();
follow();
