//! `bench_product!`, run with a stand-in for criterion that records its calls.

use std::cell::Cell;

use ga_runtime::cga3::{Motor, Point};
use ga_runtime::testing::{bench_product, cga3, member, sample, strategy};

/// The part of criterion that the macro uses.
mod stand_in {
    #[derive(Debug, PartialEq)]
    pub(super) enum Throughput {
        Elements(u64),
    }

    #[derive(Default)]
    pub(super) struct Criterion {
        pub(super) log: Vec<String>,
    }

    pub(super) struct Group<'a> {
        criterion: &'a mut Criterion,
        name: String,
    }

    pub(super) struct Bencher;

    impl Criterion {
        pub(super) fn benchmark_group(&mut self, name: impl Into<String>) -> Group<'_> {
            Group {
                criterion: self,
                name: name.into(),
            }
        }
    }

    impl Group<'_> {
        pub(super) fn throughput(&mut self, throughput: Throughput) {
            self.criterion.log.push(format!("{throughput:?}"));
        }

        pub(super) fn bench_function(&mut self, id: &str, mut function: impl FnMut(&mut Bencher)) {
            self.criterion.log.push(format!("{}/{id}", self.name));
            function(&mut Bencher);
        }

        pub(super) fn finish(self) {
            self.criterion.log.push("done".into());
        }
    }

    impl Bencher {
        pub(super) fn iter<R>(&mut self, mut routine: impl FnMut() -> R) {
            routine();
            routine();
        }
    }
}

#[test]
fn operations_are_registered_and_run() {
    let mut criterion = stand_in::Criterion::default();
    let (calls, rival_calls, conversions) = (Cell::new(0), Cell::new(0), Cell::new(0));
    let count = |counter: &Cell<usize>| counter.set(counter.get() + 1);
    bench_product!(
        criterion = stand_in;
        &mut criterion,
        "motor, point",
        |motor: Motor<f64>, point: Point<f64>| { count(&calls); motor.transform(point) },
        rival "matrix" with rows = { count(&conversions); motor.to_matrix() }, place = point.coordinates() => {
            count(&rival_calls);
            rows.map(|row| row[0] * place[0] + row[1] * place[1] + row[2] * place[2] + row[3])
        },
        rival "twice" => motor.transform(motor.transform(point)),
    );
    let expected = [
        "Elements(1024)",
        "motor, point/product",
        "motor, point/matrix",
        "motor, point/twice",
        "done",
    ];
    assert_eq!(criterion.log, expected);
    // Once to allocate the results, and once in each of two passes; conversions are done before.
    assert_eq!(
        (calls.get(), rival_calls.get(), conversions.get()),
        (3072, 3072, 1024)
    );
}

#[test]
fn operands_are_those_of_the_seed() {
    let drawn = |seed: Option<u64>| {
        let mut criterion = stand_in::Criterion::default();
        let seen = std::cell::RefCell::new(Vec::new());
        let see = |motor: Motor<f32>| seen.borrow_mut().push(motor);
        match seed {
            Some(seed) => bench_product!(
                criterion = self::stand_in;
                criterion, "motors", seed = seed, |motor: Motor<f32>| see(motor)
            ),
            None => bench_product!(
                criterion = stand_in; criterion, String::from("motors"), |motor: Motor<f32>| see(motor)
            ),
        }
        seen.into_inner()
    };
    let first = drawn(None);
    assert_eq!(first, drawn(Some(1)));
    assert_eq!(first[..1024], first[2048..]);
    assert_ne!(first, drawn(Some(2)));
    let distinct = first[..1024].windows(2).filter(|pair| pair[0] != pair[1]);
    assert!(distinct.count() > 1000);
}

#[test]
fn operands_may_be_drawn_otherwise() {
    let mut criterion = stand_in::Criterion::default();
    let largest = Cell::new(0.0_f64);
    let range = -3.0..3.0_f64;
    bench_product!(
        criterion = stand_in;
        criterion,
        "on the way",
        |a: Motor<f64> = (cga3::motors(10.0)), b: Motor<f64>, t: f64 = (range)| {
            largest.set(largest.get().max(t.abs()));
            a.interpolate(b, t)
        },
    );
    assert!(largest.get() > 2.5 && largest.get() < 3.0);
}

#[test]
fn samples_have_the_size_asked_for() {
    let motors = member::<Motor<f64>>(strategy::float(0.9));
    assert_eq!(sample(&motors, 0, 1), []);
    assert_eq!(sample(&motors, 5, 1), sample(&motors, 9, 1)[..5]);
}
