// SPDX-License-Identifier: MIT
// libbezierbench in a browser or in Node: load() takes bezierbench.wasm, and a Library answers as bindings/c does, whose
// header bezierbench.h defines what each function computes. bezierbench.d.mts has the types.

const forms = ["bernstein", "power", "rational"];
const rootsOf = ["value", "derivative", "curvature"];
// bb_status, as far as this module refuses by itself.
const status = { method: 2, form: 3, degree: 5, memory: 14, count: 15, internal: 16, file: 19 };
const slow = "WebAssembly has no fused multiply-add: a function computes it, with the same bits in more time";

// What the library refuses; `status` is the bb_status of bezierbench.h.
export class BezierbenchError extends Error {
  name = "BezierbenchError";

  constructor(number, message) {
    super(message);
    this.status = number;
  }
}

const refuse = (number, message) => { throw new BezierbenchError(number, message); };

// From the address of bezierbench.wasm, a response that has it, or its bytes.
export async function load(source) {
  let bytes = typeof source === "string" || source instanceof URL ? await fetch(source) : source;
  if (typeof Response !== "undefined" && bytes instanceof Response) {
    if (!bytes.ok) refuse(status.file, `${bytes.url} cannot be read: ${bytes.status} ${bytes.statusText}`);
    bytes = await bytes.arrayBuffer();
  }
  return new Library(await WebAssembly.compile(bytes));
}

// The memory of one call, which is freed behind it.
class Room {
  #library;
  #places = [];

  constructor(library) {
    this.#library = library;
  }

  // Numbers in the library's memory, which a later call may move: `values` finds them where they are.
  array(Kind, length) {
    const size = length * Kind.BYTES_PER_ELEMENT || 1;
    const place = size < 2 ** 31 ? this.#library.malloc(size) : 0;
    if (place === 0) refuse(status.memory, "memory is exhausted");
    this.#places.push(place);
    const { memory } = this.#library;
    return { place, length, get values() { return new Kind(memory.buffer, place, length); } };
  }

  filled(Kind, values) {
    const room = this.array(Kind, values.length);
    room.values.set(values);
    return room;
  }

  // With `float` they are doubles that are floats.
  doubles(values, float) {
    return this.filled(Float64Array, float ? Float32Array.from(values) : values);
  }

  free() {
    for (const place of this.#places) this.#library.free(place);
  }
}

// The structures of bezierbench.h.
const asNumber = (view) => view.getFloat64(0, true);
const asLength = (view) => ({
  length: view.getFloat64(0, true),
  errorEstimate: view.getFloat64(8, true),
  evaluations: Number(view.getBigInt64(16, true)),
  converged: view.getInt32(24, true) !== 0,
});
const asParameter = (view) => {
  const { length, errorEstimate, evaluations, converged } = asLength(view);
  return { t: length, errorEstimate, iterations: evaluations, converged };
};
const asFoot = (view) => ({
  t: view.getFloat64(0, true),
  distance: view.getFloat64(8, true),
  candidates: view.getInt32(16, true),
  converged: view.getInt32(20, true) !== 0,
});
const asExactFoot = (view) => ({ t: view.getFloat64(0, true), distance: view.getFloat64(8, true) });
const asError = ([exact, absolute, ulp, u]) => ({ exact, absolute, ulp, u });
const asBound = ([absolute, u]) => ({ absolute, u });
const rows = ({ values }, width, row) =>
  Array.from({ length: values.length / width }, (_, k) => row(values.subarray(k * width, (k + 1) * width)));

export class Library {
  #module;
  #library;
  #methods = new Map();
  #truth = {};

  constructor(module) {
    this.#module = module;
    this.#restart();
    const version = this.#library.bb_version();
    this.version = `${version >> 16}.${(version >> 8) & 255}.${version & 255}`;
    this.#list();
  }

  // The methods for a problem, in the library's order: once for each form in which they take curves.
  methods(problem = "evaluate") {
    return this.#methods.get(problem === "evaluate" ? "evaluation" : problem)
      ?? refuse(status.method, `no problem "${problem}"; problems: ${[...this.#methods.keys()].join(", ")}`);
  }

