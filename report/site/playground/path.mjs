// SPDX-License-Identifier: MIT
// Path data of SVG 2 as curves, as reference/curves/path_data.cpp reads it: lines have degree 1, arcs are rational quadratics of at
// most a quarter of their ellipse.

const add = (p, q) => [p[0] + q[0], p[1] + q[1]];
const scale = (factor, p) => [factor * p[0], factor * p[1]];
const minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
const same = (p, q) => p[0] === q[0] && p[1] === q[1];
const rounding = 2 ** -50; // what the square of half a chord may be off by: the coordinates of arcs are those of decimals

export const identity = [1, 0, 0, 1, 0, 0];
export function mapped([a, b, c, d, e, f], p) {
  return [a, b, c, d, e, f].every((v, k) => v === identity[k]) ? p : [a * p[0] + c * p[1] + e, b * p[0] + d * p[1] + f];
}

// Cosine and sine of an angle in degrees, exact at multiples of 90.
export function direction(degrees) {
  const turns = Math.round(degrees / 90);
  const rest = (degrees - 90 * turns) * (Math.PI / 180);
  const [c, s] = [Math.cos(rest), Math.sin(rest)];
  return [[c, s], [-s, c], [-c, -s], [s, -c]][((turns % 4) + 4) % 4];
}

// The pieces [control, weight, end] of the arc of the unit circle from `half` to -`half` about the middle of the chord; `out` is the unit
// vector from there to the middle of the arc. Nothing cancels: differences are written as quotients.
function piecesOf(half, square, out, large) {
  const back = minus([0, 0], half);
  const g = Math.sqrt(1 - square);
  const rest = square / (1 + g);
  if (!large && square <= 0.5 * (1 + rounding)) return [[scale(square / g, out), g, back]];
  if (!large) {
    const weight = Math.sqrt((1 + g) / 2);
    const middle = scale(rest, out);
    return [[add(middle, scale(1 / (1 + g), half)), weight, middle], [add(middle, scale(1 / (1 + g), back)), weight, back]];
  }
  const centre = scale(g, out);
  const cosine = Math.sqrt(rest / 2);
  const weight = Math.sqrt((1 + cosine) / 2);
  const quarter = (from) => scale(1 / Math.sqrt(2 * rest), add(from, scale(rest, out)));
  const control = (u, v) => add(centre, scale(1 / (1 + cosine), add(u, v)));
  const [first, last] = [quarter(half), quarter(back)];
  return [[control(minus(half, centre), first), weight, add(centre, first)], [control(first, out), weight, add(centre, out)],
    [control(out, last), weight, add(centre, last)], [control(last, minus(back, centre)), weight, back]];
}

