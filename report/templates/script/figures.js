// Figures: the values under the pointer or, with the arrow keys, one after the other; a legend that isolates; all methods where a figure
// shows the leading ones; replay commands.

const figures = new Map(); // id: { svg, series, chosen }
const tip = make("div", { class: "tip", hidden: true });

function command(replay) {
  return `bezierbench replay ${data.bundle} ${replay}`;
}

function shownSeries(figure) {
  return figure.series.filter((one) => (figure.chosen.size ? figure.chosen.has(one.name) : !figure.missed) && (!one.methods.length || one.methods.some(seen)));
}

const few = (figure) => Boolean(figure.more) && !state.has(`all.${figure.id}`);

function showFigure(figure) {
  const shown = new Set(shownSeries(figure).map((one) => one.name));
  figure.series.forEach((one, at) => {
    for (const mark of figure.svg.querySelectorAll(`[id^="${figure.prefix}-s${at}-"]`)) mark.classList.toggle("dim", !shown.has(one.name));
  });
  figure.element.classList.toggle("none", !shown.size);
  figure.none.textContent = shown.size ? "" : `${figure.missed ? "The answer" : "The filter"} leaves no method of this figure.`;
  for (const button of figure.legend?.querySelectorAll("button") ?? []) button.setAttribute("aria-pressed", String(figure.chosen.has(button.dataset.name)));
}

function showFigures() {
  for (const figure of figures.values()) showFigure(figure);
}

function isolate(figure, name) {
  figure.missed = false;
  if (!figure.chosen.delete(name)) figure.chosen.add(name);
  remember(`only.${figure.id}`, [...figure.chosen].join("|"));
  showFigure(figure);
}

// Shows the methods of the answer alone, which may be none; all where it is null.
function highlight(methods) {
  for (const figure of figures.values()) {
    if (!figure.follows) continue;
    figure.chosen = new Set(figure.series.filter((one) => one.methods.some((method) => methods?.has(method))).map((one) => one.name));
    figure.missed = methods !== null && !figure.chosen.size; // the answer has none of this figure
    showFigure(figure);
  }
}

function points(figure) {
  return shownSeries(figure).flatMap((one) => one.points.map(([x, y, text, replay]) => ({ x, y, replay, text: `${one.name}: ${text}` })));
}

function onScreen(figure, point) {
  const matrix = figure.svg.getScreenCTM();
  return [matrix.a * point.x + matrix.e, matrix.d * point.y + matrix.f];
}

function showTip(figure, point) {
  const [x, y] = onScreen(figure, point);
  tip.replaceChildren(make("span", {}, point.text));
  if (point.replay) tip.append(make("code", {}, command(point.replay)), make("small", {}, "click or Enter copies the command"));
  tip.hidden = false;
  const box = tip.getBoundingClientRect();
  tip.style.left = `${Math.max(4, Math.min(x + 12, innerWidth - box.width - 4))}px`;
  tip.style.top = `${y + 16 + box.height > innerHeight ? y - box.height - 12 : y + 16}px`;
  figure.at = point;
}

function nearest(figure, event) {
  let found = null;
  let least = 28 ** 2;
  for (const point of points(figure)) {
    const [x, y] = onScreen(figure, point);
    const distance = (x - event.clientX) ** 2 + (y - event.clientY) ** 2;
    if (distance < least) [found, least] = [point, distance];
  }
  return found;
}

function take(figure) {
  if (figure.at) copy(figure.at.replay ? command(figure.at.replay) : figure.at.text, figure.at.replay ? "the replay command" : "the values");
}

function step(figure, event) {
  const moves = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };
  if (event.key === "Enter" && figure.at) return take(figure);
  if (event.key === "Escape") { tip.hidden = true; return undefined; }
  if (!(event.key in moves)) return undefined;
  event.preventDefault();
  const all = points(figure);
  if (!all.length) return undefined;
  const at = figure.at ? all.findIndex((one) => one.text === figure.at.text) : -1;
  const next = all[(at + moves[event.key] + all.length) % all.length];
  showTip(figure, next);
  return say(next.text);
}

// All methods of a figure that shows some, or those again. `more` shows the others: a template has them, or what has drawn the figure draws them.
function toggleAll(id) {
  const { more } = figures.get(id);
  remember(`all.${id}`, state.has(`all.${id}`) ? "" : "1");
  more();
}

function dressDrawn(element, follows) {
  const template = element.querySelector("template");
  const first = element.querySelector("svg");
  const whole = template?.content.querySelector("svg");
  const show = () => {
    const all = whole && state.has(`all.${element.id}`);
    element.querySelector("svg").replaceWith(all ? whole : first);
    dressFigure(element, data.figures[`${element.id}${all ? "-all" : ""}`], { follows, prefix: `${element.id}${all ? "-all" : ""}`, more: whole && show });
  };
  show();
}

function dressFigure(element, series, { follows = false, prefix = element.id, more = null, count = new Set(data.figures[`${element.id}-all`]?.flatMap((one) => one.methods)).size } = {}) {
  const svg = element.querySelector("svg");
  const id = element.id;
  const known = figures.get(id);
  known?.legend.remove();
  const figure = { id, element, svg, series, follows, prefix, more, at: null, missed: Boolean(known?.missed), chosen: new Set((state.get(`only.${id}`) ?? "").split("|").filter((name) => series.some((one) => one.name === name))) };
  figures.set(id, figure);
  element.classList.toggle("whole", Boolean(more) && !few(figure));
  figure.none = make("span", { class: "fault", role: "status" });
  figure.legend = make("div", { class: "legend", role: "group", "aria-label": "Show only" },
    ...(series.length > 1 ? series.filter((one) => one.leads !== false).map((one) => make("button", { type: "button", "data-name": one.name, "aria-pressed": "false", click: () => isolate(figure, one.name) },
      make("i", { style: `background:${one.colour}` }), one.name)) : []),
    ...(more ? [make("button", { type: "button", class: "all", click: () => { toggleAll(id); figures.get(id).legend.querySelector(".all").focus(); } }, few(figure) ? `show all ${count}` : "show the leading ones")] : []),
    figure.none);
  svg.after(figure.legend);
  if (!known) {
    const current = () => figures.get(id);
    element.addEventListener("pointermove", (event) => {
      if (!(event.target instanceof SVGElement)) return;
      const point = nearest(current(), event);
      if (point) showTip(current(), point);
      else tip.hidden = true;
    });
    element.addEventListener("pointerleave", () => { tip.hidden = true; });
    element.addEventListener("click", (event) => {
      const point = event.target instanceof SVGElement && nearest(current(), event);
      if (point) { showTip(current(), point); take(current()); }
    });
    element.addEventListener("keydown", (event) => { if (event.target === element) step(current(), event); });
    element.addEventListener("focus", () => { if (element.matches(":focus-visible")) step(current(), { key: "ArrowRight", preventDefault() {} }); });
    element.addEventListener("blur", () => { tip.hidden = true; });
    element.setAttribute("aria-description", "Arrow keys read the points, Enter copies");
  }
  showFigure(figure);
}
