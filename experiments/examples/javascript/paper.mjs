// SPDX-License-Identifier: MIT
// The library paper as a program, for plane cubics: npm install paper, then
// bezierbench run SUITE --program 'node paper.mjs' --out BUNDLE
import { readFileSync } from "node:fs";
import paper from "paper/dist/paper-core.js";

// Hexadecimal floating point, which JavaScript does not read: 0x1.8p+1 is 3.
function number(text) {
  const [, sign, whole, fraction, exponent] = /^(-?)0x([01])\.?([0-9a-f]*)p([+-]\d+)$/.exec(text);
  const digits = parseInt(whole + fraction, 16) * 2 ** Number(exponent) * 2 ** (-4 * fraction.length);
  return sign ? -digits : digits;
}

const [, ...lines] = readFileSync(0, "utf8").trimEnd().split("\n");
console.log("program_paper bernstein 3 3");
for (const line of lines) {
  const [t, ...coefficients] = line.split(" ").map(number);
  const point = paper.Curve.getPoint(coefficients, t);
  console.log(point.x, point.y);
}
