// SPDX-License-Identifier: MIT
// Elements in one call.

const drawn = new Set(["svg", "g", "path", "circle", "line", "rect", "text", "title"]);

// An element with attributes (functions are listeners, undefined and false leave one out) and children.
export function make(name, attributes = {}, ...children) {
  const element = drawn.has(name) ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(key, value);
    else if (value !== undefined && value !== false) element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children);
  return element;
}

export const byId = (id) => document.getElementById(id);

// Calls `action` once, `wait` ms after the last call.
export function late(action, wait) {
  let timer;
  const later = (...given) => {
    later.cancel();
    timer = setTimeout(() => action(...given), wait);
  };
  later.cancel = () => clearTimeout(timer);
  return later;
}

// Says a sentence to everybody, to screen readers too.
const quiet = late(() => { byId("said").textContent = ""; }, 4000);
export function say(sentence) {
  byId("said").textContent = sentence;
  quiet();
}

export async function copy(words, what) {
  try {
    await navigator.clipboard.writeText(words);
    say(`${what} copied.`);
  } catch {
    say(`The browser does not allow copying; select ${what.toLowerCase()} and press Ctrl+C.`);
  }
}
