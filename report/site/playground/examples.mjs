// SPDX-License-Identifier: MIT
// The curves that the page offers; `id` is the one in reference/curves/sets, with its source and licence there.

const cubic = (...points) => ({ form: "bernstein", dimension: 2, points, weights: null });

export const examples = [
  { name: "digit 6", what: "a cubic of a font, Cantarell Bold", id: "cff:Cantarell-Bold:six:0:8", curve: cubic(46, 329, 46, 110, 141, -10, 308, -10) },
  { name: "icon arc", what: "an arc of the icon leaf of Lucide, a rational quadratic", id: "lucide:leaf:0:0:6", down: true,
    curve: { form: "rational", dimension: 2, points: [4.004735312398147, 13.602109181663469, 4.558755769462401, 20.01951280932442, 11, 20], weights: [1, 0.735864287853363, 1] } },
  { name: "border", what: "a border on a map in metres, small and far from the origin", id: "borders:countries-10m:636:2",
    curve: cubic(3985299.89, 3936898.17, 3975402.9243323114, 3932617.3507746183, 3984019.646329968, 3930692.2808588305, 3985700.64, 3928353.93) },
  { name: "cusp", what: "a cubic that stops and turns at t = 1/2", curve: cubic(0, 0, 1, 1, 0, 1, 1, 0) },
  { name: "loses digits", what: "Wilkinson’s polynomial of degree 20: detours through the power form lose digits", id: "named:wilkinson_20", t: 0.75,
    curve: { form: "bernstein", dimension: 1, weights: null, points: [0.00762258507, -0.0211726953, 0.0504149948, -0.10521191, 0.195227373, -0.325297901,
      0.490147106, -0.671190568, 0.838228824, -0.956946729, 1, -0.956946729, 0.838228824, -0.671190568, 0.490147106, -0.325297901, 0.195227373, -0.10521191,
      0.0504149948, -0.0211726953, 0.00762258507] } },
  { name: "CSS ease", what: "cubic-bezier(0.25, 0.1, 0.25, 1)", id: "named:css_ease", view: "easing", curve: cubic(0, 0, 0.25, 0.1, 0.25, 1, 1, 1) },
];
