// SPDX-License-Identifier: MIT
// The table of all methods that take the curve.

import { axes, text } from "./curve.mjs";
import { byId, make } from "./dom.mjs";

const manyUnits = 100; // of u p~: from here on a method loses digits

export function short(x) {
  if (x === null || x === undefined || Number.isNaN(x)) return "–";
  if (x === 0 || !Number.isFinite(x)) return x ? "∞" : "0";
  return Math.abs(x) >= 1e5 || Math.abs(x) < 1e-3 ? x.toExponential(1) : String(Number(x.toPrecision(3)));
}

export const percent = (share) => (share === null || share === undefined ? "–" : `${Number((100 * share).toPrecision(2))} %`);
// As the report counts them, and no more than the type has.
export const digitsLost = (u, float) => (u > manyUnits ? Math.min(float ? 7 : 16, Math.round(Math.log10(u))) : 0);
const plural = (count, noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;

// The digits of a value, those that the exact one does not have marked.
export function digits(value, exact) {
  const [given, right] = [text(value), text(exact)];
  if (given === right) return [given];
  let same = 0;
  while (same < given.length && given[same] === right[same]) same += 1;
  return same < given.length ? [given.slice(0, same), make("mark", {}, given.slice(same))] : [given];
}

// An id, which may break behind its marks.
export const codeOf = (id) => make("code", {}, ...id.split(/(?<=[_:])/).flatMap((part) => [make("wbr"), part]).slice(1));

const columns = [
  { key: "id", head: "method", of: (row) => row.id },
  { key: "u", head: "error, in\u00a0u\u00a0p~", of: (row) => row.u },
  { key: "ulp", head: "in\u00a0ulp", of: (row) => row.ulp },
  { key: "bound", head: "bound, in\u00a0u\u00a0p~", of: (row) => row.boundU },
  { key: "share", head: "not nearest", of: (row) => row.share },
];

// Numbers first, what is unknown last; without a share the error decides.
function compare(a, b) {
  if (a === b) return 0;
  if (typeof a === "string") return a < b ? -1 : 1;
  const known = (v) => typeof v === "number" && !Number.isNaN(v);
  if (!known(a) || !known(b)) return known(b) - known(a);
  return a - b;
}

export class MethodTable {
  constructor(table) {
    Object.assign(this, { table, rows: new Map(), shares: new Map(), order: { key: "share", descending: false } });
    this.body = table.tBodies[0];
  }

  head(dimension) {
    if (this.dimension === dimension) return;
    this.dimension = dimension;
    const sorted = columns.map(({ key, head }) => make("th", { scope: "col", "data-key": key, class: key === "id" ? "label" : key },
      make("button", { type: "button", class: "sort", click: () => this.sort(key) }, head)));
    const values = axes.slice(0, dimension).map((axis) => make("th", { scope: "col" }, axis));
    this.table.tHead.replaceChildren(make("tr", {}, ...sorted, ...values));
  }

  sort(key) {
    this.order = { key, descending: this.order.key === key && !this.order.descending };
    this.arrange();
  }

  forget() {
    this.shares.clear();
    this.unshared = false;
  }
  refuseShares() {
    this.unshared = true;
    for (const row of this.rows.values()) this.fillShare(row);
  }
  share(id, share) {
    this.shares.set(id, share);
    const row = this.rows.get(id);
    if (row) this.fillShare(row);
  }

  fillShare(row) {
    row.share = this.unshared ? null : this.shares.get(row.id);
    row.cells.share.textContent = row.share === undefined ? "…" : percent(row.share);
    row.cells.share.dataset.v = row.share ?? "";
  }

  row({ id, label, fused }, recommended) {
    const badges = [...(recommended ? [make("b", { class: "badge good" }, "recommended")] : []), ...(fused ? [make("b", { class: "badge" }, "fused")] : [])];
    const cells = { name: make("th", { scope: "row" }, codeOf(id), ...badges, make("small", {}, label)) };
    for (const { key } of columns.slice(1)) cells[key] = make("td", { class: key });
    cells.values = Array.from({ length: this.dimension }, () => make("td", { class: "digits" }));
    const element = make("tr", { "data-id": id, class: recommended && "recommended" }, cells.name, ...columns.slice(1).map(({ key }) => cells[key]), ...cells.values);
    return { id, element, cells };
  }

  // Where there is no answer.
  clear() {
    this.ids = this.exact = undefined;
    this.rows.clear();
    this.body.replaceChildren();
    byId("verdict").textContent = "";
  }

  // Fills the table with the answer to `points`.
  show(answer, dimension, float) {
    this.head(dimension);
    const ids = [...answer.rows.map((row) => row.id), dimension, answer.recommended].join(" ");
    if (this.ids !== ids) {
      this.ids = ids;
      this.recommended = answer.recommended;
      this.rows = new Map(answer.rows.map((one) => [one.id, this.row(one, one.id === answer.recommended)]));
      this.exact = make("tr", { class: "exact" }, make("th", { scope: "row" }, "true point, rounded once"), ...columns.slice(1).map(() => make("td")),
        ...answer.exact.map(() => make("td", { class: "digits" })));
    }
    answer.exact.forEach((value, axis) => {
      const cell = this.exact.cells[columns.length + axis];
      cell.textContent = text(value);
      cell.dataset.v = text(value);
    });
    for (const given of answer.rows) this.fill(this.rows.get(given.id), given, answer.exact, float);
    this.arrange();
    byId("verdict").textContent = this.verdict(answer);
  }

  fill(row, given, exact, float) {
    const { cells } = row;
    row.fault = given.fault;
    row.u = given.fault ? NaN : Math.max(...given.errors.map((one) => one.u));
    row.ulp = given.fault ? NaN : Math.max(...given.errors.map((one) => one.ulp));
    row.boundU = given.bound ? Math.max(...given.bound.map((one) => one.u)) : null;
    row.nearest = !given.fault && given.values.every((value, axis) => value === exact[axis]);
    row.lost = row.nearest ? 0 : digitsLost(row.u, float); // beside subnormal numbers u p~ is far below an ulp
    row.element.classList.toggle("losing", row.lost > 0);
    cells.u.replaceChildren(given.fault ? make("small", { class: "fault" }, given.fault) : short(row.u),
      ...(row.lost ? [make("small", {}, ` loses ${plural(row.lost, "digit")}`)] : []));
    cells.u.style.setProperty("--bar", `${row.u > 0 ? Math.min(100, Math.max(2, 100 * ((Math.log10(row.u) + 2) / 10))) : 0}%`);
    cells.ulp.textContent = given.fault ? "" : short(row.ulp);
    cells.bound.textContent = given.fault ? "" : !given.bound ? "none" : Number.isFinite(row.boundU) ? short(row.boundU) : "none here";
    cells.bound.title = given.boundText ?? "";
    const all = (list) => (list ?? []).map((one) => text(one.u)).join(" ");
    cells.u.dataset.v = all(given.errors);
    cells.ulp.dataset.v = (given.errors ?? []).map((one) => text(one.ulp)).join(" ");
    cells.bound.dataset.v = all(given.bound);
    cells.values.forEach((cell, axis) => {
      if (!given.fault && cell.dataset.v === text(given.values[axis]) && cell.dataset.exact === text(exact[axis])) return;
      cell.dataset.exact = text(exact[axis]);
      cell.replaceChildren(...(given.fault ? [] : digits(given.values[axis], exact[axis])));
      cell.dataset.v = given.fault ? "" : text(given.values[axis]);
    });
    this.fillShare(row);
  }

  arrange() {
    const { key, descending } = this.order;
    for (const head of this.table.tHead.querySelectorAll("[data-key]")) {
      if (head.dataset.key === key) head.setAttribute("aria-sort", descending ? "descending" : "ascending");
      else head.removeAttribute("aria-sort");
    }
    const { of } = columns.find((column) => column.key === key);
    const sorted = [...this.rows.values()].sort((a, b) => (descending ? compare(of(b), of(a)) : compare(of(a), of(b))) || compare(a.u, b.u));
    const first = this.rows.get(this.recommended);
    const wanted = [this.exact, ...[...(first ? [first] : []), ...sorted.filter((row) => row !== first)].map((row) => row.element)];
    if (wanted.some((element, k) => this.body.children[k] !== element)) this.body.replaceChildren(...wanted.filter(Boolean));
  }

  verdict({ rows, recommended }) {
    const all = [...this.rows.values()];
    const nearest = all.filter((row) => row.nearest).length;
    const losing = all.filter((row) => row.lost).length;
    const best = this.rows.get(recommended);
    const bound = !Number.isFinite(best?.boundU) ? "" : `; at most ${short(best.boundU)} is proved`;
    const advice = best && !best.fault ? ` Recommended for any curve, without fused steps: ${recommended}, with an error of ${short(best.u)} u p~ here${bound}.` : "";
    return `${nearest} of ${plural(rows.length, "method")} give the nearest numbers here; ${losing || "none"} lose${losing === 1 ? "s" : ""} digits.${advice}`;
  }
}
