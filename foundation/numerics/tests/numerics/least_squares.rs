//! Least squares against certified values, and the elimination of groups against the whole matrix.

use ga_numerics::least_squares::{
    Attempt, Columns, Damping, Descent, Equations, LeastSquaresError, Loss, Options, Problem,
    Region, Search, minimise,
};
use proptest::prelude::*;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use statrs::distribution::{ContinuousCDF, Normal};

use super::ransac::unit;

/// Misra1a of the Statistical Reference Datasets of the National Institute of Standards and
/// Technology: monomolecular adsorption, `y = b1 (1 − exp(−b2 x))`.
const MISRA1A: [[f64; 2]; 14] = [
    [10.07, 77.6],
    [14.73, 114.9],
    [17.94, 141.1],
    [23.93, 190.8],
    [29.61, 239.9],
    [35.18, 289.0],
    [40.02, 332.8],
    [44.82, 378.4],
    [50.76, 434.8],
    [55.05, 477.3],
    [61.01, 536.8],
    [66.40, 593.1],
    [75.47, 689.1],
    [81.78, 760.0],
];

struct Adsorption;

impl Problem for Adsorption {
    type State = [f64; 2];

    fn columns(&self) -> Columns {
        Columns::dense(2)
    }

    fn evaluate(&self, [b1, b2]: &[f64; 2], equations: &mut Equations) -> Option<()> {
        for [y, x] in MISRA1A {
            let decay = (-b2 * x).exp();
            let derivatives = [(0, [1.0 - decay]), (1, [b1 * x * decay])];
            equations.add([b1 * (1.0 - decay) - y], &derivatives);
        }
        Some(())
    }

    fn stepped(&self, state: &[f64; 2], step: &[f64]) -> Option<[f64; 2]> {
        Some([state[0] + step[0], state[1] + step[1]])
    }
}

#[test]
fn the_certified_values_are_found_from_both_starts() {
    for start in [[500.0, 0.0001], [250.0, 0.0005]] {
        let minimum = minimise(&Adsorption, start, &Options::default()).unwrap();
        let close = |found: f64, certified: f64| (found / certified - 1.0).abs() < 1e-8;
        assert!(close(minimum.state[0], 2.3894212918e2), "{minimum:?}");
        assert!(close(minimum.state[1], 5.5015643181e-4), "{minimum:?}");
        assert!(close(minimum.cost, 1.2455138894e-1), "{minimum:?}");
        let variance = minimum.variance().unwrap();
        assert!(close(variance.sqrt(), 1.0187876330e-1));
        let covariance = minimum.covariance(variance).unwrap();
        assert!(close(covariance.standard_deviation(0), 2.7070075241));
        assert!(close(covariance.standard_deviation(1), 7.2668688436e-6));
    }
}

/// Lines `y = a x + b_g + c_g x²` with a slope that all groups share.
struct Lines {
    grouped: bool,
    groups: Vec<Vec<[f64; 2]>>,
}

impl Problem for Lines {
    type State = Vec<f64>;

    fn columns(&self) -> Columns {
        match self.grouped {
            true => Columns::grouped(1, self.groups.len(), 2),
            false => Columns::dense(1 + 2 * self.groups.len()),
        }
    }

    fn evaluate(&self, state: &Vec<f64>, equations: &mut Equations) -> Option<()> {
        for (group, points) in self.groups.iter().enumerate() {
            let (offset, bend) = (1 + 2 * group, 2 + 2 * group);
            for [x, y] in points {
                // The exponential makes the problem nonlinear.
                let model = state[0].exp() * x + state[offset] + state[bend] * x * x;
                let derivatives = [(bend, [x * x]), (0, [state[0].exp() * x]), (offset, [1.0])];
                equations.add([model - y], &derivatives);
            }
        }
        Some(())
    }

    fn stepped(&self, state: &Vec<f64>, step: &[f64]) -> Option<Vec<f64>> {
        Some(state.iter().zip(step).map(|(a, b)| a + b).collect())
    }
}