// Collects the segments of one path, named `name`:subpath:segment, through an affine map.
export class Path {
  constructor(name, map, curves) {
    Object.assign(this, { name, map, curves, subpath: 0, segment: 0, start: [0, 0], current: [0, 0] });
  }
  add(points, weights = null) {
    const flat = points.flatMap((p) => mapped(this.map, p));
    if (!flat.every(Number.isFinite)) throw Error(`Path ${this.name} has a coordinate beyond the largest double; scale it down.`);
    const curve = { form: weights ? "rational" : "bernstein", dimension: 2, points: flat, weights };
    this.curves.push({ id: `${this.name}:${this.subpath}:${this.segment}`, curve });
    this.segment += 1;
    this.current = points[points.length - 1];
  }
  moveTo(p) {
    if (this.segment) this.subpath += 1;
    this.segment = 0;
    this.start = this.current = p;
  }
  lineTo(p) { this.add([this.current, p]); }
  conicTo(control, weight, p) { this.add([this.current, control, p], [1, weight, 1]); }
  close() {
    if (!same(this.current, this.start)) this.lineTo(this.start);
    this.moveTo(this.start);
  }
  arcTo(radii, degrees, large, sweep, p) {
    if (same(p, this.current)) return;
    let [rx, ry] = radii.map(Math.abs);
    if (!rx || !ry) { this.lineTo(p); return; }
    const axis = direction(degrees);
    const chord = minus(scale(0.5, this.current), scale(0.5, p));
    let half = [(axis[0] * chord[0] + axis[1] * chord[1]) / rx, (axis[0] * chord[1] - axis[1] * chord[0]) / ry];
    const largest = Math.max(Math.abs(half[0]), Math.abs(half[1]));
    const unit = half.map((x) => x / largest);
    const length = Math.sqrt(unit[0] * unit[0] + unit[1] * unit[1]);
    const distance = largest * length;
    let square = distance * distance;
    if (square > 1 - rounding) {
      if (distance > 1) {
        [rx, ry] = [rx * distance, ry * distance];
        half = scale(1 / length, unit);
      }
      [square, large] = [1, false];
    }
    const out = scale(sweep ? 1 / length : -1 / length, [-unit[1], unit[0]]);
    const middle = add(scale(0.5, this.current), scale(0.5, p));
    const placed = (q) => {
      const [x, y] = [rx * q[0], ry * q[1]];
      return add(middle, [axis[0] * x - axis[1] * y, axis[1] * x + axis[0] * y]);
    };
    const pieces = piecesOf(half, square, out, large);
    pieces.forEach(([control, weight, end], k) => this.conicTo(placed(control), weight, k + 1 < pieces.length ? placed(end) : p));
  }
}

// Draws path data on a path. Throws a sentence that names the place.
export function draw(data, path) {
  let at = 0;
  const refuse = (what) => { throw Error(`Path data, character ${at + 1}: ${at < data.length ? `“${data.slice(at, at + 12)}”` : "the end"} ${what}`); };
  const match = (pattern) => {
    pattern.lastIndex = at;
    const found = pattern.exec(data);
    if (found) at = pattern.lastIndex;
    return found?.[0];
  };
  const separator = () => match(/\s*,?\s*/y);
  const next = () => {
    const word = match(/[-+]?(\d+(\.\d+)?|\.\d+)(e[-+]?\d+)?/iy) ?? refuse("where a number is required; add it, or remove its command.");
    separator();
    return Number(word);
  };
  const flag = () => {
    const word = match(/[01]/y) ?? refuse("where a flag of an arc is required; write radii, rotation, two flags 0 or 1, and a point.");
    separator();
    return word === "1";
  };
  let before = "";
  let control = null;
  match(/\s*/y);
  while (at < data.length) {
    const letter = match(/[MLHVCSQTAZ]/iy) ?? refuse("where a command is required, one of MLHVCSQTAZ.");
    match(/\s*/y);
    let command = letter.toUpperCase();
    if (!before && command !== "M") { at = 0; refuse("where the first command is required, M or m."); }
    if (command === "Z") { path.close(); before = "Z"; continue; }
    const relative = letter !== command;
    const shift = (axis) => (relative ? path.current[axis] : 0);
    const point = () => { const x = next() + shift(0); return [x, next() + shift(1)]; };
    const mirrored = (kinds) => (kinds.includes(before) && control ? add(path.current, minus(path.current, control)) : path.current);
    do {
      if (command === "M") path.moveTo(point());
      else if (command === "L") path.lineTo(point());
      else if (command === "H") path.lineTo([next() + shift(0), path.current[1]]);
      else if (command === "V") path.lineTo([path.current[0], next() + shift(1)]);
      else if (command === "A") {
        const [rx, ry, degrees, large, sweep] = [next(), next(), next(), flag(), flag()];
        path.arcTo([rx, ry], degrees, large, sweep, point());
      } else {
        const first = command === "S" ? mirrored("CS") : command === "T" ? mirrored("QT") : point();
        control = command === "C" || command === "S" ? point() : first;
        const points = [path.current, first, ...(command === "C" || command === "S" ? [control] : []), point()];
        path.add(points);
      }
      before = command;
      if (command === "M") command = "L"; // more points of a moveto are lines
    } while (/[-+.\d]/.test(data[at] ?? ""));
  }
}
