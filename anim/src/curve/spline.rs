//! Piecewise cubic splines with two continuous derivatives (Cui, eqs 12–17).

use super::ends::{EndKind, Ends};
use super::error::{check_times, check_values};
use super::piecewise::{Curve, Outside};
use super::value::Value;
use crate::curve::CurveError;

impl<V: Value> Curve<V> {
    /// The cubic spline through keys: the curve of cubic pieces with continuous first and second
    /// derivatives (Cui, eqs. 12, 13 and 17), in O(n). Two keys are enough.
    ///
    /// # Errors
    ///
    /// Fewer than two keys, lists of different lengths, numbers that are not finite, times that do
    /// not rise, [`CurveError::NotPeriodic`] and [`CurveError::OutOfRange`].
    ///
    /// ```
    /// use ga_anim::curve::{Curve, Ends};
    /// use ga_runtime::vga3::Vector;
    /// let keys = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, 2.0, 1.0]].map(Vector::from);
    /// let path = Curve::spline(&[0.0, 1.0, 2.5], &keys, Ends::Natural)?;
    /// assert_eq!(path.value(1.0), keys[1]);
    /// assert_eq!(path.second_derivative(0.0), Vector::default());
    /// # Ok::<(), ga_anim::curve::CurveError>(())
    /// ```
    pub fn spline(times: &[f64], values: &[V], ends: Ends<V>) -> Result<Self, CurveError> {
        let system = SplineSystem::new(times, ends.kind())?;
        match ends {
            Ends::Slopes(slopes) => system.fit_with_slopes(values, slopes),
            _ => system.fit(values),
        }
    }
}

/// The linear system of all cubic splines with keys at the same times, factorised once.
///
/// With the durations hᵢ and the slopes δᵢ = (yᵢ₊₁ − yᵢ)/hᵢ, the second derivatives mᵢ at the keys
/// satisfy (Cui, eqs. 14 to 16 and fig. 3)
///
/// ```text
/// hᵢ₋₁ mᵢ₋₁ + 2 (hᵢ₋₁ + hᵢ) mᵢ + hᵢ mᵢ₊₁ = 6 (δᵢ − δᵢ₋₁).
/// ```
///
/// The conditions at the ends change the first and the last row. This tridiagonal system is
/// factorised without exchange of rows, which is stable as its diagonal dominates. Rows are
/// eliminated from both ends towards the middle at the same time (J. J. Dongarra et al., "LINPACK
/// Users' Guide", 1979, chapter 7): two chains of divisions run side by side. A periodic system is
/// the same with m₀ as a parameter, which its own row then determines.
///
/// ```
/// use ga_anim::curve::{EndKind, SplineSystem};
/// let system = SplineSystem::new(&[0.0, 1.0, 2.0, 4.0], EndKind::Natural)?;
/// let height = system.fit(&[0.0, 1.0, 0.0, 1.0])?;
/// let place = system.fit(&[[0.0, 0.0], [1.0, 3.0], [2.0, 5.0], [4.0, 9.0]])?;
/// assert_eq!((height.value(1.0), place.value(1.0)), (1.0, [1.0, 3.0]));
/// # Ok::<(), ga_anim::curve::CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SplineSystem {
    times: Vec<f64>,
    kind: EndKind,
    /// The durations between keys and their reciprocals.
    steps: Vec<[f64; 2]>,
    /// Of the inner keys: the first for key 1.
    rows: Vec<Row>,
    closing: Option<Closing>,
}

/// A row of the factorised system, divided by its pivot.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Row {
    before: f64,
    inverse: f64,
    after: f64,
}

/// What determines m₀ of a periodic spline.
#[derive(Clone, Debug, PartialEq)]
struct Closing {
    /// The solution for the coefficients of m₀ as the right side.
    response: Vec<f64>,
    inverse: f64,
}

