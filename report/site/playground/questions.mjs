// SPDX-License-Identifier: MIT
// What one can ask of a curve besides its points: the question to the library, the table of the answers, what the picture shows of
// them, and the program's command.

import { axes, easingOf, lineOf, placeOf, pointsOf, text } from "./curve.mjs";
import { commandOf, option } from "./link.mjs";
import { digits, short } from "./table.mjs";

const at = (p) => `(${[...p].map(text).join(", ")})`;
const polynomialOrRational = (state) => (state.curve.form === "power" ? "Control points are required; choose the Bernstein or the rational form." : "");
const plane = (curve, points) => points.map((p, k) => (curve.dimension === 1 ? [k / (points.length - 1 || 1), p[0]] : p.slice(0, 2)));

// How many doubles lie between two.
function apart(a, b) {
  const place = (x) => { const bits = new BigInt64Array(new Float64Array([x]).buffer)[0]; return bits < 0n ? -(bits & 0x7fffffffffffffffn) : bits; };
  const between = place(a) - place(b);
  return Number(between < 0n ? -between : between);
}
const doublesAway = (value, exact) => (value === exact ? "nearest" : `${short(apart(value, exact))} away`);
const evenly = (curve, from, to) => Array.from({ length: 61 }, (_, k) => placeOf(curve, from + ((to - from) * k) / 60));