proptest! {
    #[test]
    fn eliminated_groups_give_the_solution_of_the_whole(
        groups in prop::collection::vec(
            prop::collection::vec(prop::array::uniform2(-3.0..3.0), 6),
            1..4,
        ),
    ) {
        let solve = |grouped| {
            let groups = groups.clone();
            let start = vec![0.0; 1 + 2 * groups.len()];
            minimise(&Lines { grouped, groups }, start, &Options::default())
        };
        let (Ok(a), Ok(b)) = (solve(true), solve(false)) else { return Ok(()) };
        prop_assert!((a.cost - b.cost).abs() <= 1e-9 * a.cost);
        let (Some(first), Some(second)) = (a.covariance(1.0), b.covariance(1.0)) else {
            return Ok(());
        };
        prop_assume!(first.shared(0, 0) < 1e3);
        for (a, b) in a.state.iter().zip(&b.state) {
            prop_assert!((a - b).abs() < 1e-6 * (1.0 + a.abs()), "{a} {b}");
        }
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-6 * (a.abs() + b.abs()) + 1e-9;
        prop_assert!(close(first.shared(0, 0), second.shared(0, 0)));
        for group in 0..groups.len() {
            for (row, column) in [(0, 0), (1, 0), (1, 1)] {
                let place = 1 + 2 * group;
                let whole = second.shared(place + row, place + column);
                prop_assert!(close(first.group(group, row, column), whole));
            }
        }
    }
}

/// The mean of numbers.
struct Mean(Vec<f64>);

impl Problem for Mean {
    type State = f64;

    fn columns(&self) -> Columns {
        Columns::dense(1)
    }

    fn evaluate(&self, state: &f64, equations: &mut Equations) -> Option<()> {
        for number in &self.0 {
            equations.add([state - number], &[(0, [1.0])]);
        }
        Some(())
    }

    fn stepped(&self, state: &f64, step: &[f64]) -> Option<f64> {
        Some(state + step[0])
    }
}

#[test]
fn an_outlier_counts_less() {
    let numbers = Mean(vec![-1.0, 0.0, 1.0, 100.0]);
    let with = |loss| {
        let options = Options {
            loss,
            ..Options::default()
        };
        minimise(&numbers, 0.0, &options).unwrap().state
    };
    assert!((with(Loss::Squares) - 25.0).abs() < 1e-9);
    // Three numbers within the scale h pull by 3 m, the outlier by h.
    assert!((with(Loss::Huber(1.5)) - 0.5).abs() < 1e-9);
    assert!(with(Loss::Cauchy(1.0)).abs() < 0.02);
    // Where Σ ρ′(m − x) vanishes between -0.5 and 0.5, by bisection.
    let balanced = |pull: fn(f64) -> f64| {
        let sum = |m: f64| numbers.0.iter().map(|x| pull(m - x)).sum::<f64>();
        let [mut low, mut high] = [-0.5, 0.5];
        for _ in 0..60 {
            let middle = (low + high) / 2.0;
            *(if sum(middle) < 0.0 {
                &mut low
            } else {
                &mut high
            }) = middle;
        }
        low
    };
    // With h² = 9: ρ = 9 ln(1 + s²/9), and ρ = 9 s² / (9 + s²).
    let cauchy = balanced(|s| 18.0 * s / (9.0 + s * s));
    assert!((with(Loss::Cauchy(3.0)) - cauchy).abs() < 1e-6);
    let geman_mcclure = balanced(|s| 162.0 * s / (9.0 + s * s).powi(2));
    assert!((with(Loss::GemanMcClure(3.0)) - geman_mcclure).abs() < 1e-6);
    assert!(geman_mcclure.abs() < 1e-3 && cauchy > 0.01);
}

#[test]
fn what_has_no_minimum_is_an_error() {
    let few = minimise(&Mean(vec![]), 0.0, &Options::default());
    assert!(matches!(
        few,
        Err(LeastSquaresError::TooFewResiduals {
            residuals: 0,
            unknowns: 1
        })
    ));
    let start = minimise(&Mean(vec![f64::NAN]), 0.0, &Options::default());
    assert!(matches!(start, Err(LeastSquaresError::Start)));
    let hasty = Options {
        steps: 2,
        ..Options::default()
    };
    let found = minimise(&Adsorption, [500.0, 0.0001], &hasty);
    assert!(matches!(
        found,
        Err(LeastSquaresError::NotConverged { steps: 2, .. })
    ));
}

/// exp(x) has an infimum and no minimum.
struct Endless;

impl Problem for Endless {
    type State = f64;

    fn columns(&self) -> Columns {
        Columns::dense(1)
    }

    fn evaluate(&self, state: &f64, equations: &mut Equations) -> Option<()> {
        // A state below 0 does not exist, so that the search runs into a wall.
        (*state >= 0.0).then(|| equations.add([state.exp()], &[(0, [state.exp()])]))
    }

