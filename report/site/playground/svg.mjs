// SPDX-License-Identifier: MIT
// The curves of an SVG document: paths and basic shapes through the attribute `transform` of all elements around them, and what `use`
// repeats. As in the program, viewBox, style sheets and CSS transforms are not applied.

import { direction, draw, identity, mapped, Path } from "./path.mjs";

const quarterWeight = Math.SQRT2 / 2;
const mostNested = 64;
const mostElements = 1e5; // with all that use repeats

function times(outer, inner) {
  const linear = [...outer.slice(0, 4), 0, 0];
  return [...mapped(linear, inner.slice(0, 2)), ...mapped(linear, inner.slice(2, 4)), ...mapped(outer, inner.slice(4))];
}

const numbersOf = (list) => (list.match(/[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?/gi) ?? []).map(Number);

function transformOf(element) {
  const given = element.getAttribute("transform") ?? "";
  return [...given.matchAll(/(\w+)\s*\(([^)]*)\)/g)].reduce((all, [whole, name, list]) => {
    const v = numbersOf(list);
    const tangent = () => Math.tan(v[0] * (Math.PI / 180));
    const move = (x, y) => [1, 0, 0, 1, x, y];
    const turn = () => { const [c, s] = direction(v[0]); return [c, s, -s, c, 0, 0]; };
    const one = {
      matrix: () => v.length === 6 && v, translate: () => move(v[0], v[1] ?? 0), scale: () => [v[0], 0, 0, v[1] ?? v[0], 0, 0],
      skewX: () => [1, 0, tangent(), 1, 0, 0], skewY: () => [1, tangent(), 0, 1, 0, 0],
      rotate: () => (v.length === 3 ? times(times(move(v[1], v[2]), turn()), move(-v[1], -v[2])) : turn()),
    }[name]?.();
    if (!one || !v.length) throw Error(`“${whole.slice(0, 30)}” is not a transform of SVG; write matrix, translate, scale, rotate, skewX or skewY with its numbers.`);
    return times(all, one);
  }, identity);
}

function shape(element, kind, path) {
  const get = (name) => numbersOf(element.getAttribute(name) ?? "")[0] ?? 0;
  if (kind === "path") draw(element.getAttribute("d") ?? "", path());
  else if (kind === "line") { const one = path(); one.moveTo([get("x1"), get("y1")]); one.lineTo([get("x2"), get("y2")]); }
  else if (kind === "polyline" || kind === "polygon") {
    const v = numbersOf(element.getAttribute("points") ?? "");
    if (v.length % 2) throw Error(`The points of a ${kind} are ${v.length} numbers; write two for each point.`);
    const one = path();
    for (let k = 0; k < v.length; k += 2) one[k ? "lineTo" : "moveTo"]([v[k], v[k + 1]]);
    if (kind === "polygon" && v.length) one.close();
  } else {
    const has = (name) => element.hasAttribute(name) && element.getAttribute(name) !== "auto";
    let [rx, ry] = kind === "circle" ? [get("r"), get("r")] : [get(has("rx") ? "rx" : "ry"), get(has("ry") ? "ry" : "rx")];
    if (kind !== "rect") {
      const [x, y] = [get("cx"), get("cy")];
      if (!(rx > 0) || !(ry > 0)) return;
      const one = path();
      one.moveTo([x + rx, y]);
      one.conicTo([x + rx, y + ry], quarterWeight, [x, y + ry]);
      one.conicTo([x - rx, y + ry], quarterWeight, [x - rx, y]);
      one.conicTo([x - rx, y - ry], quarterWeight, [x, y - ry]);
      one.conicTo([x + rx, y - ry], quarterWeight, [x + rx, y]);
      return;
    }
    const [x, y, width, height] = ["x", "y", "width", "height"].map(get);
    if (!(width > 0) || !(height > 0)) return;
    [rx, ry] = [Math.min(Math.max(rx, 0), width / 2), Math.min(Math.max(ry, 0), height / 2)];
    const [right, bottom, one] = [x + width, y + height, path()];
    if (!rx || !ry) {
      one.moveTo([x, y]);
      for (const corner of [[right, y], [right, bottom], [x, bottom], [x, y]]) one.lineTo(corner);
      return;
    }
    const innerRight = rx === width / 2 ? x + rx : right - rx; // where no line is between two corners
    const innerBottom = ry === height / 2 ? y + ry : bottom - ry;
    one.moveTo([x + rx, y]);
    for (const [from, control, to] of [[[innerRight, y], [right, y], [right, y + ry]],
      [[right, innerBottom], [right, bottom], [innerRight, bottom]], [[x + rx, bottom], [x, bottom], [x, innerBottom]],
      [[x, y + ry], [x, y], [x + rx, y]]]) {
      if (one.current[0] !== from[0] || one.current[1] !== from[1]) one.lineTo(from);
      one.conicTo(control, quarterWeight, to);
    }
  }
}

// The curves [{ id, curve }] of the text of an SVG document. The document is parsed, never put into the page.
export function curvesOfSvg(source) {
  const document = new DOMParser().parseFromString(source, "image/svg+xml");
  if (document.querySelector("parsererror")) throw Error("This is not well-formed SVG; export the drawing again.");
  const curves = [];
  const names = new Set();
  let paths = 0;
  let elements = 0;
  const pathOf = (element, map) => () => {
    let name = element.id || String(paths);
    while (names.has(name)) name = names.has(String(paths)) ? `${name}'` : String(paths);
    names.add(name);
    paths += 1;
    return new Path(name, map, curves);
  };
  const walk = (element, outer, depth, used) => {
    if (depth > mostNested) throw Error(`The drawing is nested more than ${mostNested} deep with what use elements name; remove a use.`);
    elements += 1;
    if (elements > mostElements) throw Error(`The drawing has more than ${mostElements} elements with what use elements repeat; remove a use.`);
    const kind = element.localName;
    const map = times(outer, transformOf(element));
    const moved = () => times(map, [1, 0, 0, 1, Number.parseFloat(element.getAttribute("x")) || 0, Number.parseFloat(element.getAttribute("y")) || 0]);
    if (["g", "a", "svg", "switch"].includes(kind) || (kind === "symbol" && used)) {
      const inner = kind === "svg" && depth ? moved() : map;
      for (const child of element.children) walk(child, inner, depth + 1, false);
    } else if (kind === "use") {
      const name = (element.getAttribute("href") ?? element.getAttributeNS("http://www.w3.org/1999/xlink", "href") ?? "").trim();
      const named = name.startsWith("#") && document.getElementById(name.slice(1));
      if (named) walk(named, moved(), depth + 1, true);
    } else if (["path", "line", "polyline", "polygon", "rect", "circle", "ellipse"].includes(kind)) {
      shape(element, kind, pathOf(element, map));
    }
  };
  walk(document.documentElement, identity, 0, false);
  if (!curves.length) throw Error("The drawing has no path and no shape with an extent; text and images are not curves.");
  return curves;
}
