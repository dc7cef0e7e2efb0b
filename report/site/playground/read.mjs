// SPDX-License-Identifier: MIT
// Curves in what somebody typed, pasted or dropped, as docs/curves.md describes the layouts. Throws a sentence that says what to do.

import { axes, check, number } from "./curve.mjs";
import { draw, identity, Path } from "./path.mjs";
import { curvesOfSvg } from "./svg.mjs";

const forms = ["bernstein", "power", "rational"];

function ofJson(source) {
  let value;
  try { value = JSON.parse(source); } catch { throw Error("This is not JSON; write [[0,0],[1,2],[3,1]]."); }
  const curves = [];
  const isPoints = (one) => Array.isArray(one) && Array.isArray(one[0]) && typeof one[0][0] === "number";
  const add = (points, { weights, form = weights ? "rational" : "bernstein", id = String(curves.length) }) => {
    if (!points.every((p) => Array.isArray(p) && p.length === points[0].length)) throw Error(`Curve ${id}: every point must have ${points[0].length} coordinates.`);
    if (weights && !(Array.isArray(weights) && weights.every((w) => typeof w === "number"))) {
      throw Error(`Curve ${id}: the weights are not numbers; write an array of ${points.length}.`);
    }
    if (!forms.includes(form)) throw Error(`Curve ${id}: “${form}” is not a form; write bernstein, power or rational.`);
    curves.push({ id: String(id), curve: check({ form, dimension: points[0].length, points: points.flat(), weights }) });
  };
  const walk = (one) => {
    if (isPoints(one)) add(one, {});
    else if (Array.isArray(one)) one.forEach(walk);
    else if (one && isPoints(one.points)) add(one.points, one);
    else throw Error("This JSON has no points; write [[x,y],...], an array of these, or {\"points\": [[x,y],...]}.");
  };
  walk(value);
  if (!curves.length) throw Error("This JSON has no points; write [[x,y],...].");
  return curves;
}

function ofCsv(lines) {
  const header = lines[0].split(",").map((name) => name.trim());
  const column = (name) => header.indexOf(name);
  const given = axes.filter((name, k) => axes.slice(0, k + 1).every((one) => column(one) >= 0));
  const curve = column("curve") >= 0 ? "curve" : "segment";
  const unknown = header.find((name, k) => column(name) !== k || ![...given, curve, "index", "form", "w", "t"].includes(name));
  const several = [curve, "index", "form"].some((name) => column(name) >= 0);
  if (unknown !== undefined || !given.length || (several && (column(curve) < 0 || column("index") < 0))) {
    const what = unknown === undefined ? `is “${lines[0].slice(0, 40)}”` : `has the column “${unknown}”`;
    throw Error(`Line 1 ${what}; write x,y and w for weights, before these curve,index for several curves.`);
  }
  const groups = new Map();
  let last;
  lines.slice(1).forEach((line, k) => {
    const fields = line.split(",").map((field) => field.trim());
    if (fields.length !== header.length) throw Error(`Line ${k + 2} has ${fields.length} fields instead of ${header.length}; correct it.`);
    const id = fields[column(curve)] ?? "0";
    if (id !== last && groups.has(id)) throw Error(`Line ${k + 2}: curve “${id}” has rows above already; write the rows of a curve together.`);
    last = id;
    if (!groups.has(id)) groups.set(id, []);
    const rows = groups.get(id);
    const index = fields[column("index")] ?? String(rows.length);
    if (index !== String(rows.length)) {
      throw Error(`Line ${k + 2}: index is “${index}”, here must be ${rows.length}; write the rows of a curve in order, from 0.`);
    }
    rows.push((name) => fields[column(name)] ?? "");
  });
  return [...groups].map(([id, rows]) => {
    const dimension = given.filter((name) => rows[0](name)).length;
    const value = (row, name) => number(row(name), `Curve ${id}: ${name}`);
    const weights = column("w") >= 0 && rows[0]("w") ? rows.map((row) => value(row, "w")) : null;
    const form = rows[0]("form") || (weights ? "rational" : "bernstein");
    if (!forms.includes(form)) throw Error(`Curve ${id}: “${form}” is not a form; write bernstein, power or rational.`);
    return { id, curve: check({ form, dimension, points: rows.flatMap((row) => given.slice(0, dimension).map((name) => value(row, name))), weights }) };
  });
}

// "x,y x,y ..." or one point on each line.
function ofPoints(lines) {
  const commas = lines.some((line) => line.split(/\s+/).some((word) => /[^,;],[^,;]/.test(word)));
  const points = commas ? lines.flatMap((line) => line.split(/\s+/)) : lines;
  const rows = points.map((one) => one.split(/[\s,;]+/).filter(Boolean).map((word, axis) => number(word, axes[axis] ? `A coordinate ${axes[axis]}` : "A coordinate")));
  const wrong = rows.findIndex((row) => row.length !== rows[0].length);
  if (wrong >= 0) throw Error(`Point ${wrong} has ${rows[wrong].length} coordinates and point 0 ${rows[0].length}; write as many for each.`);
  if (rows.length === 1 && rows[0].length > 3) throw Error("Write a comma between the coordinates of a point and a blank between points: 0,0 1,2 3,1.");
  return [{ id: "0", curve: check({ form: "bernstein", dimension: rows[0].length, points: rows.flat(), weights: null }) }];
}

// { curves: [{ id, curve }], down }, where `down` tells that y grows downwards, as in drawings.
export function read(given) {
  const source = given.replace(/^\uFEFF/, "").trim();
  const lines = source.split(/\r?\n/).map((line) => line.trim()).filter((line) => line && !line.startsWith("#"));
  if (!source) throw Error("Nothing is written here; paste points such as 0,0 1,2 3,1, or path data.");
  if (/^(\0|wOF|OTTO|true|ttcf)/.test(given)) throw Error("Fonts are read by the program: bezierbench curves FONT --out set.csv, then drop set.csv here.");
  const down = (curves) => {
    if (!curves.length) throw Error("Nothing is drawn here; add a command such as L, C, Q or A with its numbers.");
    return { curves: curves.map(({ id, curve }) => ({ id, curve: check(curve) })), down: true };
  };
  if (source.startsWith("<")) return down(curvesOfSvg(source));
  if (/^[[{]/.test(source)) return { curves: ofJson(source), down: false };
  if (/^[mlhvcsqtaz][\s\d.+-]/i.test(source) || /^[mz]$/i.test(source)) {
    const curves = [];
    draw(source, new Path("0", identity, curves));
    return down(curves);
  }
  return { curves: /^[a-z]/i.test(lines[0] ?? "") ? ofCsv(lines) : ofPoints(lines), down: false };
}
