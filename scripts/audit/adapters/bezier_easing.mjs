// SPDX-License-Identifier: MIT
// Arguments: the package, and how it is loaded, "import" or "require"; 3.2.0 has another solver for each.
import { createRequire } from "node:module";
import { serve } from "./serve.mjs";

const [, , name, how] = process.argv;
const loaded = how === "require" ? createRequire(import.meta.url)(name) : await import(name);
const bezier = loaded.default ?? loaded;
const easing = (control) => bezier(...control.slice(2, 6));

serve({
  easing: (control, [x]) => [easing(control)(x)],
  // How often it goes back by more than rounding in so many equal steps, the step that goes back most, and the values on both sides of it.
  monotone: (control, [steps, rounding]) => {
    const value = easing(control);
    let [count, worst, before, after] = [0, 0, 0, 0];
    for (let k = 1, last = value(0); k <= steps; ++k) {
      const next = value(k / steps);
      if (last - next > rounding) ++count;
      if (last - next > before - after) [worst, before, after] = [k, last, next];
      last = next;
    }
    return [count, worst, before, after];
  },
});
