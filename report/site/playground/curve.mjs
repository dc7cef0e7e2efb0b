// SPDX-License-Identifier: MIT
// Curves as the page holds them, { form, dimension, points, weights }: coordinates point after point, weights null unless rational.

export const axes = ["x", "y", "z"];
export const largestDegree = 1023;

export const degreeOf = (curve) => curve.points.length / curve.dimension - 1;
export const pointOf = (curve, i) => curve.points.slice(i * curve.dimension, (i + 1) * curve.dimension);
export const pointsOf = (curve) => Array.from({ length: degreeOf(curve) + 1 }, (_, i) => pointOf(curve, i));

// The shortest decimal that gives the same double.
export const text = (x) => (Object.is(x, -0) ? "-0" : String(x));

// A hexadecimal number, as the program writes sets.
function hexadecimal(word) {
  const [, sign, whole, fraction = "", power] = /^([-+]?)0x([\da-f]*)\.?([\da-f]*)p([-+]?\d+)$/i.exec(word);
  const exponent = Number(power) - 4 * fraction.length;
  const half = Math.trunc(exponent / 2); // one factor of all may underflow
  return (sign === "-" ? -1 : 1) * Number(BigInt(`0x0${whole}${fraction}`)) * 2 ** half * 2 ** (exponent - half);
}

// The number that a field holds. Throws a sentence where it holds none.
export function number(field, what = "This") {
  const word = field.trim();
  if (!word) throw Error(`${what} is empty; write a number.`);
  if (/^[-+]?\d+,\d+$/.test(word)) throw Error(`${what} has a comma; write ${word.replace(",", ".")} with a point.`);
  if (/^[-+]?0x([\da-f]+\.?[\da-f]*|\.[\da-f]+)p[-+]?\d{1,4}$/i.test(word)) return hexadecimal(word);
  if (!/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(word)) throw Error(`${what} is “${word.slice(0, 20)}”, which is not a number; write one such as 0.25.`);
  if (!Number.isFinite(Number(word))) throw Error(`${what} is beyond the largest double; write a smaller number.`);
  return Number(word);
}

// Throws a sentence where no method takes the curve.
export function check({ form, dimension, points, weights }) {
  const count = points.length / dimension;
  if (!(dimension >= 1 && dimension <= 3)) throw Error(`A point has ${dimension} coordinates; write 1 to 3.`);
  if (!count) throw Error("There are no points; write at least one, such as 0,0.");
  if (!Number.isInteger(count)) throw Error(`There are ${points.length} coordinates; write ${dimension} for each point.`);
  if (count > largestDegree + 1) throw Error(`There are ${count} points; the largest degree is ${largestDegree}.`);
  if (!points.every(Number.isFinite)) throw Error("A coordinate is not a finite number; correct it.");
  if ((form === "rational") !== Boolean(weights)) throw Error("The rational form has weights, and no other form has; add or remove them.");
  if (weights && weights.length !== count) throw Error(`There are ${weights.length} weights for ${count} points; write one for each.`);
  if (weights && !weights.every(Number.isFinite)) throw Error("A weight is not a finite number; correct it.");
  if (weights && weights.every((w) => w === 0)) throw Error("Every weight is 0; one must not be.");
  return { form, dimension, points: [...points], weights: weights ? [...weights] : null };
}

// The curve whose numbers are the nearest floats.
export const inFloat = (curve) => ({ ...curve, points: curve.points.map(Math.fround), weights: curve.weights && curve.weights.map(Math.fround) });

const key = ({ form, dimension, points, weights }) => `${form} ${dimension} ${points.map(text)} ${weights?.map(text)}`;
export const sameCurve = (a, b) => key(a) === key(b);

// x1, y1, x2, y2 of cubic-bezier() in CSS, or null where the curve is not one.
export function easingOf({ form, dimension, points: p }) {
  const is = form === "bernstein" && dimension === 2 && p.length === 8 && p[0] === 0 && p[1] === 0 && p[6] === 1 && p[7] === 1;
  return is && [p[2], p[4]].every((x) => x >= 0 && x <= 1) ? p.slice(2, 6) : null;
}

// Where the picture has the curve: in the plane, a curve of one coordinate as its graph over t. It is exact enough for pixels only.
export function placeOf(curve, t) {
  const n = degreeOf(curve);
  const at = (axis) => Array.from({ length: n + 1 }, (_, i) => curve.points[i * curve.dimension + axis]);
  // De Casteljau's algorithm; for high degrees, where that takes long, Woźny and Chudy's, which may divide by 0 outside [0, 1].
  const valueOf = (row) => {
    if (n <= 100 || !(t >= 0 && t <= 1)) return halved(row);
    let share = 1; // of the newest point in the mean of all before
    return row.reduce((mean, q, k) => {
      const upper = share * t * (n - k + 1);
      share = upper / (k * (1 - t) + upper);
      return (1 - share) * mean + share * q;
    });
  };
  const halved = (row) => {
    for (let k = n; k > 0; k -= 1) for (let i = 0; i < k; i += 1) row[i] = (1 - t) * row[i] + t * row[i + 1];
    return row[0];
  };
  const one = (axis) => {
    if (curve.form === "power") return at(axis).reduceRight((sum, q) => sum * t + q, 0);
    if (!curve.weights) return valueOf(at(axis));
    return valueOf(at(axis).map((x, i) => x * curve.weights[i])) / valueOf([...curve.weights]);
  };
  return curve.dimension === 1 ? [t, one(0)] : [one(0), one(1)];
}

// Where the picture has control point number i.
export const markOf = (curve, i) => (curve.dimension === 1 ? [i / (degreeOf(curve) || 1), curve.points[i]] : pointOf(curve, i).slice(0, 2));

// Points of the picture's line.
export function lineOf(curve, steps = 200) {
  return Array.from({ length: steps + 1 }, (_, k) => placeOf(curve, k / steps)).filter((p) => p.every(Number.isFinite));
}

// The low and the high corner of what is drawn.
export function extentOf(places) {
  const corner = (choose, start) => [0, 1].map((axis) => places.reduce((so, p) => choose(so, p[axis]), start));
  return places.length ? [corner(Math.min, Infinity), corner(Math.max, -Infinity)] : [[0, 0], [1, 1]];
}
