// SPDX-License-Identifier: MIT
// The curve with its control polygon. Points are moved by pointer or by arrow keys.

import { degreeOf, extentOf, lineOf, markOf, placeOf, text } from "./curve.mjs";
import { byId, make } from "./dom.mjs";

const margin = 34;
const farthest = 1e7; // pixels from the picture: what is drawn beyond looks the same
const noPicture = "The coordinates are too large or too small for a picture.";
const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class Picture {
  // `moved(what, place, done)`: what is the number of a control point or "foot"; place is in the plane.
  constructor(svg, moved) {
    Object.assign(this, { svg, moved, handles: new Map(), overlay: {} });
    this.layers = Object.fromEntries(["grid", "under", "polygon", "curve", "over", "handles"].map((name) => [name, svg.appendChild(make("g", { class: name }))]));
    this.measure();
    new ResizeObserver(() => { this.measure(); if (this.state) this.show(this.state, this.overlay, true); }).observe(svg);
  }

  // Kept, because a look at the size lays the whole page out.
  measure() { this.size = [this.svg.clientWidth || 600, this.svg.clientHeight || 400]; }

  fit(state) {
    const { curve, foot } = state;
    const marks = curve.form === "power" ? [] : Array.from({ length: degreeOf(curve) + 1 }, (_, i) => markOf(curve, i));
    const [low, high] = extentOf([...marks, ...lineOf(curve, 40), ...(foot && state.view === "nearest" ? [this.footPlace(state)] : [])]);
    const [width, height] = this.size;
    const span = [0, 1].map((axis) => high[axis] - low[axis]);
    const wide = (axis) => ([width, height][axis] - 2 * margin) / (span[axis] || Math.max(...span) || 1);
    // A graph over t has axes of their own scales, a curve in the plane has one scale.
    const scales = curve.dimension === 1 ? [wide(0), wide(1)] : [0, 1].map(() => Math.min(wide(0), wide(1)));
    this.view = { scales, middle: [0, 1].map((axis) => low[axis] + span[axis] / 2), down: state.down };
    const corners = [[0, 0], this.size].flatMap((pixel) => this.toRaw(pixel));
    this.drawable = [...scales, ...corners].every(Number.isFinite) && scales.every((scale) => scale > 0);
    byId("picture-fault").textContent = this.drawable ? "" : noPicture;
  }

  toPixel([x, y]) {
    const { scales, middle, down } = this.view;
    const [width, height] = this.size;
    const pixel = [width / 2 + (x - middle[0]) * scales[0], height / 2 + (down ? 1 : -1) * (y - middle[1]) * scales[1]];
    return pixel.map((v) => Math.min(farthest, Math.max(-farthest, v)));
  }

  // The place at a pixel, rounded to the decimals that a pixel tells.
  toPlace(pixel) {
    const decimals = (axis) => Math.max(0, Math.ceil(Math.log10(this.view.scales[axis])));
    return this.toRaw(pixel).map((value, axis) => (decimals(axis) > 100 ? value : Number(value.toFixed(decimals(axis)))));
  }

  footPlace({ curve, foot, t }) { return curve.dimension === 1 ? [t, foot[0]] : foot.slice(0, 2); }

  line(places, closed = false) {
    return places.map((p, k) => `${k ? "L" : "M"}${this.toPixel(p).map((v) => v.toFixed(2)).join(",")}`).join("") + (closed ? "Z" : "");
  }

  // The scale stays as it is, unless `refit`.
  show(state, overlay = {}, refit = false) {
    Object.assign(this, { state, overlay });
    if (refit || !this.drawable) this.fit(state);
    if (!this.drawable) {
      for (const layer of Object.values(this.layers)) layer.replaceChildren();
      this.handles.clear();
      return;
    }
    const { curve, t } = state;
    const { grid, polygon, curve: drawn, under, over } = this.layers;
    const marks = Array.from({ length: degreeOf(curve) + 1 }, (_, i) => markOf(curve, i));
    grid.replaceChildren(...this.rules());
    polygon.replaceChildren(...(curve.form === "power" ? [] : [make("path", { d: this.line(marks) })]));
    drawn.replaceChildren(make("path", { d: this.line(lineOf(curve)) }));
    under.replaceChildren(...this.drawn(overlay.under ?? []));
    const at = placeOf(curve, t);
    const dot = at.every(Number.isFinite) ? this.drawn([{ dot: at, class: "at" }]) : [];
    over.replaceChildren(...this.drawn(overlay.over ?? []), ...dot);
    this.showHandles(state, marks);
  }

  // What a view adds: { line: places, closed } and { dot: place }, each with a class.
  drawn(parts) {
    return parts.map(({ line, closed, dot, class: name }) => {
      if (line) return make("path", { d: this.line(line, closed), class: name });
      const [cx, cy] = this.toPixel(dot);
      return make("circle", { cx, cy, r: name === "at" ? 6 : 3, class: name });
    });
  }

  // Lines at round numbers, about ninety pixels apart.
  rules() {
    const [width, height] = this.size;
    const corners = [[0, height], [width, 0]].map((pixel) => this.toRaw(pixel));
    return [0, 1].flatMap((axis) => {
      const [low, high] = corners.map((corner) => corner[axis]).sort((a, b) => a - b);
      const rough = 90 / this.view.scales[axis];
      const power = 10 ** Math.floor(Math.log10(rough));
      const step = [1, 2, 5, 10].map((factor) => factor * power).find((value) => value >= rough);
      const marks = [];
      for (let k = Math.ceil(low / step); k * step <= Math.min(high, Number.MAX_VALUE) && marks.length < 60; k += 1) {
        const value = Number((k * step).toPrecision(12));
        const [x, y] = this.toPixel(axis ? [0, value] : [value, 0]);
        const label = String(value);
        marks.push(make("line", axis ? { x1: 0, x2: width, y1: y, y2: y } : { x1: x, x2: x, y1: 0, y2: height }));
        marks.push(make("text", axis ? { x: 4, y: y - 3 } : { x: x + 3, y: height - 5 }, label));
      }
      return marks;
    });
  }

  toRaw([left, top]) {
    const { scales, middle, down } = this.view;
    const [width, height] = this.size;
    return [middle[0] + (left - width / 2) / scales[0], middle[1] + ((down ? 1 : -1) * (top - height / 2)) / scales[1]];
  }

  showHandles(state, marks) {
    const wanted = new Map();
    if (state.curve.form !== "power") marks.forEach((place, i) => wanted.set(i, place));
    if (state.view === "nearest" && state.foot) wanted.set("foot", this.footPlace(state));
    for (const [what, handle] of this.handles) if (!wanted.has(what)) { handle.remove(); this.handles.delete(what); }
    for (const [what, place] of wanted) {
      if (!this.handles.has(what)) this.handles.set(what, this.layers.handles.appendChild(this.handle(what)));
      const handle = this.handles.get(what);
      handle.setAttribute("transform", `translate(${this.toPixel(place).join(",")})`);
      const name = what === "foot" ? "Point to be near to" : `Control point ${what}`;
      handle.setAttribute("aria-label", `${name}, ${place.map(text).join(", ")}. Arrow keys move it.`);
    }
  }

  handle(what) {
    const handle = make("g", { class: what === "foot" ? "handle foot" : "handle", tabindex: 0, role: "button", "aria-roledescription": "movable point" },
      make("circle", { r: 15, class: "reach" }), make("circle", { r: 6, class: "mark" }));
    const pixelOf = (event) => {
      const box = this.svg.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    let held = null;
    handle.addEventListener("pointerdown", (event) => {
      if (event.button) return;
      const [x, y] = this.toPixel(what === "foot" ? this.footPlace(this.state) : markOf(this.state.curve, what));
      const [left, top] = pixelOf(event);
      held = [x - left, y - top];
      handle.setPointerCapture(event.pointerId);
    });
    const to = (event) => this.toPlace(pixelOf(event).map((v, axis) => v + held[axis]));
    handle.addEventListener("pointermove", (event) => { if (held) this.moved(what, to(event), false); });
    handle.addEventListener("pointerup", (event) => {
      if (held) this.moved(what, to(event), true);
      held = null;
    });
    handle.addEventListener("pointercancel", () => { held = null; });
    handle.addEventListener("keydown", (event) => {
      const step = arrows[event.key];
      if (!step) return;
      event.preventDefault();
      const [x, y] = this.toPixel(what === "foot" ? this.footPlace(this.state) : markOf(this.state.curve, what));
      const factor = event.shiftKey ? 10 : 1;
      this.moved(what, this.toPlace([x + factor * step[0], y + factor * step[1]]), true);
    });
    return handle;
  }
}

// All curves of a file, one of them marked; a press picks the nearest one.
export function overview(svg, curves, chosen, down, pick) {
  const lines = curves.map(({ curve }) => lineOf(curve, 12));
  const [low, high] = extentOf(lines.flat());
  const [width, height] = [320, 150];
  const scale = Math.min((width - 12) / (high[0] - low[0] || 1), (height - 12) / (high[1] - low[1] || 1));
  if (!(scale > 0 && scale < Infinity)) {
    svg.replaceChildren(make("text", { x: 6, y: 20 }, noPicture));
    svg.onclick = null;
    return;
  }
  const pixel = ([x, y]) => [width / 2 + (x - low[0] / 2 - high[0] / 2) * scale, height / 2 + (down ? 1 : -1) * (y - low[1] / 2 - high[1] / 2) * scale];
  const places = lines.map((line) => line.map(pixel));
  const data = (line) => line.map((p, k) => `${k ? "L" : "M"}${p.map((v) => v.toFixed(1)).join(",")}`).join("");
  svg.replaceChildren(make("path", { d: places.map(data).join("") }), ...places.slice(chosen, chosen + 1).map((line) => make("path", { d: data(line), class: "chosen" })));
  svg.onclick = (event) => {
    const box = svg.getBoundingClientRect();
    const at = [((event.clientX - box.left) * width) / box.width, ((event.clientY - box.top) * height) / box.height];
    const distances = places.map((line) => Math.min(...line.map(([x, y]) => Math.hypot(x - at[0], y - at[1]))));
    pick(distances.indexOf(Math.min(...distances)));
  };
}
