//! Distances by the case distinction of C. Ericson, Real-Time Collision Detection, 5.1.5.

use ga_runtime::vga3::Vector;

/// The point of a triangle that is nearest to `p`; for a degenerate triangle, of its sides.
pub(super) fn closest(p: Vector<f64>, [a, b, c]: [Vector<f64>; 3]) -> Vector<f64> {
    let normal = (b - a).cross(c - a);
    if normal == Vector::ZERO {
        let sides = [[a, b], [b, c], [c, a]].map(|[a, b]| closest_of_segment(p, a, b));
        let distance = |x: &Vector<f64>| p.distance(*x);
        return sides
            .into_iter()
            .min_by(|x, y| distance(x).total_cmp(&distance(y)))
            .unwrap();
    }
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let sum = va + vb + vc;
    a + ab * (vb / sum) + ac * (vc / sum)
}

fn closest_of_segment(p: Vector<f64>, a: Vector<f64>, b: Vector<f64>) -> Vector<f64> {
    let ab = b - a;
    let square = ab.length_squared();
    if square == 0.0 {
        return a;
    }
    a + ab * (ab.dot(p - a) / square).clamp(0.0, 1.0)
}
