// The answer: a picker over the cells of the bundle, which ranks the methods and draws them, time against error.

const AXES = [["form", "form"], ["degree", "degree"], ["mode", "mode"], ["scalar", "scalar"], ["dimension", "axes"], ["where", "inputs"]];
const WORTH = new Map([["yes", "✓ not dominated"], ["unresolved", "? undecided"], ["no", "dominated"]]);

function useful(cell, one) {
  return one.error_u !== null && one.error_u * data.answer.roundoff[cell.scalar] <= data.answer.useless;
}

function chosenCell() {
  const { cells } = data.answer;
  let left = cells;
  for (const [axis] of AXES) {
    const asked = state.get(axis);
    const fits = left.filter((cell) => String(cell[axis]) === asked);
    const first = left.find((cell) => cell === cells[data.answer.first]) ?? left[0];
    left = fits.length ? fits : left.filter((cell) => cell[axis] === first[axis]);
  }
  return left[0];
}

// What is wrong with what stands in the field of the tolerance, in words; empty where nothing is.
function wrong(asked) {
  const written = /^\+?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(asked);
  if (!asked || (written && Number.isFinite(Number(asked)))) return "";
  const why = written ? "is above the largest number in double" : /^-[\d.]/.test(asked) ? "is negative" : /^\d+,\d+$/.test(asked) ? `has a comma; write ${asked.replace(",", ".")}` : "is not a number; write 5 or 1e-9";
  return `“${asked}” ${why}. Until then any error is accepted.`;
}

function tolerance() {
  const asked = state.get("tolerance") ?? "";
  return asked && !wrong(asked) ? Number(asked) : Infinity;
}

const inCoordinates = () => state.get("in") === "coordinate";

function observed(one) {
  return `observed errors of at most ${inCoordinates() ? `${general(one.error)} coordinate units` : `${general(one.error_u)} u p~`}`;
}

// In the order of the page, those with a small proved bound first; within a requested tolerance, the fastest first.
function ranked(cell) {
  const most = tolerance();
  const right = cell.methods.filter((one) => useful(cell, one) && (inCoordinates() ? one.error : one.error_u) <= most);
  const size = (one) => one.ns ?? one.error_u;
  return Number.isFinite(most) ? right.sort((a, b) => size(a) - size(b)) : right;
}

function provedSmall(cell, one) {
  return one.bound_u !== null && one.bound_u <= cell.small;
}

function lost(error) {
  if (!(error > data.answer.losing)) return "";
  const digits = Math.round(Math.log10(error));
  return `, loses ${digits} digit${digits === 1 ? "" : "s"}`;
}

function bounded(one) {
  const bound = inCoordinates() ? one.bound : one.bound_u;
  return bound !== null && bound <= tolerance();
}

// One unit in a sentence.
function sentence(cell, methods) {
  const unit = inCoordinates() ? "coordinate units" : "u p~";
  const asked = Number.isFinite(tolerance()) ? ` within ${general(tolerance())} ${unit}` : "";
  if (!methods.length) return `No method of this bundle has its errors${asked || " in a useful range"} here; the tables below list the largest errors of all methods.`;
  const [first] = methods;
  if (!asked && first.ns !== null) {
    const limit = inCoordinates() ? "small proved bound" : `proved bound of at most ${general(cell.small)} u p~`;
    const small = methods.filter((one) => provedSmall(cell, one));
    if (!small.length) return `No method has a ${limit} here; the table lists the other methods.`;
    const front = small.filter((one) => one.front === "yes");
    return `With a ${limit}, fastest first: ${(front.length ? front : small.slice(0, 1)).map((one) => `${one.method} (${general(one.ns)} ns, ${observed(one)})`).join(", ")}.`;
  }
  const time = first.ns === null ? "" : `, ${general(first.ns)} ns per point`;
  const proved = asked && bounded(first) ? "; its proved bound keeps the tolerance in these trials, too" : asked ? "; this is observed in the trials, not proved" : "";
  return `${first.ns === null ? "Smallest error" : "Fastest"}${asked}: ${first.method}${time}, ${observed(first)}${lost(first.error_u)}${proved}.`;
}

