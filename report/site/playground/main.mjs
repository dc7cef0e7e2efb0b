// SPDX-License-Identifier: MIT
// The page: one state, and what shows it. A change goes through update(); the library answers later.

import { axes, degreeOf, extentOf, inFloat, lineOf, pointOf, sameCurve } from "./curve.mjs";
import { byId, copy, late, make } from "./dom.mjs";
import { Engine } from "./engine.mjs";
import { examples } from "./examples.mjs";
import { forgetFaults, makeFields, showCoordinates, showFields } from "./fields.mjs";
import { listenToGiven, markExample, placeInFile, showPlace, takeText } from "./given.mjs";
import { addressOf, stateOf, stateOfAddress } from "./link.mjs";
import { Picture } from "./picture.mjs";
import { commandFor, questions, without } from "./questions.mjs";
import { codeOf, MethodTable } from "./table.mjs";

const views = ["points", ...Object.keys(questions)];

let state;
let answers = {}; // the newest by kind
let chosen = {}; // the method that the picture shows, by view

const table = new MethodTable(byId("methods"));
const engine = new Engine((fault) => { byId("engine-fault").textContent = fault; });
const picture = new Picture(byId("picture"), (what, [x, y], done) => {
  const { curve } = state;
  if (![x, y].every(Number.isFinite)) return;
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
  history[address === location.hash ? "replaceState" : "pushState"](placeInFile(), "", address);
}, 400);

const ends = (curve) => extentOf(lineOf(curve, 40));
const round = (x, count) => Number(x.toPrecision(count));

// What a view starts from where nobody has chosen it.
function prepare(next) {
  const { curve } = next;
  const n = degreeOf(curve) + 1;
  if (next.foot?.length !== curve.dimension) next.foot = null;
  if (next.view === "nearest" && !next.foot) {
    const mean = (axis) => Array.from({ length: n }, (_, i) => pointOf(curve, i)[axis]).reduce((sum, x) => sum + x / n, 0);
    next.foot = axes.slice(0, curve.dimension).map((_, axis) => round(mean(axis), 5));
  }
  if (next.view === "chords" && next.tolerance === null) {
    const [low, high] = ends(curve);
    next.tolerance = round(Math.min(0.005 * Math.max(high[0] - low[0], high[1] - low[1]), 1e305), 1) || 0.01;
  }
  return next;
}

