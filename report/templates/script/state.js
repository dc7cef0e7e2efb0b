// The state of the page: what is chosen in any control, kept in the address as #place?key=value, so that a link brings it back.

const data = JSON.parse(document.getElementById("page-data").textContent);
const state = new Map();
let place = "";

function readAddress() {
  const [anchor, query = ""] = location.hash.slice(1).split("?");
  place = anchor;
  state.clear();
  for (const [key, value] of new URLSearchParams(query)) state.set(key, value);
}

function remember(key, value) {
  if (value) state.set(key, value);
  else state.delete(key);
  const query = new URLSearchParams([...state]).toString();
  history.replaceState(null, "", `#${place}${query ? `?${query}` : ""}`);
}

// An element with attributes and children; texts become text nodes, so nothing that a bundle says is markup.
function make(tag, attributes = {}, ...children) {
  const element = tag.includes(":") ? document.createElementNS("http://www.w3.org/2000/svg", tag.slice(4)) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value !== false && value !== undefined) element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children);
  return element;
}

const said = make("p", { id: "said", role: "status", "aria-live": "polite" });

function say(text) {
  said.textContent = text;
}

async function copy(text, what) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = make("textarea", { readonly: true, class: "unseen" });
    area.value = text;
    document.body.append(area);
    area.select();
    const copied = document.execCommand("copy");
    area.remove();
    if (!copied) return say(`Could not copy; here it is: ${text}`);
  }
  say(`Copied ${what}`);
}

function choice(label, values, chosen, change) {
  const select = make("select", { change: () => change(select.value) },
    ...values.map(([value, text]) => make("option", { value, selected: value === chosen }, text)));
  return make("label", {}, `${label} `, select);
}

// A number of ordinary size with three significant digits, as the tables write it.
function general(value, digits = 3) {
  if (value === null || value === undefined || Number.isNaN(value)) return value === null || value === undefined ? "" : "nan";
  if (!Number.isFinite(value)) return value < 0 ? "-inf" : "inf";
  if (Number.isInteger(value) && Math.abs(value) < 1e6) return String(value);
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 10 ** digits) return value.toFixed(Math.max(digits - 1 - Math.floor(Math.log10(size)), 0));
  if (size >= 1e-3 && size < 1e4) return value.toFixed(0);
  return value.toExponential(digits - 1).replace("e+", "e");
}
