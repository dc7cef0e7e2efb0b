// SPDX-License-Identifier: MIT
// What one can ask of a curve besides its points: the question to the library, the table of the answers, what the picture shows of
// them, and the program's command.

import { axes, degreeOf, easingOf, lineOf, markOf, placeOf, pointsOf, text } from "./curve.mjs";
import { commandOf, option } from "./link.mjs";
import { digits, short } from "./table.mjs";

const list = (numbers) => [...numbers].map(text);
const at = (p) => `(${list(p).join(", ")})`;
const planeOf = (curve) => Array.from({ length: degreeOf(curve) + 1 }, (_, i) => markOf(curve, i));

// How many doubles lie between two.
function apart(a, b) {
  const place = (x) => {
    const bits = new BigInt64Array(new Float64Array([x]).buffer)[0];
    return bits < 0n ? -(bits & 0x7fffffffffffffffn) : bits;
  };
  const between = place(a) - place(b);
  return Number(between < 0n ? -between : between);
}

const evenly = (curve, from, to) => Array.from({ length: 61 }, (_, k) => placeOf(curve, from + ((to - from) * k) / 60));
const tightest = ({ rows }) => rows.find((row) => row.id === "exact_box")?.box;

// A side of exact_box is the tightest or the next double, so that a side farther inside cuts.
const cuts = (box, tight) => box.some((side, k) => (k % 2 ? side < tight[k] : side > tight[k]) && apart(side, tight[k]) > 1);

