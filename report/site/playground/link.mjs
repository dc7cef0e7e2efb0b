// SPDX-License-Identifier: MIT
// The state of the page as an address that reproduces it to the bit, and as the program's command.

import { axes, check, degreeOf, easingOf, number, pointsOf, text } from "./curve.mjs";

const list = (numbers) => numbers.map(text).join(",");
const defaults = { t: 0.3, scalar: "double", view: "points", precision: 1e-9, tolerance: null, from: 0, to: 1, x: 0.5, down: false, foot: null };

const numbersOfState = ["t", "precision", "tolerance", "from", "to", "x"];

export const stateOf = (curve, more = {}) => ({ ...defaults, ...more, curve });

export function addressOf(state) {
  const { curve, foot } = state;
  const parts = [["form", curve.form], ["dimension", curve.dimension], ["points", list(curve.points)]];
  if (curve.weights) parts.push(["weights", list(curve.weights)]);
  for (const name of numbersOfState) if (!Object.is(state[name], defaults[name])) parts.push([name, text(state[name])]);
  for (const name of ["scalar", "view"]) if (state[name] !== defaults[name]) parts.push([name, state[name]]);
  if (state.down) parts.push(["down", "yes"]);
  if (foot) parts.push(["foot", list(foot)]);
  return `#${parts.map(([name, value]) => `${name}=${value}`).join("&")}`;
}

// The state of an address; null for one without a curve. Throws a sentence for one that is damaged. `views` are the known ones.
export function stateOfAddress(address, views) {
  const given = new Map(address.replace(/^#/, "").split("&").map((part) => part.split("=").map(decodeURIComponent)));
  if (!given.has("points")) return null;
  const numbers = (name) => given.get(name).split(",").map((word) => number(word, `The link’s ${name}`));
  const curve = check({
    form: given.get("form") ?? "bernstein", dimension: given.has("dimension") ? numbers("dimension")[0] : 2, points: numbers("points"),
    weights: given.has("weights") ? numbers("weights") : null,
  });
  if (!["bernstein", "power", "rational"].includes(curve.form)) throw Error(`The link’s form is “${curve.form}”; write bernstein, power or rational.`);
  const state = stateOf(curve);
  for (const name of numbersOfState) if (given.has(name)) [state[name]] = numbers(name);
  if (given.get("scalar") === "float") state.scalar = "float";
  if (views.includes(given.get("view"))) state.view = given.get("view");
  state.down = given.get("down") === "yes";
  if (given.has("foot") && numbers("foot").length === curve.dimension) state.foot = numbers("foot");
  return state;
}

// An option and its number; a negative one would read as another option.
export const option = (name, value) => ` --${name}${text(value).startsWith("-") ? "=" : " "}${text(value)}`;

// The curve as path data; null where it is not one.
export function pathOf(curve) {
  const letter = curve.form === "bernstein" && curve.dimension === 2 ? [, "L", "Q", "C"][degreeOf(curve)] : undefined;
  if (!letter) return null;
  const [first, ...rest] = pointsOf(curve).map((p) => list(p));
  return `M${first} ${letter}${rest.join(" ")}`;
}

export function csvOf(curve) {
  const head = [...axes.slice(0, curve.dimension), ...(curve.weights ? ["w"] : [])].join(",");
  const rows = pointsOf(curve).map((p, i) => list(curve.weights ? [...p, curve.weights[i]] : p));
  return [head, ...rows];
}

// The program's command `curve NAME` for a curve.
export function commandOf(name, curve, options) {
  if (name === "ease") return `bezierbench curve ease --bezier ${list(easingOf(curve))}${options}`;
  const path = pathOf(curve);
  if (path) return `bezierbench curve ${name} --path '${path}'${options}`;
  const form = curve.form === "power" ? " --form power" : "";
  return `printf '${csvOf(curve).join("\\n")}\\n' | bezierbench curve ${name} --curve -${form}${options}`;
}