impl SplineSystem {
    /// The factorised system for these times.
    ///
    /// # Errors
    ///
    /// Fewer than two keys, times that are not finite or do not rise,
    /// [`CurveError::OutOfRange`].
    pub fn new(times: &[f64], kind: EndKind) -> Result<Self, CurveError> {
        check_times(times, 2)?;
        let steps: Vec<_> = times
            .windows(2)
            .map(|pair| {
                let h = pair[1] - pair[0];
                [h, h.recip()]
            })
            .collect();
        let usable = |step: &[f64; 2]| step[0].is_finite() & step[1].is_finite();
        if let Some(key) = steps.iter().position(|step| !usable(step)) {
            return Err(CurveError::OutOfRange { key });
        }
        let mut rows: Vec<_> = steps
            .windows(2)
            .map(|pair| {
                let [before, after] = [pair[0][0], pair[1][0]];
                Row {
                    before,
                    inverse: 2.0 * (before + after),
                    after,
                }
            })
            .collect();
        change_ends(&mut rows, &steps, kind);
        factorise(&mut rows);
        let mut system = Self {
            times: times.to_vec(),
            kind,
            steps,
            rows,
            closing: None,
        };
        if kind == EndKind::Periodic {
            system.closing = Some(system.closing());
        }
        Ok(system)
    }

    /// The spline through values at the times of the system. Where slopes at the ends are to be
    /// given they are 0: the spline is clamped.
    ///
    /// # Errors
    ///
    /// Not one value for each time, numbers that are not finite, [`CurveError::NotPeriodic`] and
    /// [`CurveError::OutOfRange`].
    pub fn fit<V: Value>(&self, values: &[V]) -> Result<Curve<V>, CurveError> {
        self.solved(values, [V::zero(); 2])
    }

    /// The spline through values with these slopes at the first and the last key.
    ///
    /// # Errors
    ///
    /// As [`SplineSystem::fit`], and [`CurveError::SlopesNotTaken`] where the system is not of
    /// [`EndKind::Slopes`].
    pub fn fit_with_slopes<V: Value>(
        &self,
        values: &[V],
        slopes: [V; 2],
    ) -> Result<Curve<V>, CurveError> {
        if self.kind != EndKind::Slopes {
            return Err(CurveError::SlopesNotTaken);
        }
        for (key, slope) in [0, self.times.len() - 1].into_iter().zip(slopes) {
            for channel in 0..V::DIMENSION {
                let value = slope.component(channel);
                if !value.is_finite() {
                    return Err(CurveError::NotFinite {
                        what: "the slope",
                        key,
                        channel,
                        value,
                    });
                }
            }
        }
        self.solved(values, slopes)
    }

    fn solved<V: Value>(&self, values: &[V], slopes: [V; 2]) -> Result<Curve<V>, CurveError> {
        check_values("values", values, self.times.len())?;
        if self.kind == EndKind::Periodic {
            check_period(values)?;
        }
        // The slopes δᵢ of the lines between keys.
        let slope = |(pair, step): (&[V], &[f64; 2])| {
            map2(pair[1], pair[0], |to, from| (to - from) * step[1])
        };
        let lines: Vec<V> = values.windows(2).zip(&self.steps).map(slope).collect();
        // The half second derivatives c₂ at the keys.
        let mut bends = vec![V::zero(); values.len()];
        self.right_side(&lines, slopes, &mut bends);
        let inner = 1..bends.len() - 1;
        substitute(&self.rows, &mut bends[inner]);
        self.close(&lines, slopes, &mut bends);

        let pieces = self.steps.iter().enumerate().map(|(i, &[h, inverse])| {
            let (c2, next) = (bends[i], bends[i + 1]);
            let third = h * (1.0 / 3.0);
            let c1 = V::from_components(|k| {
                lines[i].component(k) - third * (2.0 * c2.component(k) + next.component(k))
            });
            let c3 = map2(next, c2, |next, c2| (next - c2) * (inverse * (1.0 / 3.0)));
            [values[i], c1, c2, c3]
        });
        let outside = match self.kind {
            EndKind::Periodic => Outside::Repeat,
            _ => Outside::Hold,
        };
        Curve::new(
            &self.times,
            pieces.collect(),
            values[values.len() - 1],
            outside,
        )
    }

