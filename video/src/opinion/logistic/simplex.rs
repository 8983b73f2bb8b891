//! The simplex method of J. A. Nelder and R. Mead ("A simplex method for function minimization",
//! 1965) for functions of two numbers.

/// A place and the value there.
pub(super) type Vertex = ([f64; 2], f64);

/// How many times a simplex is changed at most.
const STEPS: usize = 400;
/// The simplex is small enough when its sides are.
const LEAST_SIDE: f64 = 1e-9;

/// The least value that is found from a place on, where a simplex with sides of these lengths
/// begins.
pub(super) fn minimise(
    function: impl Fn([f64; 2]) -> f64,
    start: [f64; 2],
    sides: [f64; 2],
) -> Vertex {
    let vertex = |at: [f64; 2]| (at, function(at));
    let mut simplex = [
        vertex(start),
        vertex([start[0] + sides[0], start[1]]),
        vertex([start[0], start[1] + sides[1]]),
    ];
    for _ in 0..STEPS {
        simplex.sort_by(|a, b| a.1.total_cmp(&b.1));
        let [best, good, worst] = simplex;
        let side = |k: usize| {
            (good.0[k] - best.0[k])
                .abs()
                .max((worst.0[k] - best.0[k]).abs())
        };
        if side(0).max(side(1)) < LEAST_SIDE {
            break;
        }
        // The place at a part of the way from the worst vertex through the middle of the others.
        let along = |part: f64| {
            vertex([0, 1].map(|k| {
                let middle = 0.5 * (best.0[k] + good.0[k]);
                middle + part * (middle - worst.0[k])
            }))
        };
        let reflected = along(1.0);
        let candidate = if reflected.1 < best.1 {
            let expanded = along(2.0);
            Some(if expanded.1 < reflected.1 {
                expanded
            } else {
                reflected
            })
        } else if reflected.1 < good.1 {
            Some(reflected)
        } else if reflected.1 < worst.1 {
            Some(along(0.5)).filter(|outside| outside.1 <= reflected.1)
        } else {
            Some(along(-0.5)).filter(|inside| inside.1 < worst.1)
        };
        if let Some(candidate) = candidate {
            simplex[2] = candidate;
        } else {
            for place in &mut simplex[1..] {
                *place = vertex([0, 1].map(|k| 0.5 * (place.0[k] + best.0[k])));
            }
        }
    }
    simplex.sort_by(|a, b| a.1.total_cmp(&b.1));
    simplex[0]
}

#[cfg(test)]
mod tests {
    use super::minimise;

    #[test]
    fn the_valley_of_rosenbrock_is_followed() {
        let valley = |[x, y]: [f64; 2]| 100.0 * (y - x * x).powi(2) + (1.0 - x).powi(2);
        let ([x, y], least) = minimise(valley, [-1.2, 1.0], [0.1, 0.1]);
        assert!((x - 1.0).abs() < 1e-6 && (y - 1.0).abs() < 1e-6 && least < 1e-12);
    }
}
