// SPDX-License-Identifier: MIT
// libbezierbench in a browser or in Node: load() takes bezierbench.wasm, and a Library answers as bindings/c does, whose
// header bezierbench.h defines what each function computes. bezierbench.d.mts has the types.

const forms = ["bernstein", "power", "rational"];
const rootsOf = ["value", "derivative", "curvature"];
const errors = { memory: 14, count: 15, internal: 16, form: 3, parameter: 7, method: 2 };
const inNative = "WebAssembly has no fused multiply-add: a function computes it, with the same bits in more time";

// What the library refuses; `status` is the bb_status of bezierbench.h.
export class BezierbenchError extends Error {
  name = "BezierbenchError";

  constructor(status, message) {
    super(message);
    this.status = status;
  }
}

// From the address of bezierbench.wasm, a response that has it, or its bytes.
export async function load(source) {
  const bytes = typeof source === "string" || source instanceof URL ? await fetch(source) : source;
  if (typeof Response === "undefined" || !(bytes instanceof Response)) return new Library(await WebAssembly.compile(bytes));
  if (!bytes.ok) throw new BezierbenchError(19, `${bytes.url}: the answer is ${bytes.status} ${bytes.statusText}`);
  return new Library(await WebAssembly.compile(await bytes.arrayBuffer()));
}

// The memory of one call, which is freed behind it.
class Room {
  #library;
  #places = [];

  constructor(library) {
    this.#library = library;
  }

  bytes(size) {
    const place = this.#library.malloc(size);
    if (place === 0) throw new BezierbenchError(errors.memory, "memory is exhausted");
    this.#places.push(place);
    return place;
  }

  array(Kind, length) {
    const place = this.bytes(length * Kind.BYTES_PER_ELEMENT || 1);
    // A later call may move the memory, so the numbers are looked up when they are read.
    return { place, length, get values() { return new Kind(this.memory.buffer, place, length); }, memory: this.#library.memory };
  }

  filled(Kind, values) {
    const room = this.array(Kind, values.length);
    room.values.set(values);
    return room;
  }

  text(value) {
    return value == null ? { place: 0 } : this.filled(Uint8Array, new TextEncoder().encode(`${value}\0`));
  }

  free() {
    for (const place of this.#places) this.#library.free(place);
  }
}

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
    const name = problem === "evaluate" ? "evaluation" : problem;
    const found = this.#methods.get(name);
    if (found) return found;
    throw new BezierbenchError(errors.method, `no problem "${problem}"; problems: ${[...this.#methods.keys()].join(", ")}`);
  }

  recommended(form, degree, float = false) {
    const place = this.#library.bb_recommended(forms.indexOf(form), degree, Number(float));
    if (place === 0) throw new BezierbenchError(5, `no curve has the form "${form}" and degree ${degree}`);
    return this.#text(place);
  }

