// SPDX-License-Identifier: MIT
// Answers the page's questions by the library. A method that fails answers with its reason, and does not stop the others.

import { load } from "./bezierbench.mjs";

const mostShared = 64; // the degree up to which shares are computed: 1000 exact points a method

let library;
let newestShares = 0;

const degreeOf = (curve) => curve.points.length / curve.dimension - 1;

function methodsFor(problem, curve, float) {
  const degree = degreeOf(curve);
  return library.methods(problem).filter((one) => one.form === curve.form && degree >= one.minDegree
    && degree <= (float ? one.maxDegreeFloat : one.maxDegree));
}

// What `compute` returns for each method, or why it does not.
const forEach = (methods, compute) => methods.map((method) => {
  const { id, label, bitStable } = method;
  try {
    return { id, label, bitStable, ...compute(id, method) };
  } catch (wrong) {
    return { id, label, bitStable, fault: wrong.message };
  }
});

function points({ curve, t, float }) {
  const exact = [...library.exact(curve, [t], { float })];
  const fractions = exact.map((_, axis) => { try { return library.exactText(curve, t, axis); } catch { return ""; } });
  const within = (method) => (t >= 0 && t <= 1) || !method.unitIntervalOnly;
  const rows = forEach(methodsFor("evaluate", curve, float).filter(within), (id, method) => {
    const values = [...library.evaluate(id, curve, [t], { float })];
    const errors = library.error(curve, [t], values, { float });
    const bound = method.hasBound ? library.bound(id, curve, [t], { float }) : null;
    return { values, errors, bound, boundText: method.boundText, fused: method.fused };
  });
  return { exact, fractions, rows, recommended: library.recommended(curve.form, degreeOf(curve), float) };
}

async function shares({ curve, float }, number, post) {
  newestShares = number;
  if (degreeOf(curve) > mostShared) { post({ fault: `computed up to degree ${mostShared}` }, true); return; }
  for (const { id } of methodsFor("evaluate", curve, float)) {
    await new Promise((resume) => { setTimeout(resume); }); // newer questions go first
    if (newestShares !== number) return;
    let share = null;
    try { share = library.misrounded(id, curve, 1000, { float }); } catch { /* the table has the method's reason */ }
    post({ id, share }, false);
  }
  post({}, true);
}

const companions = {
  points,
  length({ curve, from, to, tolerance }) {
    const rows = forEach(methodsFor("arc_length", curve), (id) => {
      const found = library.arcLength(id, curve, from, to, tolerance);
      return { ...found, error: library.lengthError(curve, from, to, found.length) };
    });
    return { exact: library.exactArcLength(curve, from, to), rows };
  },
  nearest({ curve, foot }) {
    const rows = forEach(methodsFor("projection", curve), (id) => {
      const found = library.project(id, curve, foot);
      return { ...found, error: library.projectError(curve, foot, found.t, found.distance) };
    });
    return { exact: library.exactProject(curve, foot), rows };
  },
  split({ curve, t }) {
    const rows = forEach(methodsFor("subdivision", curve), (id) => {
      const halves = library.split(id, curve, t);
      const join = halves[1].points.slice(0, curve.dimension);
      return { halves, join: [...join], errors: library.error(curve, [t], join) };
    });
    return { exact: [...library.exact(curve, [t])], rows };
  },
  chords({ curve, tolerance }) {
    return { rows: forEach(methodsFor("flattening", curve), (id) => library.flatten(id, curve, tolerance)) };
  },
  box({ curve }) {
    return { rows: forEach(methodsFor("bounds", curve), (id) => ({ box: [...library.box(id, curve)] })) };
  },
  easing({ bezier, x }) {
    const rows = forEach(library.methods("easing"), (id) => ({ y: library.ease(id, bezier, [x])[0] }));
    return { exact: library.exactEase(bezier, [x])[0], rows };
  },
};

// The library is base64 of its gzip.
async function start(base64) {
  const packed = new Blob([Uint8Array.from(atob(base64), (one) => one.charCodeAt(0))]).stream();
  library = await load(await new Response(packed.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer());
}

let ready;
onmessage = async ({ data }) => {
  try {
    if (data.program) { ready = start(data.program); await ready; return; }
    await ready;
  } catch (wrong) {
    postMessage({ fatal: wrong.message });
    return;
  }
  const { kind, number, question } = data;
  const post = (answer, last) => postMessage({ kind, number, answer, last });
  try {
    if (kind === "shares") await shares(question, number, post);
    else post(companions[kind](question), true);
  } catch (wrong) {
    postMessage({ kind, number, fault: wrong.message, last: true });
  }
};
