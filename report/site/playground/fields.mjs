// SPDX-License-Identifier: MIT
// The fields of numbers: coordinates, and what the views ask. `change(names)` takes what follows from a number.

import { axes, check, degreeOf, number, text } from "./curve.mjs";
import { byId, make } from "./dom.mjs";

const above0 = (what) => (words) => {
  const x = number(words, what);
  if (!(x > 0)) throw Error(`${what} must be above 0; write one such as 0.01.`);
  return x;
};
const within = (what, low, high) => (words, state) => {
  const x = number(words, what);
  if (x < low(state) || x > high(state)) throw Error(`${what} is outside [${low(state)}, ${high(state)}]; write a number from ${low(state)} to ${high(state)}.`);
  return x;
};
const named = {
  from: ["from t", within("The start", () => 0, (state) => state.to)],
  to: ["to t", within("The end", (state) => state.from, () => 1)],
  precision: ["tolerance, relative to the length", above0("The tolerance")],
  tolerance: ["tolerance, farthest from the curve", above0("The tolerance")],
  x: ["x, the time", (words) => number(words, "x")],
};

const invalidAt = (place) => [...document.querySelectorAll(`[aria-describedby="${place.id}"][aria-invalid]`)];

function showFault(place) {
  place.textContent = invalidAt(place).find((input) => !input.closest("[hidden]"))?.dataset.fault ?? "";
}

// `place` says what is wrong with a number; what is typed stays. `apply` gets each number that is one. A number that was refused may
// be right after a change of another.
export function listenTo(input, place, convert, apply) {
  input.setAttribute("aria-describedby", place.id);
  input.addEventListener("input", () => {
    input.dataset.typed = "";
    try {
      apply(convert(input.value));
      input.removeAttribute("aria-invalid");
    } catch (wrong) {
      input.setAttribute("aria-invalid", "true");
      input.dataset.fault = wrong.message;
      place.textContent = wrong.message;
      return;
    }
    for (const other of invalidAt(place)) if (other.hasAttribute("aria-invalid")) other.dispatchEvent(new Event("input"));
    showFault(place);
  });
}

// Shows a number, unless somebody types there or typed there what is not one yet.
export function showIn(input, words) {
  const kept = (document.activeElement === input && "typed" in input.dataset) || (input.hasAttribute("aria-invalid") && input.dataset.shown === words);
  input.dataset.shown = words;
  if (kept) return;
  input.value = words;
  input.removeAttribute("aria-invalid");
}

export function forgetFaults() {
  for (const place of ["fault", "given-fault", "coordinate-fault", "field-fault", "t-fault", "link-fault"]) byId(place).textContent = "";
  for (const input of document.querySelectorAll("[aria-invalid], [data-typed]")) {
    input.removeAttribute("aria-invalid");
    delete input.dataset.typed;
  }
}

const field = (id, more = {}) => make("input", { id, inputmode: "decimal", autocomplete: "off", ...more });

// `get()` is the state.
export function makeFields(get, change) {
  const add = (id, data, label, convert, apply) => {
    const input = field(id);
    byId("fields").append(make("label", data, label, input));
    listenTo(input, byId("field-fault"), convert, apply);
  };
  for (const [name, [label, convert]] of Object.entries(named)) {
    add(`field-${name}`, { "data-field": name }, label, (words) => convert(words, get()), (value) => change({ [name]: value }));
  }
  axes.forEach((axis, k) => add(`field-foot-${axis}`, { "data-field": "foot", "data-axis": k }, `${axis} of the point`,
    (words) => number(words, axis), (value) => change({ foot: get().foot.with(k, value) })));
  listenTo(byId("t-number"), byId("t-fault"), (words) => number(words, "t"), (t) => change({ t }));
}

// Shows the fields of a view, `names`.
export function showFields(state, names) {
  for (const label of byId("fields").children) {
    label.hidden = !names.includes(label.dataset.field) || Number(label.dataset.axis ?? 0) >= state.curve.dimension;
  }
  for (const name of Object.keys(named)) if (state[name] !== null) showIn(byId(`field-${name}`), text(state[name]));
  state.foot?.forEach((value, k) => showIn(byId(`field-foot-${axes[k]}`), text(value)));
  showFault(byId("field-fault"));
  byId("t").value = String(Math.min(1, Math.max(0, state.t)));
  showIn(byId("t-number"), text(state.t));
}

export function showCoordinates(curve, get, change) {
  const names = [...axes.slice(0, curve.dimension), ...(curve.weights ? ["w"] : [])];
  const places = Array.from({ length: degreeOf(curve) + 1 }, (_, i) => i);
  const body = byId("coordinates").tBodies[0];
  const cell = (i, name, k) => {
    const input = field(`c-${i}-${name}`, { "aria-label": `${name} of point ${i}` });
    listenTo(input, byId("coordinate-fault"), (words) => number(words, `${name} of point ${i}`), (value) => {
      const now = get().curve;
      const part = name === "w" ? { weights: now.weights.with(i, value) } : { points: now.points.with(i * now.dimension + k, value) };
      change({ curve: check({ ...now, ...part }) });
    });
    return make("td", {}, input);
  };
  if (body.dataset.shape !== `${names} ${places.length}`) {
    body.dataset.shape = `${names} ${places.length}`;
    const head = (name) => make("th", { scope: "col" }, name);
    byId("coordinates").tHead.replaceChildren(make("tr", {}, ...["i", ...names].map(head)));
    body.replaceChildren(...places.map((i) => make("tr", {}, make("th", { scope: "row" }, String(i)), ...names.map((name, k) => cell(i, name, k)))));
  }
  for (const i of places) {
    names.forEach((name, k) => showIn(byId(`c-${i}-${name}`), text(name === "w" ? curve.weights[i] : curve.points[i * curve.dimension + k])));
  }
}