function fillTable(cell, methods) {
  const table = document.getElementById("answer-table");
  const timed = cell.mode !== data.answer.untimed;
  const td = (text, raw, mark) => make("td", { class: mark || false, "data-v": raw === null ? false : String(raw) }, text);
  for (const body of [...table.tBodies]) body.remove();
  table.append(...methods.map((one) => make("tbody", { class: "one", "data-key": one.method, hidden: !seen(one.method) },
    make("tr", {}, make("th", { class: "group", scope: "row" }, make("code", {}, ...one.method.split(/(?<=[_:])/).flatMap((part) => [part, make("wbr")]))),
      ...(timed ? [td(`${general(one.ns)} [${general(one.low)} – ${general(one.high)}]`, one.ns)] : []),
      td(general(one.error_u) + lost(one.error_u), one.error_u), td(general(one.bound_u), one.bound_u),
      ...(timed ? [td(WORTH.get(one.front) ?? "", one.front, one.front === "yes" && !lost(one.error_u) ? "inside" : "")] : [])))));
  const caption = table.querySelector("caption strong");
  const order = !timed ? "smallest error first" : Number.isFinite(tolerance()) ? "fastest first" : "those with a small proved bound first, those that lose digits last, then by time";
  caption.textContent = `Methods for ${cell.words}, ${order}`;
  table.querySelectorAll("thead th").forEach((head) => head.removeAttribute("aria-sort"));
}

const SHAPES = {
  o: (x, y) => `M${x - 4},${y}a4,4 0 1,0 8,0a4,4 0 1,0 -8,0`,
  s: (x, y) => `M${x - 4},${y - 4}h8v8h-8z`,
  "^": (x, y) => `M${x},${y - 5}l5,9h-10z`,
  v: (x, y) => `M${x},${y + 5}l5,-9h-10z`,
  D: (x, y) => `M${x},${y - 5}l5,5l-5,5l-5,-5z`,
};

function decades(low, high) {
  const marks = [];
  const wide = high / low > 30;
  for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); e += 1) {
    for (const lead of wide ? [1] : [1, 2, 5]) {
      const at = Number(`${lead}e${e}`);
      if (at >= low && at <= high) marks.push(at);
    }
  }
  const every = Math.ceil(marks.length / 8);
  return marks.filter((_, at) => at % every === 0);
}

function draw(cell, methods) {
  const element = document.getElementById("answer-figure");
  const shown = cell.methods.filter((one) => one.ns > 0 && one.error_u > 0 && useful(cell, one));
  if (!element || !shown.length) {
    element?.toggleAttribute("hidden", true);
    return;
  }
  element.hidden = false;
  const [width, height, left, bottom] = [640, 380, 64, 46];
  const span = (values) => [Math.min(...values) / 1.25, Math.max(...values) * 1.25];
  const [x0, x1] = span(shown.flatMap((one) => [one.low ?? one.ns, one.high ?? one.ns]));
  const [y0, y1] = span(shown.flatMap((one) => [one.error_u, one.bound_u > 0 && Number.isFinite(one.bound_u) ? one.bound_u : 1, 1]));
  const x = (v) => left + (width - left - 16) * Math.log(v / x0) / Math.log(x1 / x0);
  const y = (v) => height - bottom - (height - bottom - 12) * Math.log(v / y0) / Math.log(y1 / y0);
  const svg = make("svg:svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": `Time against error, ${cell.words}` });
  const text = (at, words, more = {}) => make("svg:text", { x: at[0], y: at[1], class: "ink", ...more }, words);
  const tick = (at) => (at >= 1e4 || at < 1e-3 ? at.toExponential().replace("e+", "e") : String(at));
  for (const at of decades(x0, x1)) svg.append(make("svg:path", { class: "rule", d: `M${x(at)},12V${height - bottom}` }), text([x(at), height - bottom + 16], tick(at), { "text-anchor": "middle" }));
  for (const at of decades(y0, y1)) svg.append(make("svg:path", { class: "rule", d: `M${left},${y(at)}H${width - 16}` }), text([left - 6, y(at) + 4], tick(at), { "text-anchor": "end" }));
  svg.append(text([(left + width) / 2, height - 8], "ns per point", { "text-anchor": "middle" }),
    text([0, 0], "largest observed error, u p~", { "text-anchor": "middle", transform: `translate(14,${(height - bottom) / 2}) rotate(-90)` }));
  const right = new Set(methods.map((one) => one.method));
  const some = !state.has("all.answer-figure");
  const series = shown.map((one, at) => {
    const words = `${general(one.ns)} ns, observed errors of at most ${general(one.error_u)} u p~${one.bound_u === null ? "" : `, bound ${general(one.bound_u)}`}`;
    const known = { name: one.method, methods: [one.method], colour: one.colour, leads: one.leads || !some, points: [[x(one.ns), y(one.error_u), words, one.replay]] };
    if (!known.leads) {
      svg.append(make("svg:g", { id: `answer-figure-s${at}-0`, class: "other" }, make("svg:path", { d: `M${x(one.ns)},${y(one.error_u)}h0.01` })));
      return known;
    }
    const { colour } = one;
    const group = make("svg:g", { id: `answer-figure-s${at}-0`, class: right.has(one.method) ? "" : "missed", stroke: colour },
      make("svg:path", { d: `M${x(one.low ?? one.ns)},${y(one.error_u)}H${x(one.high ?? one.ns)}`, "stroke-width": 2.2 }),
      make("svg:path", { d: SHAPES[one.shape](x(one.ns), y(one.error_u)), fill: one.front === "yes" ? colour : "none", "stroke-width": 1.4 }));
    if (one.bound_u > one.error_u) group.append(make("svg:path", { d: `M${x(one.ns)},${y(one.error_u)}V${y(one.bound_u)}`, "stroke-width": 0.8 }));
    svg.append(group);
    return known;
  });
  const leading = shown.filter((one) => one.leads).length;
  element.querySelector("svg").replaceWith(svg);
  element.querySelector("figcaption").firstChild.textContent = `Time against the largest observed error, ${cell.words}; the thin line upwards leads to the proved bound, filled marks are not dominated, faint ones miss the tolerance${some && leading < shown.length ? `, grey ones are not among the ${leading} leading` : ""}`;
  dressFigure(element, series, { more: leading < shown.length ? () => draw(chosenCell(), ranked(chosenCell())) : null, count: shown.length });
}