    fn stepped(&self, state: &f64, step: &[f64]) -> Option<f64> {
        Some(state + step[0])
    }
}

#[test]
fn a_wall_is_not_a_minimum() {
    let found = minimise(&Endless, 3.0, &Options::default());
    assert!(
        matches!(found, Err(LeastSquaresError::NotConverged { .. })),
        "{found:?}"
    );
}

/// A valley along the parabola y = x², of the width w: x has the variance 1, and y the second
/// moment w² + E[x⁴] = w² + 3. To first order the moment of y is w² alone.
struct Parabola {
    width: f64,
}

impl Problem for Parabola {
    type State = [f64; 2];

    fn columns(&self) -> Columns {
        Columns::dense(2)
    }

    fn evaluate(&self, [x, y]: &[f64; 2], equations: &mut Equations) -> Option<()> {
        equations.add([*x], &[(0, [1.0])]);
        let across = (y - x * x) / self.width;
        let derivatives = [(0, [-2.0 * x / self.width]), (1, [1.0 / self.width])];
        equations.add([across], &derivatives);
        Some(())
    }

    fn stepped(&self, [x, y]: &[f64; 2], step: &[f64]) -> Option<[f64; 2]> {
        Some([x + step[0], y + step[1]])
    }
}

#[test]
fn a_valley_that_bends_is_wider_than_it_is_across() {
    for width in [0.5, 1.0, 2.0] {
        let problem = Parabola { width };
        let minimum = minimise(&problem, [0.0, 0.0], &Options::default()).unwrap();
        let first = minimum.covariance(1.0).unwrap();
        assert!((first.shared(1, 1) - width * width).abs() < 1e-12);
        let curved = minimum
            .curved_covariance(&problem, 1.0, Region::Ellipsoid)
            .unwrap();
        let [x, xy, y] = [(0, 0), (0, 1), (1, 1)].map(|(i, j)| curved.shared(i, j));
        let ratio = (width * width + 3.0) / 1.0;
        assert!((y / x - ratio).abs() < 0.1 * ratio, "{width}: {x} {y}");
        assert!(xy.abs() < 0.05 * (x * y).sqrt(), "{xy}");
        // Errors as they are: x of the valley, and what is across it.
        let mut random = ChaCha8Rng::seed_from_u64(3);
        let normal = Normal::standard();
        let mut number = || normal.inverse_cdf(unit(&mut random));
        let mut within = 0;
        for _ in 0..20_000 {
            let (along, across) = (number(), width * number());
            let error = [along, across + along * along];
            let square = (y * error[0].powi(2) - 2.0 * xy * error[0] * error[1]
                + x * error[1].powi(2))
                / (x * y - xy * xy);
            within += u32::from(square <= 5.991_465);
        }
        let part = f64::from(within) / 20_000.0;
        assert!((part - 0.95).abs() < 0.015, "{width}: {part}");
    }
}

/// A valley along x whose end is beyond all numbers that its residuals determine.
#[test]
fn a_hollow_in_a_wide_valley_determines_nothing() {
    /// The first residual ends at 1.
    struct Horizon;
    impl Problem for Horizon {
        type State = f64;

        fn columns(&self) -> Columns {
            Columns::dense(1)
        }

        fn evaluate(&self, x: &f64, equations: &mut Equations) -> Option<()> {
            equations.add([x.tanh()], &[(0, [x.cosh().powi(-2)])]);
            Some(())
        }

        fn stepped(&self, x: &f64, step: &[f64]) -> Option<f64> {
            Some(x + step[0])
        }
    }
    let minimum = minimise(&Horizon, 0.1, &Options::default()).unwrap();
    let first = minimum.covariance(1.0).unwrap().shared(0, 0);
    assert!((first - 1.0).abs() < 1e-9);
    assert!(
        minimum
            .curved_covariance(&Horizon, 1.0, Region::Ellipsoid)
            .is_none()
    );
    // Errors far below the horizon are as to first order.
    let near = minimum
        .curved_covariance(&Horizon, 1e-4, Region::Ellipsoid)
        .unwrap();
    assert!((near.shared(0, 0) - 1e-4).abs() < 1e-5);
}

/// Squares of numbers about a level, each with a number of its own: `x` of `e^x`, with groups that
/// are as free as they can be.
struct Exponents {
    levels: Vec<f64>,
}

