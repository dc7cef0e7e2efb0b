// SPDX-License-Identifier: MIT
import { svgPathProperties } from "svg-path-properties";
import { serve } from "./serve.mjs";

const path = ([x, y, ...others]) => new svgPathProperties(`M${x},${y}${others.length === 4 ? "Q" : "C"}${others.join(",")}`);

serve({
  length: (control) => [path(control).getTotalLength()],
  at_length: (control, [length]) => {
    const { x, y } = path(control).getPointAtLength(length);
    return [x, y];
  },
});
