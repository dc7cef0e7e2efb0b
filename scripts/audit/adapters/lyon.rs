// SPDX-License-Identifier: MIT
mod serve;
use lyon_geom::{CubicBezierSegment, QuadraticBezierSegment};

fn flat(points: &[lyon_geom::euclid::default::Point2D<f64>]) -> Vec<f64> {
    points.iter().flat_map(|point| vec![point.x, point.y]).collect()
}

fn main() {
    serve::serve(|problem, p, asked| {
        let point = |i: usize| lyon_geom::euclid::default::Point2D::new(p[2 * i], p[2 * i + 1]);
        if p.len() == 6 {
            let curve = QuadraticBezierSegment { from: point(0), ctrl: point(1), to: point(2) };
            return match problem {
                "length" => vec![curve.approximate_length(asked[0])],
                "point" => flat(&[curve.sample(asked[0])]),
                "split" => {
                    let (a, b) = curve.split(asked[0]);
                    flat(&[a.from, a.ctrl, a.to, b.from, b.ctrl, b.to])
                }
                _ => panic!(),
            };
        }
        let curve = CubicBezierSegment { from: point(0), ctrl1: point(1), ctrl2: point(2), to: point(3) };
        match problem {
            "length" => vec![curve.approximate_length(asked[0])],
            "point" => flat(&[curve.sample(asked[0])]),
            "split" => {
                let (a, b) = curve.split(asked[0]);
                flat(&[a.from, a.ctrl1, a.ctrl2, a.to, b.from, b.ctrl1, b.ctrl2, b.to])
            }
            _ => panic!(),
        }
    })
}