    /// Half the right side of the rows of the inner keys, so that the solutions are c₂ = m/2.
    fn right_side<V: Value>(&self, lines: &[V], slopes: [V; 2], bends: &mut [V]) {
        for (bend, pair) in bends[1..].iter_mut().zip(lines.windows(2)) {
            *bend = map2(pair[1], pair[0], |after, before| 3.0 * (after - before));
        }
        let last = bends.len() - 1;
        if last < 2 {
            return;
        }
        let [h0, h1] = [self.steps[0][0], self.steps[1][0]];
        let [g0, g1] = [self.steps[last - 1][0], self.steps[last - 2][0]];
        match self.kind {
            EndKind::Slopes => {
                let first = map2(lines[0], slopes[0], |line, slope| 1.5 * (line - slope));
                let end = map2(slopes[1], lines[last - 1], |slope, line| {
                    1.5 * (slope - line)
                });
                bends[1] = map2(bends[1], first, |bend, part| bend - part);
                bends[last - 1] = map2(bends[last - 1], end, |bend, part| bend - part);
            }
            EndKind::NotAKnot if last > 2 => {
                bends[1] = map1(bends[1], |bend| bend * (h1 / (h0 + h1)));
                bends[last - 1] = map1(bends[last - 1], |bend| bend * (g1 / (g0 + g1)));
            }
            EndKind::NotAKnot | EndKind::Natural | EndKind::Periodic => {}
        }
    }

    /// Finds c₂ at the first and the last key.
    fn close<V: Value>(&self, lines: &[V], slopes: [V; 2], bends: &mut [V]) {
        let last = bends.len() - 1;
        let [h0, i0] = self.steps[0];
        let [g0, j0] = self.steps[last - 1];
        match (self.kind, last) {
            (EndKind::Natural, _) | (EndKind::NotAKnot | EndKind::Periodic, 1) => {}
            (EndKind::Slopes, 1) => {
                let [a, b] = [lines[0], lines[0]];
                let start = map2(a, slopes[0], |line, slope| (line - slope) * i0);
                let end = map2(slopes[1], b, |slope, line| (slope - line) * i0);
                bends[0] = map2(start, end, |start, end| 2.0 * start - end);
                bends[1] = map2(start, end, |start, end| 2.0 * end - start);
            }
            (EndKind::Slopes, _) => {
                let start = map2(lines[0], slopes[0], |line, slope| 3.0 * (line - slope) * i0);
                let end = map2(slopes[1], lines[last - 1], |slope, line| {
                    3.0 * (slope - line) * j0
                });
                bends[0] = map2(start, bends[1], |start, next| 0.5 * (start - next));
                bends[last] = map2(end, bends[last - 1], |end, next| 0.5 * (end - next));
            }
            (EndKind::NotAKnot, 2) => (bends[0], bends[2]) = (bends[1], bends[1]),
            (EndKind::NotAKnot, _) => {
                let [r0, r1] = [h0 * self.steps[1][1], g0 * self.steps[last - 2][1]];
                bends[0] = map2(bends[1], bends[2], |near, far| near + (near - far) * r0);
                bends[last] = map2(bends[last - 1], bends[last - 2], |near, far| {
                    near + (near - far) * r1
                });
            }
            (EndKind::Periodic, _) => {
                let Some(closing) = &self.closing else { return };
                let jump = map2(lines[0], lines[last - 1], |after, before| {
                    3.0 * (after - before)
                });
                let known = map2(bends[last - 1], bends[1], |before, after| {
                    g0 * before + h0 * after
                });
                let start = map2(jump, known, |jump, known| (jump - known) * closing.inverse);
                for (bend, &response) in bends[1..].iter_mut().zip(&closing.response) {
                    *bend = map2(*bend, start, |bend, start| bend - response * start);
                }
                (bends[0], bends[last]) = (start, start);
            }
        }
    }

    fn closing(&self) -> Closing {
        let last = self.steps.len();
        let [h0, g0] = [self.steps[0][0], self.steps[last - 1][0]];
        let mut response = vec![0.0; last - 1];
        let Some(inner) = response.len().checked_sub(1) else {
            return Closing {
                response,
                inverse: 0.0,
            };
        };
        response[0] += h0;
        response[inner] += g0;
        substitute(&self.rows, &mut response);
        let pivot = 2.0 * (h0 + g0) - g0 * response[inner] - h0 * response[0];
        Closing {
            response,
            inverse: pivot.recip(),
        }
    }
}