impl Problem for Exponents {
    type State = Vec<f64>;

    fn columns(&self) -> Columns {
        Columns::grouped(1, self.levels.len(), 1)
    }

    fn evaluate(&self, state: &Vec<f64>, equations: &mut Equations) -> Option<()> {
        let scale = state[0].exp();
        for (k, level) in self.levels.iter().enumerate() {
            // The scale, with an offset of each group, and the offset.
            let own = state[1 + k];
            equations.add([scale + own - level], &[(0, [scale]), (1 + k, [1.0])]);
            equations.add([own], &[(1 + k, [1.0])]);
        }
        Some(())
    }

    fn stepped(&self, state: &Vec<f64>, step: &[f64]) -> Option<Vec<f64>> {
        Some(state.iter().zip(step).map(|(a, b)| a + b).collect())
    }
}

/// With the groups at their best, the levels have the variance 2 about `e^x`, and their mean is
/// normal: x is its logarithm.
#[test]
fn intervals_follow_groups_along_a_logarithm() {
    let problem = Exponents {
        levels: vec![6.0; 8],
    };
    let start = vec![1.0; 9];
    let minimum = minimise(&problem, start, &Options::default()).unwrap();
    assert!((minimum.state[0] - 6_f64.ln()).abs() < 1e-9);
    // A mean with the deviation √(2 · 9/8) = 1.5.
    let first = minimum.covariance(9.0).unwrap().standard_deviation(0);
    assert!((first - 0.25).abs() < 1e-9, "{first}");
    let found = minimum.curved_covariance(&problem, 9.0, Region::Intervals);
    let found = 1.959_964 * found.unwrap().standard_deviation(0);
    // 95 % of all x = ln(6 + 1.5 z) are within this of ln 6, by the normal distribution.
    let normal = Normal::standard();
    let place = |x: f64| (6.0 * x.exp() - 6.0) / 1.5;
    let part = normal.cdf(place(found)) - normal.cdf(place(-found));
    assert!((part - 0.95).abs() < 0.015, "{found}: {part}");
    // That of the first order is too short.
    let part = normal.cdf(place(1.96 * first)) - normal.cdf(place(-1.96 * first));
    assert!(part < 0.942, "{part}");
}

/// A residual of 3 with the scale 2, by hand; the weight of each loss is its derivative.
#[test]
fn losses_are_those_of_their_formulas() {
    let near = |a: f64, b: f64| (a - b).abs() < 1e-12 * (1.0 + b.abs());
    for (loss, expected) in [
        (Loss::Squares, 9.0),
        (Loss::Huber(2.0), 2.0 * (2.0 * 3.0 - 2.0)),
        (Loss::Cauchy(2.0), 4.0 * 3.25f64.ln()),
        (Loss::GemanMcClure(2.0), 9.0 / 3.25),
    ] {
        let (value, weight) = loss.of(9.0);
        assert!(near(value, expected), "{loss:?}: {value} {expected}");
        let step = 1e-5;
        let slope = (loss.of(9.0 + step).0 - loss.of(9.0 - step).0) / (2.0 * step);
        assert!((weight - slope).abs() < 1e-8, "{loss:?}: {weight} {slope}");
    }
    // Small residuals are squares, and Huber's loss goes on where it bends.
    assert_eq!(Loss::Huber(2.0).of(3.0), (3.0, 1.0));
    assert_eq!(Loss::Huber(2.0).of(4.0), (4.0, 1.0));
    assert!(near(Loss::Huber(2.0).of(4.0 + 1e-12).0, 4.0));
}

/// Steps that are what they are told to be.
struct Told(Attempt, usize);

impl Descent for Told {
    fn attempt(&mut self, _: f64) -> Attempt {
        self.0
    }

    fn accept(&mut self) {
        self.1 += 1;
    }
}