// Each view: its fields are names of the state; `choose` names what the picture shows of one method. ask(state) is the question for
// the worker, options(state) those of the command; head(curve), exact(answer), cells(row, answer) and value(row) make the table,
// draw(answer, state, row) what the picture adds for the chosen method.
export const questions = {
  length: {
    label: "Length", command: "length", fields: ["from", "to", "precision"],
    ask: ({ curve, from, to, precision }) => ({ curve, from, to, tolerance: precision }),
    options: ({ from, to, precision }) => `${from ? option("from", from) : ""}${to !== 1 ? option("to", to) : ""}${option("tolerance", precision)}`,
    head: () => ["length", "error", "evaluations", "says it converged"],
    exact: ({ exact }) => [text(exact)],
    cells: (row, { exact }) => [digits(row.length, exact), short(row.error), text(row.evaluations), row.converged ? "yes" : "no"],
    value: (row) => text(row.length),
    draw: (answer, { curve, from, to }) => ({ under: [{ line: evenly(curve, from, to), class: "part" }] }),
  },
  nearest: {
    label: "Nearest point", command: "project", fields: ["foot"], hint: "Drag the filled point, or type where it is.",
    ask: ({ curve, foot }) => ({ curve, foot }),
    options: ({ foot }) => option("point", list(foot).join(",")),
    head: () => ["t", "distance", "error", "compared"],
    exact: ({ exact }) => [text(exact.t), text(exact.distance)],
    cells: (row, { exact }) => [digits(row.t, exact.t), digits(row.distance, exact.distance), short(row.error), text(row.candidates)],
    value: (row) => text(row.t),
    draw: ({ exact }, { curve, foot }) => {
      const near = placeOf(curve, exact.t);
      const from = curve.dimension === 1 ? [exact.t, foot[0]] : foot.slice(0, 2);
      return { under: [{ line: [from, near], class: "distance" }], over: [{ dot: near, class: "found" }] };
    },
  },
  split: {
    label: "Split", command: "split", fields: [], hint: "The curve is split at the t below its picture.", choose: "halves of",
    ask: ({ curve, t }) => ({ curve, t }),
    options: ({ t }) => option("t", t),
    head: ({ dimension }) => ["error, u p~", ...axes.slice(0, dimension).map((axis) => `${axis} where they join`)],
    exact: ({ exact }) => ["", ...list(exact)],
    cells: ({ errors, join }, { exact }) => [short(Math.max(...errors.map((one) => one.u))), ...join.map((x, axis) => digits(x, exact[axis]))],
    value: ({ join }) => list(join).join(" "),
    draw: (answer, state, { halves } = { halves: [] }) => ({
      under: halves.flatMap((half, k) => [["", lineOf(half, 80)], [" thin", planeOf(half)]].map(([thin, line]) => ({ line, class: (k ? "right" : "left") + thin }))),
    }),
    more: ({ halves } = { halves: [] }) => halves.map((half, k) => {
      const weights = half.weights ? `, weights ${list(half.weights).join(" ")}` : "";
      return `${k ? "Right" : "Left"} half: ${pointsOf(half).map(at).join(" ")}${weights}`;
    }),
  },
  chords: {
    label: "Chords", command: "flatten", fields: ["tolerance"], choose: "chords of",
    hint: "The program also says, from the truth, whether every chord is near enough, and the least number of chords.",
    ask: ({ curve, tolerance }) => ({ curve, tolerance }),
    options: ({ tolerance }) => option("tolerance", tolerance),
    head: () => ["chords", "says it kept the tolerance"],
    cells: (row) => [text(row.t.length - 1), row.complete ? "yes" : "no"],
    value: (row) => text(row.t.length - 1),
    draw: (answer, { curve: { dimension: d } }, row) => {
      if (!row) return {};
      const ends = [...row.t].map((t, k) => (d === 1 ? [t, row.points[k]] : [row.points[k * d], row.points[k * d + 1]]));
      return { over: [{ line: ends, class: "chords" }, ...(ends.length < 400 ? ends.map((dot) => ({ dot, class: "end" })) : [])] };
    },
  },
  box: {
    label: "Box", command: "box", fields: [], choose: "box of",
    hint: "exact_box and split_box are proved to contain the curve. A side is judged by that of exact_box, which is the tightest or the next double.",
    ask: ({ curve }) => ({ curve }),
    options: () => "",
    head: ({ dimension }) => [...axes.slice(0, dimension).flatMap((axis) => [`${axis} from`, `${axis} to`]), "leaves curve outside"],
    cells: ({ box }, answer) => {
      const tight = tightest(answer);
      return tight ? [...box.map((side, k) => digits(side, tight[k])), cuts(box, tight) ? "yes" : "not seen"] : [...list(box), "–"];
    },
    value: ({ box }) => list(box).join(" "),
    draw: (answer, { curve }, row) => {
      const [a, b, c, d] = curve.dimension === 1 ? [0, 1, ...(row?.box ?? [])] : row?.box ?? [];
      return [a, b, c, d].every(Number.isFinite) ? { under: [{ line: [[a, c], [b, c], [b, d], [a, d]], closed: true, class: "box" }] } : {};
    },
  },
  easing: {
    label: "Easing", command: "ease", fields: ["x"],
    without: ({ curve }) => (easingOf(curve) ? "" : "An easing curve is a cubic from 0,0 to 1,1 with the x of its two inner points in [0, 1]; "
      + "try the example “CSS ease”."),
    ask: ({ curve, x }) => ({ bezier: easingOf(curve), x }),
    options: ({ x }) => option("x", x),
    head: () => ["y", "doubles from the nearest"],
    exact: ({ exact }) => [text(exact)],
    cells: ({ y }, { exact }) => [digits(y, exact), y === exact ? "0" : short(apart(y, exact))],
    value: ({ y }) => text(y),
    draw: ({ exact }, { x }) => ({
      under: [{ line: [[x, 0], [x, exact], [0, exact]], class: "distance" }], over: [{ dot: [x, exact], class: "found" }],
    }),
  },
};

// Why a view does not apply to the curve; empty where it does.
export function without(state) {
  const own = questions[state.view].without?.(state);
  return own ?? (state.curve.form === "power" ? "Control points are required; choose them with or without weights below the picture." : "");
}

export const commandFor = (state) => {
  if (state.view === "points" || without(state)) return commandOf("eval", state.curve, option("t", state.t));
  const { command, options } = questions[state.view];
  return commandOf(command, state.curve, options(state));
};