/// Changes the first and the last row for the conditions at the ends. The coefficients of the end
/// keys in them are not used.
fn change_ends(rows: &mut [Row], steps: &[[f64; 2]], kind: EndKind) {
    let count = rows.len();
    let (Some(h), Some(g)) = (
        steps.get(..2),
        steps.len().checked_sub(2).and_then(|i| steps.get(i..)),
    ) else {
        return;
    };
    let [h0, h1] = [h[0][0], h[1][0]];
    let [g1, g0] = [g[0][0], g[1][0]];
    match kind {
        EndKind::Natural | EndKind::Periodic => {}
        EndKind::Slopes => {
            rows[0].inverse -= 0.5 * h0;
            rows[count - 1].inverse -= 0.5 * g0;
        }
        EndKind::NotAKnot if count == 1 => rows[0].inverse = 3.0 * (h0 + h1),
        EndKind::NotAKnot => {
            rows[0] = Row {
                before: 0.0,
                inverse: h0 + 2.0 * h1,
                after: h1 - h0,
            };
            rows[count - 1] = Row {
                before: g1 - g0,
                inverse: g0 + 2.0 * g1,
                after: 0.0,
            };
        }
    }
    rows[0].before = 0.0;
    rows[count - 1].after = 0.0;
}

/// Replaces each row, whose pivot stands in `inverse`, by the row divided by its pivot after the
/// elimination of the rows before it, in the first half, or after it, in the second.
fn factorise(rows: &mut [Row]) {
    let middle = rows.len() / 2;
    let Some((centre, above, below)) = halves(rows, middle) else {
        return;
    };
    let (mut top, mut bottom) = (0.0, 0.0);
    let divided = |row: &mut Row, pivot: f64| {
        *row = Row {
            before: row.before / pivot,
            inverse: pivot.recip(),
            after: row.after / pivot,
        };
    };
    // Both halves in one loop, so that their divisions overlap.
    let mut down = above.iter_mut();
    let mut up = below.iter_mut().rev();
    loop {
        let (first, second) = (down.next(), up.next());
        if first.is_none() && second.is_none() {
            break;
        }
        if let Some(row) = first {
            divided(row, row.inverse - row.before * top);
            top = row.after;
        }
        if let Some(row) = second {
            divided(row, row.inverse - row.after * bottom);
            bottom = row.before;
        }
    }
    divided(
        centre,
        centre.inverse - centre.before * top - centre.after * bottom,
    );
}

/// Solves the factorised system in place.
fn substitute<V: Value>(rows: &[Row], values: &mut [V]) {
    let middle = rows.len() / 2;
    let Some(&centre) = rows.get(middle) else {
        return;
    };
    let count = rows.len().min(values.len());
    let (mut top, mut bottom) = (V::zero(), V::zero());
    let step = |value: V, inverse: f64, factor: f64, known: V| {
        map2(value, known, |value, known| {
            value * inverse - factor * known
        })
    };
    for i in 0..middle {
        let (row, other) = (rows[i], count - 1 - i);
        top = step(values[i], row.inverse, row.before, top);
        values[i] = top;
        if other > middle {
            let row = rows[other];
            bottom = step(values[other], row.inverse, row.after, bottom);
            values[other] = bottom;
        }
    }
    let known = map2(top, bottom, |top, bottom| {
        centre.before * top + centre.after * bottom
    });
    let solved = map2(values[middle], known, |value, known| {
        value * centre.inverse - known
    });
    values[middle] = solved;
    let (mut top, mut bottom) = (solved, solved);
    for distance in 1..=middle {
        let (i, other) = (middle - distance, middle + distance);
        top = step(values[i], 1.0, rows[i].after, top);
        values[i] = top;
        if other < count {
            bottom = step(values[other], 1.0, rows[other].before, bottom);
            values[other] = bottom;
        }
    }
}

/// The row in the middle, those before and those after it.
fn halves(rows: &mut [Row], middle: usize) -> Option<(&mut Row, &mut [Row], &mut [Row])> {
    if rows.is_empty() {
        return None;
    }
    let (above, rest) = rows.split_at_mut(middle);
    let (centre, below) = rest.split_first_mut()?;
    Some((centre, above, below))
}

fn check_period<V: Value>(values: &[V]) -> Result<(), CurveError> {
    let (start, end) = (values[0], values[values.len() - 1]);
    for channel in 0..V::DIMENSION {
        let [first, last] = [start.component(channel), end.component(channel)];
        if first != last {
            return Err(CurveError::NotPeriodic {
                channel,
                first,
                last,
            });
        }
    }
    Ok(())
}

#[inline(always)]
fn map1<V: Value>(value: V, f: impl Fn(f64) -> f64) -> V {
    V::from_components(|k| f(value.component(k)))
}

#[inline(always)]
fn map2<V: Value>(a: V, b: V, f: impl Fn(f64, f64) -> f64) -> V {
    V::from_components(|k| f(a.component(k), b.component(k)))
}