  recommended(form, degree, float = false) {
    const place = this.#library.bb_recommended(forms.indexOf(form), degree, Number(float));
    return place ? this.#text(place) : refuse(status.degree, `no curve has the form "${form}" and degree ${degree}`);
  }

  evaluate(method, curve, ts, { float = false } = {}) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const { form, dimension, degree, points, weights } = given;
      const Kind = float ? Float32Array : Float64Array;
      const t = room.filled(Kind, ts);
      const out = room.array(Kind, ts.length * dimension);
      if (float) {
        const batch = room.filled(Int32Array, [form, dimension, degree, 1, ts.length, 0, 0, 0]);
        const [of, by] = [points, weights].map((values) => values && room.filled(Kind, values));
        this.#ask(room, "bb_evaluate_curves_float", method, batch, of, by, t, out);
      } else {
        this.#ask(room, "bb_curve_evaluate", method, given, t, ts.length, out);
      }
      return Float64Array.from(out.values);
    });
  }

  exact(curve, ts, { float = false } = {}) {
    return this.#within((room) => {
      const given = this.#curve(room, curve, float);
      const out = room.array(Float64Array, ts.length * given.dimension);
      this.#ask(room, float ? "bb_web_exact_float" : "bb_curve_exact", given, room.doubles(ts, float), ts.length, out);
      return out.values.slice();
    });
  }

  // "numerator" or "numerator/denominator", in lowest terms.
  exactText(curve, t, axis) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const required = room.filled(Uint32Array, [0]);
      const ask = (size) => {
        const text = room.array(Uint8Array, size);
        this.#ask(room, "bb_curve_exact_text", given, t, axis, text, size, required);
        return this.#text(text.place);
      };
      try {
        return ask(256);
      } catch (fault) {
        if (required.values[0] <= 256) throw fault;
        return ask(required.values[0]);
      }
    });
  }

  // One for each coordinate of `values`: bb_error, with the true value, and with `float` in u and ulp of float.
  error(curve, ts, values, { float = false } = {}) {
    return this.#within((room) => {
      const given = this.#curve(room, curve, float);
      const count = ts.length * given.dimension;
      if (values.length !== count) refuse(status.count, `${values.length} values for ${count} coordinates`);
      const out = room.array(Float64Array, count * 4);
      this.#ask(room, float ? "bb_web_error_float" : "bb_curve_error", given, room.doubles(ts, float), ts.length,
        room.doubles(values), out);
      return rows(out, 4, asError);
    });
  }

  // One for each coordinate: the proved bound in coordinate units, and over u p~.
  bound(method, curve, ts, { float = false } = {}) {
    return this.#within((room) => {
      const given = this.#curve(room, curve, float);
      const out = room.array(Float64Array, ts.length * given.dimension * 2);
      this.#ask(room, float ? "bb_web_bound_float" : "bb_curve_bound", method, given, room.doubles(ts, float), ts.length, out);
      return rows(out, 2, asBound);
    });
  }

  // The share of the coordinates at `count` equally spaced t of [0, 1] that are not the nearest number. The true points of the
  // last curve are kept for the next method.
  misrounded(method, curve, count = 1000, { float = false } = {}) {
    const ts = Float64Array.from({ length: count }, (_, k) => k / Math.max(count - 1, 1));
    const key = JSON.stringify([curve, count, float]);
    if (this.#truth.key !== key) this.#truth = { key, values: this.exact(curve, ts, { float }) };
    const values = this.evaluate(method, curve, ts, { float });
    return values.filter((value, k) => value !== this.#truth.values[k]).length / values.length;
  }

  arcLength(method, curve, from, to, tolerance) {
    return this.#structure(32, asLength, (room, out) => ["bb_arc_length", method, this.#curve(room, curve), from, to, tolerance, out]);
  }

  exactArcLength(curve, from, to) {
    return this.#structure(8, asNumber, (room, out) => ["bb_exact_arc_length", this.#curve(room, curve), from, to, out]);
  }

  lengthError(curve, from, to, length) {
    return this.#structure(8, asNumber, (room, out) => ["bb_arc_length_error", this.#curve(room, curve), from, to, length, out]);
  }

  atLength(method, curve, length, tolerance) {
    return this.#structure(32, asParameter, (room, out) => ["bb_at_length", method, this.#curve(room, curve), length, tolerance, out]);
  }

  project(method, curve, point) {
    return this.#structure(24, asFoot, (room, out) => ["bb_project", method, ...this.#curveAndPoint(room, curve, point), out]);
  }

  exactProject(curve, point) {
    return this.#structure(16, asExactFoot, (room, out) =>
      ["bb_exact_project", ...this.#curveAndPoint(room, curve, point), out, out.place + 8]);
  }

  projectError(curve, point, t, distance) {
    return this.#structure(8, asNumber, (room, out) =>
      ["bb_project_error", ...this.#curveAndPoint(room, curve, point), t, distance, out]);
  }

  split(method, curve, t) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const halves = [0, 1].map(() => [given.points.length, given.degree + 1].map((count) => room.array(Float64Array, count)));
      const places = halves.map((half) => room.filled(Uint32Array, half.map(({ place }) => place)));
      this.#ask(room, "bb_split", method, given, t, ...places);
      return halves.map(([points, weights]) => ({
        form: curve.form,
        dimension: curve.dimension,
        points: [...points.values],
        ...(given.weights && { weights: [...weights.values] }),
      }));
    });
  }

  // The ends of the chords; `complete` is false where the method says that it did not keep the tolerance.
  flatten(method, curve, tolerance) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const ends = room.array(Uint32Array, 2);
      const ask = (...into) => this.#ask(room, "bb_flatten", method, given, tolerance, ...into, ends, ends.place + 4);
      ask(null, null, 0);
      const [count, complete] = ends.values;
      const t = room.array(Float64Array, count);
      const points = room.array(Float64Array, count * given.dimension);
      ask(t, points, count);
      return { t: t.values.slice(), points: points.values.slice(), complete: complete !== 0 };
    });
  }

  // The lowest and the highest coordinate of each axis.
  box(method, curve) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const out = room.array(Float64Array, 2 * given.dimension);
      this.#ask(room, "bb_box", method, given, out);
      return out.values.slice();
    });
  }

  // Where the coordinate `axis` is `value`, its derivative is 0, or the curvature is 0; `everywhere` where that is every t.
  roots(curve, of, axis = 0, value = 0) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const most = 3 * given.degree + 1;
      const t = room.array(Float64Array, most);
      const multiplicities = room.array(Int32Array, most);
      const count = room.array(Uint32Array, 1);
      this.#ask(room, "bb_roots", given, rootsOf.indexOf(of), axis, value, t, multiplicities, most, count);
      const everywhere = count.values[0] > most;
      const last = everywhere ? 0 : count.values[0];
      return { everywhere, t: t.values.slice(0, last), multiplicities: multiplicities.values.slice(0, last) };
    });
  }

  ease(method, bezier, xs, { float = false } = {}) {
    return this.#eased(bezier, xs, float ? Float32Array : Float64Array, [float ? "bb_ease_float" : "bb_ease", method]);
  }

  exactEase(bezier, xs) {
    return this.#eased(bezier, xs, Float64Array, ["bb_exact_ease"]);
  }

  #eased(bezier, xs, Kind, call) {
    if (bezier.length !== 4) refuse(status.count, `an easing curve has 4 numbers, x1, y1, x2 and y2, not ${bezier.length}`);
    return this.#within((room) => {
      const out = room.array(Kind, xs.length);
      this.#ask(room, ...call, room.filled(Kind, bezier), room.filled(Kind, xs), xs.length, out);
      return Float64Array.from(out.values);
    });
  }

  #restart() {
    const refused = () => { throw new WebAssembly.RuntimeError("the library asks for an operating system"); };
    const system = Object.fromEntries(WebAssembly.Module.imports(this.#module).map(({ name }) => [name, refused]));
    this.#library = new WebAssembly.Instance(this.#module, { wasi_snapshot_preview1: system }).exports;
    this.#library._initialize();
  }

  // Frees the memory of a call. A trap leaves the library in an unknown state, so the next call has a fresh one.
  #within(work) {
    const room = new Room(this.#library);
    try {
      const answer = work(room);
      room.free();
      return answer;
    } catch (fault) {
      const trapped = [WebAssembly.RuntimeError, WebAssembly.Exception, RangeError].some((kind) => fault instanceof kind);
      if (!trapped) {
        room.free();
        throw fault;
      }
      this.#restart();
      return refuse(status.internal, `WebAssembly ended the computation (${fault.message}): it exhausts memory or stack`);
    }
  }

  // Calls a function of the library: ids of methods are texts, what lies in a room is its place, and null is null.
  #ask(room, name, ...values) {
    const places = values.map((value) => (typeof value === "number" ? value
      : (typeof value === "string" ? room.filled(Uint8Array, new TextEncoder().encode(`${value}\0`)) : value)?.place ?? 0));
    const number = this.#library[name](...places);
    if (number !== 0) refuse(number, this.#text(this.#library.bb_strerror(number)));
  }

  // What `read` finds in the `size` bytes that `call` fills.
  #structure(size, read, call) {
    return this.#within((room) => {
      const out = room.array(Uint8Array, size);
      this.#ask(room, ...call(room, out));
      return read(new DataView(this.#library.memory.buffer, out.place, size));
    });
  }

  #text(place) {
    const bytes = new Uint8Array(this.#library.memory.buffer, place);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  #list() {
    this.#within((room) => {
      const entry = room.array(Int32Array, 12);
      for (let index = 0; index < this.#library.bb_method_count(); ++index) {
        this.#ask(room, "bb_method_at", index, entry);
        const [id, label, problem, boundText, flops, citation] = Array.from(entry.values.subarray(0, 6), (place) => this.#text(place));
        const [form, minDegree, maxDegree, maxDegreeFloat, inUnitInterval, bitStable] = entry.values.subarray(6);
        const fused = this.#library.bb_web_is_fused(entry.values[0]) !== 0;
        if (!this.#methods.has(problem)) this.#methods.set(problem, []);
        this.#methods.get(problem).push({
          id, label, problem, form: forms[form], fused, note: fused ? slow : "", minDegree, maxDegree, maxDegreeFloat,
          hasBound: boundText !== "", boundText, flops, citation, unitIntervalOnly: inUnitInterval !== 0, bitStable: bitStable !== 0,
        });
      }
    });
  }

  // A bb_curve in the library's memory, with its numbers as they were given. With `float` they become floats.
  #curve(room, { form, dimension, points, weights }, float = false) {
    if (!forms.includes(form)) refuse(status.form, `no form "${form}"; forms: ${forms.join(", ")}`);
    const degree = points.length / dimension - 1;
    if (!Number.isInteger(degree)) refuse(status.count, `${points.length} numbers are not points of ${dimension} coordinates`);
    const given = { form: forms.indexOf(form), dimension, degree, points };
    if (form === "rational") given.weights = weights ?? [];
    const count = given.weights?.length ?? degree + 1;
    if (count !== degree + 1) refuse(status.count, `${count} weights for ${degree + 1} points`);
    const places = [points, given.weights].map((values) => (values ? room.doubles(values, float).place : 0));
    return { ...given, place: room.filled(Int32Array, [given.form, dimension, degree, ...places]).place };
  }

  #curveAndPoint(room, curve, point) {
    if (point.length !== curve.dimension) refuse(status.count, `a point of ${point.length} coordinates, a curve of ${curve.dimension}`);
    return [this.#curve(room, curve), room.doubles(point)];
  }
}
