// SPDX-License-Identifier: MIT
import paper from "paper/dist/paper-core.js";
import { serve } from "./serve.mjs";

const { Curve, Point } = paper;
paper.setup();

// A curve as users make it: by its ends and the handles relative to them.
const curve = ([x0, y0, x1, y1, x2, y2, x3, y3]) =>
  new Curve(new Point(x0, y0), new Point(x1 - x0, y1 - y0), new Point(x2 - x3, y2 - y3), new Point(x3, y3));

serve({
  length: (control) => [curve(control).length],
  point: (control, [t]) => {
    const { x, y } = Curve.getPoint(control, t);
    return [x, y];
  },
  split: (control, [t]) => Curve.subdivide(control, t).flat(),
  nearest: (control, [x, y]) => {
    const { time, distance } = curve(control).getNearestLocation(new Point(x, y));
    return [time, distance];
  },
  at_length: (control, [length]) => {
    const { x, y } = curve(control).getPointAt(length);
    return [x, y];
  },
});
