// Tables: sort by a column, filter by method and family, another unit, copy.

const UNITS = [["u", "u p~"], ["coordinate", "coordinate units"], ["ulp", "ulp"], ["relative", "relative"], ["size", "size of the curve"]];
const roots = new Map(Object.entries(data.roots)); // ids are a bundle's: one may be called "constructor"
const tables = [...document.querySelectorAll("main table")];
const methodTables = tables.filter((table) => table.dataset.rows === "methods");

function family(method) {
  const conversion = method.slice(0, method.lastIndexOf(":"));
  if (conversion) return `via ${conversion}`;
  return method.startsWith("compensated_") ? "compensated" : method.startsWith("peer_") ? "other libraries" : roots.get(method) ?? method;
}

function seen(method) {
  const words = (state.get("method") ?? "").toLowerCase().split(/[\s,]+/).filter(Boolean);
  const wanted = state.get("family");
  return (!wanted || family(method) === wanted) && (!words.length || words.some((word) => method.toLowerCase().includes(word)));
}

function filterTables() {
  const known = new Map();
  let left = 0;
  for (const table of methodTables) {
    for (const body of table.tBodies) {
      const method = body.dataset.key;
      if (!known.has(method)) known.set(method, seen(method));
      body.hidden = !known.get(method);
      left += known.get(method) ? 1 : 0;
    }
  }
  return left;
}

function number(text) {
  const found = /[-+]?(?:\d[\d,]*\.?\d*(?:e[-+]?\d+)?|inf)/i.exec(text);
  return found ? Number(found[0].replace(/,/g, "").replace(/inf/i, "Infinity")) : NaN;
}

function value(cell) {
  return cell.dataset.v ?? cell.textContent;
}

// The cell of a group in a column of the head: of the line with that label, or of the first line.
function cellOf(body, column, line, labels) {
  const row = [...body.rows].find((one) => line && one.querySelector("th:not(.group)")?.textContent === line) ?? body.rows[0];
  if (column < labels) return row.cells[column];
  return [...row.cells].filter((cell) => cell.tagName === "TD")[column - labels];
}

function sortTable(table, column, direction, line) {
  const labels = table.querySelectorAll("thead th[data-label]").length;
  const bodies = [...table.tBodies];
  bodies.forEach((body, at) => { body.dataset.at ??= at; });
  const keys = new Map(bodies.map((body) => {
    const cell = cellOf(body, column, line, labels);
    const text = cell ? value(cell) : "";
    return [body, [number(text), text]];
  }));
  bodies.sort((a, b) => {
    if (!direction) return a.dataset.at - b.dataset.at;
    const [x, xText] = keys.get(a);
    const [y, yText] = keys.get(b);
    if (column < labels || (Number.isNaN(x) && Number.isNaN(y))) return direction * xText.localeCompare(yText, "en", { numeric: true });
    return Number.isNaN(x) ? 1 : Number.isNaN(y) ? -1 : direction * (x - y) || a.dataset.at - b.dataset.at;
  });
  const fragment = document.createDocumentFragment();
  for (const body of bodies) fragment.append(body);
  table.append(fragment);
  table.querySelectorAll("thead th").forEach((head, at) => {
    if (direction && at === column) head.setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
    else head.removeAttribute("aria-sort");
  });
}

function makeSortable(table) {
  const heads = [...table.querySelectorAll("thead th")];
  const lines = [...new Set([...table.tBodies].slice(0, 50).flatMap((body) => [...body.rows].map((row) => row.querySelector("th:not(.group)")?.textContent ?? "")))];
  let line = "";
  let sorted = [0, 0];
  const apply = () => {
    sortTable(table, ...sorted, line);
    remember(`sort.${table.id}`, sorted[1] ? [...sorted, line].join("_") : "");
  };
  heads.forEach((head, column) => {
    const button = make("button", { type: "button", class: "sort", click: () => {
      const again = sorted[0] === column && sorted[1];
      sorted = [column, again === 1 ? -1 : again === -1 ? 0 : 1];
      apply();
      say(`${head.textContent.trim()}: ${sorted[1] > 0 ? "ascending" : sorted[1] < 0 ? "descending" : "as it was"}`);
    } }, ...head.childNodes);
    head.append(button);
  });
  const kept = state.get(`sort.${table.id}`);
  if (kept) {
    const [column, direction, ...rest] = kept.split("_");
    [sorted, line] = [[Number(column), Number(direction)], rest.join("_")];
    if (sorted[0] < heads.length) sortTable(table, ...sorted, line);
  }
  return lines.length > 1 ? choice("sort by line", lines.map((one) => [one, one]), line || lines[0], (chosen) => { line = chosen; if (sorted[1]) apply(); }) : "";
}

