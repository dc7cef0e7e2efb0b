// SPDX-License-Identifier: MIT
export interface Curve { form: "bernstein" | "power" | "rational"; dimension: 1 | 2 | 3; points: ArrayLike<number>; weights?: ArrayLike<number> }
export interface Method {
  id: string; label: string; problem: string; form: Curve["form"];
  fused: boolean; note: string; // what a fused method costs here
  minDegree: number; maxDegree: number; maxDegreeFloat: number; hasBound: boolean; boundText: string; flops: string; citation: string;
  unitIntervalOnly: boolean; bitStable: boolean;
}
export interface Precision { float?: boolean } // of curve, parameters and values; double without it
export interface ErrorOfCoordinate { exact: number; absolute: number; ulp: number; u: number } // u: over u p~
export interface BoundOfCoordinate { absolute: number; u: number }
type Numbers = ArrayLike<number>;
type MethodId = string | null; // null: the recommended one

export class BezierbenchError extends Error { status: number } // a bb_status of bezierbench.h
export function load(source: string | URL | Response | ArrayBuffer | Uint8Array): Promise<Library>;
export class Library {
  version: string;
  methods(problem?: string): Method[];
  recommended(form: Curve["form"], degree: number, float?: boolean): string;
  evaluate(method: MethodId, curve: Curve, ts: Numbers, precision?: Precision): Float64Array;
  exact(curve: Curve, ts: Numbers, precision?: Precision): Float64Array;
  exactText(curve: Curve, t: number, axis: number): string;
  error(curve: Curve, ts: Numbers, values: Numbers, precision?: Precision): ErrorOfCoordinate[];
  bound(method: MethodId, curve: Curve, ts: Numbers, precision?: Precision): BoundOfCoordinate[];
  misrounded(method: MethodId, curve: Curve, count?: number, precision?: Precision): number;
  arcLength(method: string, curve: Curve, from: number, to: number, tolerance: number): { length: number; errorEstimate: number; evaluations: number; converged: boolean };
  exactArcLength(curve: Curve, from: number, to: number): number;
  lengthError(curve: Curve, from: number, to: number, length: number): number;
  atLength(method: string, curve: Curve, length: number, tolerance: number): { t: number; errorEstimate: number; iterations: number; converged: boolean };
  project(method: string, curve: Curve, point: Numbers): { t: number; distance: number; candidates: number; converged: boolean };
  exactProject(curve: Curve, point: Numbers): { t: number; distance: number };
  projectError(curve: Curve, point: Numbers, t: number, distance: number): number;
  split(method: string, curve: Curve, t: number): [Curve, Curve];
  flatten(method: string, curve: Curve, tolerance: number): { t: Float64Array; points: Float64Array; complete: boolean };
  box(method: string, curve: Curve): Float64Array;
  roots(curve: Curve, of: "value" | "derivative" | "curvature", axis?: number, value?: number): { everywhere: boolean; t: Float64Array; multiplicities: Int32Array };
  ease(method: MethodId, bezier: Numbers, xs: Numbers, precision?: Precision): Float64Array;
  exactEase(bezier: Numbers, xs: Numbers): Float64Array;
}
