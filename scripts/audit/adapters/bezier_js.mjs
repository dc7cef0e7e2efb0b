// SPDX-License-Identifier: MIT
import { Bezier } from "bezier-js";
import { serve } from "./serve.mjs";

const flat = (points) => points.flatMap(({ x, y }) => [x, y]);

serve({
  length: (control) => [new Bezier(control).length()],
  point: (control, [t]) => flat([new Bezier(control).get(t)]),
  split: (control, [t]) => {
    const { left, right } = new Bezier(control).split(t);
    return [...flat(left.points), ...flat(right.points)];
  },
  nearest: (control, [x, y]) => {
    const foot = new Bezier(control).project({ x, y });
    return [foot.t, foot.d];
  },
});
