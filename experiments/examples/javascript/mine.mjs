// SPDX-License-Identifier: MIT
// The library bezier-js as a program: npm install bezier-js, then
// bezierbench run SUITE --program 'node mine.mjs' --out BUNDLE
import { readFileSync } from "node:fs";
import { Bezier } from "bezier-js";

// Hexadecimal floating point, which JavaScript does not read: 0x1.8p+1 is 3.
function number(text) {
  const [, sign, whole, fraction, exponent] = /^(-?)0x([01])\.?([0-9a-f]*)p([+-]\d+)$/.exec(text);
  const digits = parseInt(whole + fraction, 16) * 2 ** Number(exponent) * 2 ** (-4 * fraction.length);
  return sign ? -digits : digits;
}

const [head, ...lines] = readFileSync(0, "utf8").trimEnd().split("\n");
const [, , , dimension] = head.split(" ").map(Number);
const answers = ["program_bezier_js bernstein 1 10"];
for (const line of lines) {
  const [t, ...coefficients] = line.split(" ").map(number);
  const points = [];
  for (let i = 0; i < coefficients.length; i += dimension) {
    const [x, y = 0, z = 0] = coefficients.slice(i, i + dimension);
    points.push(dimension === 3 ? { x, y, z } : { x, y });
  }
  const point = new Bezier(points).compute(t);
  answers.push([point.x, point.y, point.z].slice(0, dimension).join(" "));
}
console.log(answers.join("\n"));