  evaluate(method, curve, ts, { float = false } = {}) {
    if (!float) return this.#points(curve, ts, false, (given, t, out) =>
      this.#library.bb_curve_evaluate(given.room.text(method).place, given.place, t.place, t.length, out.place));
    return this.#within((room) => {
      const { form, dimension, degree, points, weights } = this.#parts(curve);
      const t = room.filled(Float32Array, ts);
      const out = room.array(Float32Array, ts.length * dimension);
      const batch = room.filled(Int32Array, [form, dimension, degree, 1, ts.length, 0, 0, 0]);
      this.#check(this.#library.bb_evaluate_curves_float(room.text(method).place, batch.place, room.filled(Float32Array, points).place,
        weights ? room.filled(Float32Array, weights).place : 0, t.place, out.place));
      return Float64Array.from(out.values);
    });
  }

  exact(curve, ts, { float = false } = {}) {
    const exact = float ? this.#library.bb_web_exact_float : this.#library.bb_curve_exact;
    return this.#points(curve, ts, float, (given, t, out) => exact(given.place, t.place, t.length, out.place));
  }

  // "numerator" or "numerator/denominator", in lowest terms.
  exactText(curve, t, axis) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const required = room.array(Uint32Array, 1);
      let text = room.array(Uint8Array, 256);
      const ask = () => this.#library.bb_curve_exact_text(given.place, t, axis, text.place, text.length, required.place);
      let status = ask();
      if (status === errors.count && required.values[0] > text.length) {
        text = room.array(Uint8Array, required.values[0]);
        status = ask();
      }
      this.#check(status);
      return this.#text(text.place);
    });
  }

  // One for each coordinate of `values`, as bb_error has it; with `float`, u and ulp are those of float.
  error(curve, ts, values, { float = false } = {}) {
    return this.#within((room) => {
      const given = this.#curve(room, curve, float);
      const t = this.#parameters(room, ts, float);
      const count = ts.length * given.dimension;
      if (values.length !== count) throw new BezierbenchError(errors.count, `${values.length} values for ${ts.length} points of ${given.dimension} coordinates`);
      const out = room.array(Float64Array, count * 4);
      const judge = float ? this.#library.bb_web_error_float : this.#library.bb_curve_error;
      this.#check(judge(given.place, t.place, t.length, room.filled(Float64Array, values).place, out.place));
      return rows(out.values, 4, ([exact, absolute, ulp, u]) => ({ exact, absolute, ulp, u }));
    });
  }

  // One for each coordinate: the proved bound in coordinate units, and over u p~.
  bound(method, curve, ts, { float = false } = {}) {
    return this.#within((room) => {
      const given = this.#curve(room, curve, float);
      const t = this.#parameters(room, ts, float);
      const out = room.array(Float64Array, ts.length * given.dimension * 2);
      const prove = float ? this.#library.bb_web_bound_float : this.#library.bb_curve_bound;
      this.#check(prove(room.text(method).place, given.place, t.place, t.length, out.place));
      return rows(out.values, 2, ([absolute, u]) => ({ absolute, u }));
    });
  }

  // The share of the coordinates at `count` equally spaced t of [0, 1] that are not the nearest number.
  misrounded(method, curve, count = 1000, { float = false } = {}) {
    const ts = Float64Array.from({ length: count }, (_, k) => k / Math.max(count - 1, 1));
    const key = JSON.stringify([curve, count, float]);
    if (this.#truth.key !== key) this.#truth = { key, values: this.exact(curve, ts, { float }) };
    const values = this.evaluate(method, curve, ts, { float });
    return values.reduce((sum, value, k) => sum + (value === this.#truth.values[k] ? 0 : 1), 0) / values.length;
  }

  arcLength(method, curve, from, to, tolerance) {
    return this.#numbers(curve, 32, (given, out) => this.#library.bb_arc_length(given.room.text(method).place, given.place, from, to, tolerance, out),
      (view) => ({ length: view.getFloat64(0, true), errorEstimate: view.getFloat64(8, true), evaluations: Number(view.getBigInt64(16, true)), converged: view.getInt32(24, true) !== 0 }));
  }

  exactArcLength(curve, from, to) {
    return this.#numbers(curve, 8, (given, out) => this.#library.bb_exact_arc_length(given.place, from, to, out), (view) => view.getFloat64(0, true));
  }

  lengthError(curve, from, to, length) {
    return this.#numbers(curve, 8, (given, out) => this.#library.bb_arc_length_error(given.place, from, to, length, out), (view) => view.getFloat64(0, true));
  }

  atLength(method, curve, length, tolerance) {
    return this.#numbers(curve, 32, (given, out) => this.#library.bb_at_length(given.room.text(method).place, given.place, length, tolerance, out),
      (view) => ({ t: view.getFloat64(0, true), errorEstimate: view.getFloat64(8, true), iterations: Number(view.getBigInt64(16, true)), converged: view.getInt32(24, true) !== 0 }));
  }

  project(method, curve, point) {
    return this.#numbers(curve, 24, (given, out) => this.#library.bb_project(given.room.text(method).place, given.place, this.#point(given, point), out),
      (view) => ({ t: view.getFloat64(0, true), distance: view.getFloat64(8, true), candidates: view.getInt32(16, true), converged: view.getInt32(20, true) !== 0 }));
  }

  exactProject(curve, point) {
    return this.#numbers(curve, 16, (given, out) => this.#library.bb_exact_project(given.place, this.#point(given, point), out, out + 8),
      (view) => ({ t: view.getFloat64(0, true), distance: view.getFloat64(8, true) }));
  }

  projectError(curve, point, t, distance) {
    return this.#numbers(curve, 8, (given, out) => this.#library.bb_project_error(given.place, this.#point(given, point), t, distance, out), (view) => view.getFloat64(0, true));
  }

  split(method, curve, t) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const halves = [0, 1].map(() => ({ points: room.array(Float64Array, given.points.length), weights: room.array(Float64Array, given.degree + 1) }));
      const [left, right] = halves.map((half) => room.filled(Uint32Array, [half.points.place, half.weights.place]).place);
      this.#check(this.#library.bb_split(room.text(method).place, given.place, t, left, right));
      return halves.map((half) => ({ form: curve.form, dimension: curve.dimension, points: [...half.points.values],
        ...(given.weights && { weights: [...half.weights.values] }) }));
    });
  }

  // The ends of the chords; `complete` is false where the method says that it did not keep the tolerance.
  flatten(method, curve, tolerance) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const name = room.text(method).place;
      const ends = room.array(Uint32Array, 2);
      const ask = (t, points) => this.#check(this.#library.bb_flatten(name, given.place, tolerance, t?.place ?? 0, points?.place ?? 0, t?.length ?? 0, ends.place, ends.place + 4));
      ask();
      const [count, complete] = ends.values;
      const t = room.array(Float64Array, count);
      const points = room.array(Float64Array, count * given.dimension);
      ask(t, points);
      return { t: t.values.slice(), points: points.values.slice(), complete: complete !== 0 };
    });
  }

  // The lowest and the highest coordinate of each axis.
  box(method, curve) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const out = room.array(Float64Array, 2 * given.dimension);
      this.#check(this.#library.bb_box(room.text(method).place, given.place, out.place));
      return out.values.slice();
    });
  }

  // Where the coordinate `axis` is `value`, its derivative is 0, or the curvature is 0; `everywhere` where that is so at every t.
  roots(curve, of, axis = 0, value = 0) {
    return this.#within((room) => {
      const given = this.#curve(room, curve);
      const most = 3 * given.degree + 1;
      const t = room.array(Float64Array, most);
      const multiplicities = room.array(Int32Array, most);
      const count = room.array(Uint32Array, 1);
      this.#check(this.#library.bb_roots(given.place, rootsOf.indexOf(of), axis, value, t.place, multiplicities.place, most, count.place));
      const [found] = count.values;
      const everywhere = found > most;
      const last = everywhere ? 0 : found;
      return { everywhere, t: t.values.slice(0, last), multiplicities: multiplicities.values.slice(0, last) };
    });
  }

  ease(method, bezier, xs, { float = false } = {}) {
    const ease = float ? this.#library.bb_ease_float : this.#library.bb_ease;
    return this.#eased(bezier, xs, float ? Float32Array : Float64Array, (room, ...places) => ease(room.text(method).place, ...places));
  }

  exactEase(bezier, xs) {
    return this.#eased(bezier, xs, Float64Array, (_, ...places) => this.#library.bb_exact_ease(...places));
  }

  #eased(bezier, xs, Kind, ask) {
    return this.#within((room) => {
      if (bezier.length !== 4) throw new BezierbenchError(errors.count, `an easing curve has 4 numbers, x1, y1, x2 and y2, not ${bezier.length}`);
      const out = room.array(Kind, xs.length);
      this.#check(ask(room, room.filled(Kind, bezier).place, room.filled(Kind, xs).place, xs.length, out.place));
      return Float64Array.from(out.values);
    });
  }

  #restart() {
    const refuse = () => { throw new WebAssembly.RuntimeError("the library asks for its system"); };
    const system = Object.fromEntries(WebAssembly.Module.imports(this.#module).map(({ name }) => [name, refuse]));
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
      if (fault instanceof BezierbenchError) room.free();
      if (![WebAssembly.RuntimeError, WebAssembly.Exception, RangeError].some((kind) => fault instanceof kind)) throw fault;
      this.#restart();
      throw new BezierbenchError(errors.internal, `the computation ended in WebAssembly (${fault.message}): memory or stack are exhausted, or it is a defect of libbezierbench`);
    }
  }

  #check(status) {
    if (status !== 0) throw new BezierbenchError(status, this.#text(this.#library.bb_strerror(status)));
  }

  #text(place) {
    const bytes = new Uint8Array(this.#library.memory.buffer, place);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  #list() {
    this.#within((room) => {
      const entry = room.array(Int32Array, 12);
      for (let index = 0; index < this.#library.bb_method_count(); ++index) {
        this.#check(this.#library.bb_method_at(index, entry.place));
        const [id, label, problem, boundText, flops, citation] = [...entry.values.subarray(0, 6)].map((place) => this.#text(place));
        const [form, minDegree, maxDegree, maxDegreeFloat, unitIntervalOnly, bitStable] = entry.values.subarray(6);
        const fused = this.#library.bb_web_is_fused(entry.values[0]) !== 0;
        if (!this.#methods.has(problem)) this.#methods.set(problem, []);
        this.#methods.get(problem).push({ id, label, problem, form: forms[form], fused, note: fused ? inNative : "", minDegree, maxDegree,
          maxDegreeFloat, hasBound: boundText !== "", boundText, flops, citation, unitIntervalOnly: unitIntervalOnly !== 0, bitStable: bitStable !== 0 });
      }
    });
  }

  // The numbers of a curve, counted.
  #parts({ form, dimension, points, weights }) {
    const degree = points.length / dimension - 1;
    if (!forms.includes(form)) throw new BezierbenchError(errors.form, `no form "${form}"; forms: ${forms.join(", ")}`);
    if (!Number.isInteger(degree)) throw new BezierbenchError(errors.count, `${points.length} numbers are not points of ${dimension} coordinates`);
    const count = form === "rational" ? weights?.length ?? 0 : degree + 1;
    if (count !== degree + 1) throw new BezierbenchError(errors.count, `${count} weights for ${degree + 1} points`);
    return { form: forms.indexOf(form), dimension, degree, points, weights: form === "rational" ? weights : undefined };
  }

  // A bb_curve. With `float` its numbers are floats.
  #curve(room, curve, float = false) {
    const parts = this.#parts(curve);
    const { form, dimension, degree, points, weights } = parts;
    const [at, of] = [points, weights].map((values) => (values ? this.#parameters(room, values, float).place : 0));
    return { ...parts, room, place: room.filled(Int32Array, [form, dimension, degree, at, of]).place };
  }

  #parameters(room, values, float) {
    return room.filled(Float64Array, float ? Float32Array.from(values) : values);
  }

  #point({ room, dimension }, point) {
    if (point.length !== dimension) throw new BezierbenchError(errors.count, `a point of ${point.length} coordinates for a curve of ${dimension}`);
    return room.filled(Float64Array, point).place;
  }

  #points(curve, ts, float, ask) {
    return this.#within((room) => {
      const given = this.#curve(room, curve, float);
      const out = room.array(Float64Array, ts.length * given.dimension);
      this.#check(ask(given, this.#parameters(room, ts, float), out));
      return out.values.slice();
    });
  }

  // The answer that `read` finds in the `size` bytes that `ask` fills.
  #numbers(curve, size, ask, read) {
    return this.#within((room) => {
      const out = room.bytes(size);
      this.#check(ask(this.#curve(room, curve), out));
      return read(new DataView(this.#library.memory.buffer, out, size));
    });
  }
}

function rows(values, width, row) {
  return Array.from({ length: values.length / width }, (_, k) => row(values.subarray(k * width, (k + 1) * width)));
}
