// SPDX-License-Identifier: MIT
// web_test.mjs WASM FOLDER: asks the module the questions that web_test.py wrote, and compares the answers bit for bit.

import { createReadStream, readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import assert from "node:assert/strict";
import { BezierbenchError, load } from "./bezierbench.mjs";

const [wasm, folder] = process.argv.slice(2);
const library = await load(readFileSync(wasm));
const bytes = readFileSync(`${folder}/numbers`);
const expected = new Float64Array(bytes.buffer, bytes.byteOffset, bytes.length / 8);
const atMethodCurveAndParameters = new Set(["evaluate", "bound"]);
const withoutCurve = new Set(["ease", "exactEase"]);

// The numbers of an answer, in the order of its members.
const flat = (answer) => (typeof answer === "number" || typeof answer === "boolean" ? [Number(answer)]
  : typeof answer === "string" ? [] : ArrayBuffer.isView(answer) ? [...answer] : Object.values(answer).flatMap(flat));

function ask(curve, name, rest, before) {
  if (withoutCurve.has(name)) return library[name](...rest);
  if (name === "exact") return library.exact(curve, curve.ts, ...rest);
  if (name === "error") return library.error(curve, curve.ts, before, ...rest);
  if (name === "split") return library.split(rest[0], curve, rest[1]).map(({ points, weights }) => [points, weights ?? []]);
  if (atMethodCurveAndParameters.has(name)) return library[name](rest[0], curve, curve.ts, ...rest.slice(1));
  return typeof rest[0] === "string" && name !== "roots" ? library[name](rest[0], curve, ...rest.slice(1)) : library[name](curve, ...rest);
}

let curves;
let numbers = [];
let place = 0;
let wrong = 0;
const differ = (question, what) => {
  wrong += 1;
  if (wrong <= 20) console.error(`${JSON.stringify(question).slice(0, 160)}: ${what}; curve ${JSON.stringify(curves[question[0]]).slice(0, 300)}`);
};
for await (const line of createInterface({ input: createReadStream(`${folder}/questions`) })) {
  if (!curves) { curves = JSON.parse(line); continue; }
  const [question, count] = JSON.parse(line);
  const [number, name, ...rest] = question;
  const curve = curves[number];
  const before = numbers;
  numbers = typeof count === "number" && count > 0 ? expected.subarray(place, place += count) : [];
  let answer;
  try {
    answer = ask(curve, name, rest, before);
  } catch (fault) {
    if (!(fault instanceof BezierbenchError)) throw fault;
    if (fault.status !== -count) differ(question, `status ${fault.status} (${fault.message}), native ${count > 0 ? "numbers" : -count}`);
    continue;
  }
  if (typeof count === "string") {
    if (answer !== count) differ(question, `${answer}, native ${count}`);
    continue;
  }
  const found = flat(answer);
  if (count < 0 || found.length !== numbers.length) { differ(question, `${found.length} numbers, native ${count}`); continue; }
  const k = found.findIndex((value, at) => !Object.is(value, numbers[at]));
  if (k >= 0) differ(question, `number ${k} is ${found[k]}, native ${numbers[k]}`);
}

// What has no native counterpart.
const cubic = { form: "bernstein", dimension: 2, points: [0, 0, 1, 2, 3, 3, 4, 0] };
const refuses = (status, call) => assert.throws(call, (fault) => fault instanceof BezierbenchError && fault.status === status);
assert.equal(library.misrounded("correctly_rounded", cubic), 0);
const exact = library.exact(cubic, Float64Array.from({ length: 1000 }, (_, k) => k / 999));
const computed = library.evaluate("de_casteljau", cubic, Float64Array.from({ length: 1000 }, (_, k) => k / 999));
assert.equal(library.misrounded("de_casteljau", cubic), computed.filter((value, k) => value !== exact[k]).length / 2000);
assert.equal(library.methods().find(({ id }) => id === "de_casteljau").fused, false);
assert.match(library.methods().find(({ id }) => id === "de_casteljau_fma").note, /no fused multiply-add/);
refuses(2, () => library.evaluate("de_castelja", cubic, [0.5]));
refuses(2, () => library.methods("roots and branches"));
refuses(3, () => library.evaluate("horner", cubic, [0.5]));
refuses(6, () => library.exact(cubic, [Infinity]));
refuses(9, () => library.exact({ form: "rational", dimension: 1, points: [0, 1], weights: [1, -1] }, [0.5]));
refuses(15, () => library.box("exact_box", { ...cubic, points: [0, 1, 2] }));
refuses(14, () => library.evaluate("de_casteljau", cubic, { length: 2 ** 29 }));
// After a trap the library answers as before.
refuses(16, () => library.evaluate("de_casteljau", cubic, { length: 1, get 0() { throw new WebAssembly.RuntimeError("unreachable"); } }));
assert.equal(library.exactText(cubic, 0.5, 0), "2");
console.log(wrong > 0 ? `web: ${wrong} calls differ` : "web: the same bits");
process.exit(wrong > 0 ? 1 : 0);