#[test]
fn a_fall_that_rounding_hides_is_taken_only_while_steps_become_smaller() {
    let damping = Damping {
        first: 1.0,
        least: 1e-12,
        greatest: 1e12,
    };
    // At a cost of 1 a fall below 10⁻¹⁰ is lost in rounding.
    let attempt = |size, predicted, cost| Attempt {
        size,
        predicted,
        is_small: false,
        cost,
    };
    let mut search = Search::new(1.0, damping);
    let mut accepted = |attempt| search.step(&mut Told(attempt, 0)).is_accepted;
    // The first step of a search is smaller than none before.
    assert!(accepted(attempt(1.0, 1e-12, 1.0 + 1e-12)));
    assert!(!accepted(attempt(1.0, 1e-12, 1.0 + 1e-12)), "not smaller");
    assert!(accepted(attempt(0.5, 1e-12, 1.0 + 1e-12)));
    assert!(
        !accepted(attempt(0.1, 1e-3, 1.0 + 2e-12)),
        "a fall was predicted"
    );
    assert!(
        !accepted(attempt(0.1, 1e-12, 1.0 + 1e-6)),
        "beyond rounding"
    );
    assert!(accepted(attempt(9.0, 1e-3, 1.0 - 1e-3)), "a fall is a fall");
}

#[test]
fn the_damping_follows_the_gain() {
    let limits = Damping {
        first: 1.0,
        least: 0.05,
        greatest: 50.0,
    };
    let attempt = |cost| Attempt {
        size: 1.0,
        predicted: 0.5,
        is_small: false,
        cost,
    };
    // As predicted: 1 − (2 − 1)³ = 0, at least a tenth. Half of it: 1 − 0³ = 1. A tenth of it:
    // 1 + 0.8³ = 1.512. Nothing of it: twice, then four times, then eight times.
    for (fall, factor) in [(0.5, 0.1), (0.25, 1.0), (0.05, 1.512)] {
        let mut search = Search::new(10.0, limits);
        let mut told = Told(attempt(10.0 - fall), 0);
        assert!(search.step(&mut told).is_accepted);
        assert_eq!(told.1, 1);
        let mut next = Observed(attempt(11.0), Vec::new());
        for _ in 0..4 {
            assert!(!search.step(&mut next).is_accepted);
        }
        let expected = [1.0, 2.0, 8.0, 64.0].map(|growth| factor * growth);
        for (found, expected) in next.1.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
        assert!(search.is_exhausted());
    }
    let mut search = Search::new(10.0, limits);
    for cost in [9.5, 9.0, 8.5] {
        search.step(&mut Told(attempt(cost), 0));
    }
    let mut next = Observed(attempt(99.0), Vec::new());
    search.step(&mut next);
    assert_eq!(next.1, [0.05]);
}

/// The dampings that a search tries.
struct Observed(Attempt, Vec<f64>);

impl Descent for Observed {
    fn attempt(&mut self, damping: f64) -> Attempt {
        self.1.push(damping);
        self.0
    }

    fn accept(&mut self) {}
}

/// Lines `y = a x + b_g` whose derivative by the slope is given in two parts.
struct Straight {
    places: Vec<Vec<[f64; 2]>>,
}

impl Problem for Straight {
    type State = Vec<f64>;

    fn columns(&self) -> Columns {
        Columns::grouped(1, self.places.len(), 1)
    }

    fn evaluate(&self, state: &Vec<f64>, equations: &mut Equations) -> Option<()> {
        for (group, points) in self.places.iter().enumerate() {
            for [x, y] in points {
                let residual = state[0] * x + state[1 + group] - y;
                let derivatives = [(0, [0.25 * x]), (1 + group, [1.0]), (0, [0.75 * x])];
                equations.add([residual], &derivatives);
            }
        }
        Some(())
    }

    fn stepped(&self, state: &Vec<f64>, step: &[f64]) -> Option<Vec<f64>> {
        Some(state.iter().zip(step).map(|(a, b)| a + b).collect())
    }
}

/// Without a bend the covariance is that of a line with offsets, variance / Σ (x − mean x)².
#[test]
fn residuals_that_are_linear_have_their_covariance_to_first_order() {
    let places = vec![
        vec![[0.0, 1.0], [1.0, 2.5], [2.0, 2.0]],
        vec![[-1.0, 0.0], [3.0, 4.5]],
    ];
    let problem = Straight { places };
    let minimum = minimise(&problem, vec![0.0; 3], &Options::default()).unwrap();
    for variance in [1.0, 0.04, 9.0] {
        for region in [Region::Ellipsoid, Region::Intervals] {
            let covariance = minimum
                .curved_covariance(&problem, variance, region)
                .unwrap();
            let expected = variance / (2.0 + 8.0);
            let found = covariance.shared(0, 0);
            assert!(
                (found - expected).abs() < 1e-9 * expected,
                "{found} {expected}"
            );
        }
    }
}