function showAnswer(rebuild = true) {
  const cell = chosenCell();
  const methods = ranked(cell);
  document.getElementById("answer-sentence").textContent = sentence(cell, methods);
  fillTable(cell, methods);
  draw(cell, methods);
  const narrowed = AXES.some(([axis]) => state.has(axis)) || Number.isFinite(tolerance());
  highlight(narrowed ? new Set(methods.filter((one) => one.front !== "no").map((one) => one.method)) : null);
  if (rebuild) picker(cell);
}

function picker(cell) {
  const place = document.getElementById("picker");
  const { cells } = data.answer;
  let left = cells;
  const controls = [];
  for (const [axis, label] of AXES) {
    const values = [...new Set(left.map((one) => one[axis]))].sort((a, b) => (typeof a === "number" ? a - b : 0));
    const words = (one) => (axis === "form" ? new Map(Object.entries(data.answer.forms)).get(one) ?? one : String(one));
    if (values.length > 1 || ["form", "degree", "mode"].includes(axis)) {
      controls.push(choice(label, values.map((one) => [String(one), words(one)]), String(cell[axis]), (chosen) => { remember(axis, chosen); showAnswer(); focusOn(label); }));
    }
    left = left.filter((one) => one[axis] === cell[axis]);
  }
  const fault = make("span", { id: "fault", class: "fault", role: "status" });
  const input = make("input", { inputmode: "decimal", size: 7, placeholder: "any", value: state.get("tolerance") ?? "", "aria-describedby": "fault", input: () => { remember("tolerance", input.value.trim()); check(); showAnswer(false); } });
  const check = () => {
    fault.textContent = wrong(input.value.trim());
    input.setAttribute("aria-invalid", String(fault.textContent !== ""));
  };
  check();
  controls.push(make("label", {}, "tolerance ", input), fault,
    choice("in", [["u", "u p~"], ["coordinate", "coordinate units"]], state.get("in") ?? "u", (chosen) => { remember("in", chosen === "u" ? "" : chosen); showAnswer(false); }));
  const form = make("form", { "aria-label": "What you evaluate", submit: (event) => event.preventDefault() }, ...controls);
  place.replaceChildren(form);
}

function focusOn(label) {
  [...document.querySelectorAll("#picker label")].find((one) => one.firstChild.textContent.trim() === label)?.querySelector("select, input").focus();
}