// Each view: label, fields (names of the state), `without(state)` says why it does not apply, `ask(state)` is the question, `table(answer,
// state)` is { head, rows: [[id, label, cells]], exact }, `draw(answer, state, id)` what the picture adds for the method that is chosen.
export const questions = {
  length: {
    label: "Length", command: "length", fields: ["from", "to", "precision"],
    without: polynomialOrRational,
    ask: ({ curve, from, to, precision }) => ({ curve, from, to, tolerance: precision }),
    options: ({ from, to, precision }) => `${from ? option("from", from) : ""}${to !== 1 ? option("to", to) : ""}${option("tolerance", precision)}`,
    table: ({ exact, rows }) => ({
      head: ["length", "error", "evaluations", "says it converged"], exact: [text(exact)],
      rows: rows.map((row) => [row, [digits(row.length, exact), short(row.error), text(row.evaluations), row.converged ? "yes" : "no"], row.length]),
    }),
    draw: (answer, { curve, from, to }) => ({ under: [{ line: evenly(curve, from, to), class: "part" }] }),
  },
  nearest: {
    label: "Nearest point", command: "project", fields: ["foot"], hint: "Drag the filled point, or type where it is.",
    without: polynomialOrRational,
    ask: ({ curve, foot }) => ({ curve, foot }),
    options: ({ foot }) => option("point", foot.map(text).join(",")),
    table: ({ exact, rows }) => ({
      head: ["t", "distance", "error", "compared"], exact: [text(exact.t), text(exact.distance)],
      rows: rows.map((row) => [row, [digits(row.t, exact.t), digits(row.distance, exact.distance), short(row.error), text(row.candidates)], row.t]),
    }),
    draw: ({ exact }, { curve, foot }) => {
      const near = placeOf(curve, exact.t);
      const from = curve.dimension === 1 ? [exact.t, foot[0]] : foot.slice(0, 2);
      return { under: [{ line: [from, near], class: "distance" }], over: [{ dot: near, class: "found" }] };
    },
  },
  split: {
    label: "Split", command: "split", fields: [], hint: "The curve is split at the t below its picture.", choose: "halves of",
    without: polynomialOrRational,
    ask: ({ curve, t }) => ({ curve, t }),
    options: ({ t }) => option("t", t),
    table: ({ exact, rows }, { curve }) => ({
      head: ["error, u p~", ...axes.slice(0, curve.dimension).map((axis) => `${axis} where they join`)], exact: ["", ...exact.map(text)],
      rows: rows.map((row) => [row, row.fault ? [] : [short(Math.max(...row.errors.map((one) => one.u))), ...row.join.map((value, axis) => digits(value, exact[axis]))], row.fault ? "" : [...row.join].map(text).join(" ")]),
    }),
    draw: (answer, state, { halves } = {}) => ({
      under: (halves ?? []).flatMap((half, k) => [{ line: lineOf(half, 80), class: k ? "right" : "left" }, { line: plane(half, pointsOf(half)), class: k ? "right thin" : "left thin" }]),
    }),
    more: ({ halves } = {}) => (halves ?? []).map((half, k) => `${k ? "Right" : "Left"} half: ${pointsOf(half).map(at).join(" ")}${half.weights ? `, weights ${[...half.weights].map(text).join(" ")}` : ""}`),
  },
  chords: {
    label: "Chords", command: "flatten", fields: ["tolerance"], hint: "The program also says, from the truth, whether every chord is near enough, and the least number of chords.", choose: "chords of",
    without: polynomialOrRational,
    ask: ({ curve, tolerance }) => ({ curve, tolerance }),
    options: ({ tolerance }) => option("tolerance", tolerance),
    table: ({ rows }) => ({
      head: ["chords", "says it kept the tolerance"], exact: null,
      rows: rows.map((row) => [row, row.fault ? [] : [text(row.t.length - 1), row.complete ? "yes" : "no"], row.fault ? "" : row.t.length - 1]),
    }),
    draw: (answer, { curve }, row) => {
      if (!row?.t) return {};
      const ends = [...row.t].map((t, k) => (curve.dimension === 1 ? [t, row.points[k]] : [0, 1].map((axis) => row.points[k * curve.dimension + axis])));
      return { over: [{ line: ends, class: "chords" }, ...(ends.length < 400 ? ends.map((dot) => ({ dot, class: "end" })) : [])] };
    },
  },
  box: {
    label: "Box", command: "box", fields: [], hint: "exact_box and split_box are proved to contain the curve. A side is judged by that of exact_box, which is the tightest or the next double.", choose: "box of",
    without: polynomialOrRational,
    ask: ({ curve }) => ({ curve }),
    options: () => "",
    table: ({ rows }, { curve }) => {
      const tight = rows.find((row) => row.id === "exact_box")?.box;
      // A side of exact_box is the tightest or the next double, so that a side farther inside cuts.
      const cuts = ({ box }) => box.some((side, k) => (k % 2 ? side < tight[k] : side > tight[k]) && apart(side, tight[k]) > 1);
      return {
        head: [...axes.slice(0, curve.dimension).flatMap((axis) => [`${axis} from`, `${axis} to`]), "leaves curve outside"], exact: null,
        rows: rows.map((row) => [row, row.fault ? [] : [...row.box.map((side, k) => (tight ? digits(side, tight[k]) : text(side))), tight ? (cuts(row) ? "yes" : "not seen") : "–"], row.fault ? "" : [...row.box].map(text).join(" ")]),
      };
    },
    draw: (answer, { curve }, row) => {
      if (!row?.box) return {};
      const [a, b, c, d] = curve.dimension === 1 ? [0, 1, ...row.box] : row.box;
      return [a, b, c, d].every(Number.isFinite) ? { under: [{ line: [[a, c], [b, c], [b, d], [a, d]], closed: true, class: "box" }] } : {};
    },
  },
  easing: {
    label: "Easing", command: "ease", fields: ["x"],
    without: ({ curve }) => (easingOf(curve) ? "" : "An easing curve is a cubic from 0,0 to 1,1 with the x of its two inner points in [0, 1]; try the example “CSS ease”."),
    ask: ({ curve, x }) => ({ bezier: easingOf(curve), x }),
    options: ({ x }) => option("x", x),
    table: ({ exact, rows }) => ({
      head: ["y", "doubles from the nearest"], exact: [text(exact)],
      rows: rows.map((row) => [row, row.fault ? [] : [digits(row.y, exact), doublesAway(row.y, exact)], row.y]),
    }),
    draw: ({ exact }, { x }) => ({ under: [{ line: [[x, 0], [x, exact], [0, exact]], class: "distance" }], over: [{ dot: [x, exact], class: "found" }] }),
  },
};

export const commandFor = (state) => {
  if (state.view === "points" || questions[state.view].without(state)) return commandOf("eval", state.curve, option("t", text(state.t)));
  const { command, options } = questions[state.view];
  return commandOf(command, state.curve, options(state));
};
