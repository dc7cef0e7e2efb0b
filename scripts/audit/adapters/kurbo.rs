// SPDX-License-Identifier: MIT
mod serve;
use kurbo::*;

fn flat(points: &[Point]) -> Vec<f64> {
    points.iter().flat_map(|point| vec![point.x, point.y]).collect()
}

fn quad(q: &QuadBez) -> Vec<f64> {
    flat(&[q.p0, q.p1, q.p2])
}

fn cubic(c: &CubicBez) -> Vec<f64> {
    flat(&[c.p0, c.p1, c.p2, c.p3])
}

fn answer<C>(curve: C, control: fn(&C) -> Vec<f64>, problem: &str, asked: &[f64]) -> Vec<f64>
where
    C: ParamCurve + ParamCurveArclen + ParamCurveNearest,
{
    match problem {
        "length" => vec![curve.arclen(DEFAULT_ACCURACY)],
        "point" => flat(&[curve.eval(asked[0])]),
        "split" => [control(&curve.subsegment(0.0..asked[0])), control(&curve.subsegment(asked[0]..1.0))].concat(),
        "nearest" => {
            let (t, square) = curve.nearest(Point::new(asked[0], asked[1]), DEFAULT_ACCURACY);
            vec![t, square.sqrt()]
        }
        "at_length" => flat(&[curve.eval(curve.inv_arclen(asked[0], DEFAULT_ACCURACY))]),
        _ => panic!(),
    }
}

fn main() {
    serve::serve(|problem, p, asked| {
        let point = |i: usize| Point::new(p[2 * i], p[2 * i + 1]);
        if p.len() == 6 {
            return answer(QuadBez::new(point(0), point(1), point(2)), quad, problem, asked);
        }
        let curve = CubicBez::new(point(0), point(1), point(2), point(3));
        match problem {
            "quadratics" => curve.to_quads(asked[0]).flat_map(|(_, _, q)| quad(&q)).collect(),
            _ => answer(curve, cubic, problem, asked),
        }
    })
}