function update(change, { refit = false, keepAddress = false } = {}) {
  const before = state;
  state = prepare({ ...state, ...change });
  const moved = !before || !sameCurve(before.curve, state.curve) || before.scalar !== state.scalar;
  if (before?.view !== state.view) byId("fault").textContent = "";
  show();
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
    if (answer?.fault) table.refuseShares();
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
      if (state.view === "points") byId("fault").textContent = fault ?? "";
      byId("panel").classList.remove("stale");
      if (fault) { table.clear(); byId("fractions").replaceChildren(); return; }
      table.show(answer, question.curve.dimension, question.float);
      speak(byId("verdict").textContent);
      const fraction = (one, axis) => make("p", {}, make("b", {}, `${axes[axis]} = `), one || "too long to show");
      byId("fractions").replaceChildren(...answer.fractions.map(fraction));
      document.documentElement.dataset.answered = "points";
    });
    return;
  }
  const asked = state.view;
  const view = questions[asked];
  const reason = without(state);
  byId("without").textContent = reason;
  byId("answers-part").hidden = Boolean(reason) || !answers[asked];
  if (reason) {
    byId("fault").textContent = "";
    byId("panel").classList.remove("stale");
    answers[asked] = null;
    showMore();
    return;
  }
  const askedState = state;
  engine.ask(asked, view.ask(state), (answer, fault) => {
    if (state.view !== asked) return;
    byId("fault").textContent = fault ?? "";
    byId("answers-part").hidden = Boolean(fault);
    byId("panel").classList.remove("stale");
    answers[asked] = fault ? null : answer;
    if (fault) showMore();
    else showAnswer(view, answer, askedState);
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
  const head = view.head(of.curve);
  const cell = (name, attributes) => (...children) => make(name, attributes, ...children);
  const [column, rowHead, td] = [cell("th", { scope: "col" }), cell("th", { scope: "row" }), cell("td", {})];
  const cells = (values) => [...values, ...Array(head.length - values.length).fill("")].map((value) => td(...[value].flat()));
  const choose = (id) => {
    chosen[of.view] = id;
    picture.show(state, overlay());
    showMore();
  };
  const name = ({ id, label, bitStable, fault }) => {
    const title = "The C library decides its last digits; another one may give others.";
    const words = [codeOf(id), ...(bitStable ? [] : [make("b", { class: "badge", title }, "last digits vary")]), make("small", {}, label)];
    if (!view.choose || fault) return rowHead(...words);
    const checked = chosenRow(of.view)?.id === id;
    return rowHead(make("label", {}, make("input", { type: "radio", name: "drawn", value: id, checked, change: () => choose(id) }), ...words));
  };
  const focused = document.activeElement?.name === "drawn" ? document.activeElement.value : null;
  const [first, body] = [byId("answers").tHead, byId("answers").tBodies[0]];
  const label = make("th", { scope: "col", class: "label" }, view.choose ? `drawn: ${view.choose}` : "method");
  first.replaceChildren(make("tr", {}, label, ...head.map((one) => column(one))));
  const truth = view.exact ? [make("tr", { class: "exact" }, rowHead("true value, rounded once"), ...cells(view.exact(answer)))] : [];
  body.replaceChildren(...truth, ...answer.rows.map((row) => {
    const rest = row.fault ? [make("td", { class: "fault", colspan: head.length }, row.fault)] : cells(view.cells(row, answer));
    return make("tr", { "data-id": row.id, "data-varies": !row.bitStable, "data-v": row.fault ? "" : view.value(row) }, name(row), ...rest);
  }));
  if (focused) body.querySelector(`input[value="${focused}"]`)?.focus();
  showMore();
}

function showMore() {
  const more = state.view === "points" ? undefined : questions[state.view].more;
  byId("more").replaceChildren(...(more && answers[state.view] ? more(chosenRow(state.view)).map((one) => make("p", {}, one)) : []));
}

function show() {
  const { curve, view, scalar } = state;
  const question = questions[view];
  showCoordinates(curve, () => state, update);
  showFields(state, question?.fields ?? []);
  byId("form").value = curve.form;
  byId("down").checked = state.down;
  for (const radio of document.getElementsByName("scalar")) radio.checked = radio.value === scalar;
  byId("scalar-note").textContent = scalar === "float" ? "Coordinates, weights and t are rounded to float first." : "";
  const where = ["one coordinate, drawn over t", "in the plane", "in space, drawn from above"][curve.dimension - 1];
  byId("degree").textContent = `degree ${degreeOf(curve)}, ${where}`;
  byId("remove").disabled = degreeOf(curve) < 1;
  for (const tab of byId("tabs").children) {
    tab.setAttribute("aria-selected", String(tab.dataset.view === view));
    tab.tabIndex = tab.dataset.view === view ? 0 : -1;
  }
  byId("panel").setAttribute("aria-labelledby", `tab-${view}`);
  byId("points-part").hidden = Boolean(question);
  byId("question-part").hidden = !question;
  const inDouble = scalar === "float"; // the program's commands and the other questions have no float
  byId("question-hint").textContent = [question?.hint, inDouble && "Computed in double."].filter(Boolean).join(" ");
  byId("command-note").textContent = inDouble ? "in double" : "";
  byId("command").value = commandFor(state);
  markExample(curve);
}

// ---- Changes ----

function load(curve, more = {}) {
  chosen = {};
  answers = {};
  table.forget();
  byId("panel").classList.add("stale"); // until it is answered
  forgetFaults();
  const { scalar = "double", view = "points" } = state ?? {};
  update(stateOf(curve, { scalar, view, ...more }), { refit: true });
}

// The curve with other points, for the same t.
const reshape = (part) => load({ ...state.curve, ...part }, { t: state.t, down: state.down });

function listen() {
  listenToGiven(load);
  makeFields(() => state, update);
  byId("t").addEventListener("input", ({ target }) => update({ t: Number(target.value) }));
  byId("form").addEventListener("change", ({ target: { value } }) => {
    reshape({ form: value, weights: value === "rational" ? Array(degreeOf(state.curve) + 1).fill(1) : null });
  });
  byId("down").addEventListener("change", ({ target }) => update({ down: target.checked }, { refit: true }));
  byId("fit").addEventListener("click", () => update({}, { refit: true }));
  for (const radio of document.getElementsByName("scalar")) {
    radio.addEventListener("change", () => { table.forget(); update({ scalar: radio.value }); });
  }
  byId("add").addEventListener("click", () => {
    const { curve } = state;
    const [low, high] = ends(curve);
    const last = pointOf(curve, degreeOf(curve)).map((x, axis) => (axis ? x : round(Math.min(x + 0.25 * (high[0] - low[0] || 1), 1e308), 6)));
    reshape({ points: [...curve.points, ...last], weights: curve.weights && [...curve.weights, 1] });
  });
  byId("remove").addEventListener("click", () => {
    const { points, dimension, weights } = state.curve;
    reshape({ points: points.slice(0, -dimension), weights: weights && weights.slice(0, -1) });
  });
  byId("tabs").append(...views.map((view) => make("button", {
    type: "button", role: "tab", id: `tab-${view}`, "aria-controls": "panel", "data-view": view, click: () => update({ view }),
  }, questions[view]?.label ?? "Points")));
  byId("tabs").addEventListener("keydown", (event) => {
    const now = views.indexOf(state.view);
    const to = { ArrowLeft: now - 1, ArrowRight: now + 1, Home: 0, End: -1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    update({ view: views.at(to % views.length) });
    byId(`tab-${state.view}`).focus();
  });
  byId("link").addEventListener("click", () => {
    history.replaceState(placeInFile(), "", addressOf(state));
    copy(location.href, "The link");
  });
  byId("copy-command").addEventListener("click", () => copy(byId("command").value, "The command"));
  addEventListener("popstate", follow);
}

// Shows what the address says, and the first example where it says no curve.
function follow() {
  remember.cancel(); // what was to be remembered is of the place that was left
  byId("link-fault").textContent = "";
  let next = null;
  try {
    const words = /^#text=(.*)$/s.exec(location.hash);
    if (words) {
      takeText(decodeURIComponent(words[1]));
      // The curve has its own address, so that going back does not read the text another time.
      if (state) {
        remember.cancel();
        history.replaceState(placeInFile(), "", addressOf(state));
        return;
      }
    } else next = stateOfAddress(location.hash, views);
  } catch (wrong) {
    byId("link-fault").textContent = wrong instanceof URIError ? "The link is damaged; copy it again." : wrong.message;
    if (state) return;
  }
  if (state && addressOf(state) === location.hash) return;
  chosen = {};
  answers = {};
  table.forget();
  if (state) forgetFaults();
  showPlace(history.state);
  update(next ?? stateOf(examples[0].curve), { refit: true, keepAddress: true });
}

listen();
follow();