// The table as it is shown: rows in their order, hidden ones left out; every digit where there are more than are shown.
function grid(table, exact) {
  const text = (cell) => (exact ? value(cell) : cell.textContent).trim();
  const rows = [[...table.querySelectorAll("thead th")].map((head) => head.textContent.trim())];
  for (const body of table.tBodies) {
    if (body.hidden) continue;
    const group = exact ? body.dataset.key : body.querySelector("th").textContent.trim();
    for (const row of body.rows) rows.push([group, ...[...row.cells].filter((cell) => !cell.classList.contains("group")).map(text)]);
  }
  return rows;
}

const WRITERS = {
  CSV: (table) => grid(table, true).map((row) => row.map((field) => (/[",\n]/.test(field) ? `"${field.replace(/"/g, '""')}"` : field)).join(",")).join("\n"),
  Markdown: (table) => {
    const [head, ...rows] = grid(table, false).map((row) => `| ${row.map((field) => field.replace(/[\\|*_`<[\]]/g, "\\$&")).join(" | ")} |`);
    return [head, `|${" --- |".repeat(table.querySelectorAll("thead th").length)}`, ...rows].join("\n");
  },
  LaTeX: (table) => {
    const plain = { "\\": "\\textbackslash{}", "~": "\\textasciitilde{}", "^": "\\textasciicircum{}", "<": "\\textless{}", ">": "\\textgreater{}", "–": "--", "≤": "$\\le$", "✓": "", "✗": "", "µ": "\\textmu{}" };
    const write = (field) => field.replace(/[\\~^<>–≤✓✗µ]|[&%$#_{}]/g, (found) => plain[found] ?? `\\${found}`);
    const rows = grid(table, false);
    return [`\\begin{tabular}{l${"r".repeat(rows[0].length - 1)}}`, "\\hline", ...rows.map((row, at) => `${row.map(write).join(" & ")} \\\\${at ? "" : "\n\\hline"}`), "\\hline", "\\end{tabular}"].join("\n");
  },
};

function showUnit(table, unit) {
  for (const cell of table.querySelectorAll("td[data-coordinate], td[data-ulp], td[data-relative], td[data-size]")) {
    cell.dataset.text ??= cell.textContent;
    cell.dataset.first ??= value(cell);
    const raw = unit === "u" ? cell.dataset.first : cell.dataset[unit] ?? "";
    cell.dataset.v = raw;
    cell.textContent = unit === "u" ? cell.dataset.text : raw;
  }
  const caption = table.querySelector("caption strong");
  caption.dataset.text ??= caption.textContent;
  const words = { coordinate: "in coordinate units", ulp: "in ulp", relative: "relative to the value", size: "over the size of the curve" };
  caption.textContent = caption.dataset.text.replace(/over u\sp~/, (found) => (unit === "u" ? found : words[unit]));
}

const withUnits = tables.filter((table) => table.dataset.units !== undefined);
const ready = new Set();

function showUnits() {
  const unit = UNITS.some(([id]) => id === state.get("unit")) ? state.get("unit") : "u";
  for (const table of withUnits) if (ready.has(table)) showUnit(table, unit);
}

// Controls come to a table when it comes near the window: a page may have a thousand of them.
function dress(table) {
  if (ready.has(table)) return;
  ready.add(table);
  const lines = makeSortable(table);
  const buttons = Object.entries(WRITERS).map(([name, write]) => make("button", { type: "button", click: () => copy(write(table), `the table as ${name}`) }, name));
  table.closest(".scroll").before(make("div", { class: "tools", role: "group", "aria-label": "Table" }, lines, make("span", {}, "copy "), ...buttons));
  if (table.dataset.units !== undefined && state.get("unit")) showUnits();
}

function viewBar() {
  const methods = [...new Set(methodTables.flatMap((table) => [...table.tBodies].map((body) => body.dataset.key)))];
  if (!methods.length) return;
  const families = [...new Set(methods.map(family))].sort();
  let waiting = 0;
  const refresh = () => {
    clearTimeout(waiting);
    waiting = setTimeout(() => {
      const rows = filterTables();
      say(`${rows} rows of methods shown`);
      none.textContent = rows ? "" : "No method fits.";
      showFigures();
    }, 120);
  };
  const none = make("span", { class: "fault", role: "status" });
  const input = make("input", { type: "search", size: 16, placeholder: "part of an id", value: state.get("method") ?? "", input: () => { remember("method", input.value.trim()); refresh(); } });
  const bar = make("form", { id: "view", role: "search", "aria-label": "What tables and figures show", submit: (event) => event.preventDefault() },
    make("label", {}, "method ", input),
    choice("family", [["", "all"], ...families.map((one) => [one, one])], state.get("family") ?? "", (chosen) => { remember("family", chosen); refresh(); }), none);
  if (withUnits.length) bar.append(choice("errors in", UNITS, state.get("unit") ?? "u", (chosen) => { remember("unit", chosen === "u" ? "" : chosen); showUnits(); }));
  const answer = document.getElementById("answer") ?? document.getElementById("opening");
  if (answer) answer.closest("section").after(bar);
  else document.querySelector("main").prepend(bar);
  if (state.get("method") || state.get("family")) filterTables();
}
