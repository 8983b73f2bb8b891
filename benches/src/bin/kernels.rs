//! Runs one kernel over and over, for tools that count instructions: `kernels --list`,
//! `kernels KERNEL CONTENDER ROUNDS`.

use std::hint::black_box;

use anyhow::{Context, Result};
use clap::Parser;
use ga_runtime::cga3::{Infinity, Line, Plane, Point, Sphere};
use ga_runtime::ga;
use nullcone_benches::inputs::{self, INPUTS, Numbers};
use nullcone_benches::precision::Precision;

ga! { ga_runtime::cga3;
    /// A motor that moves many points.
    fn moving(uniform m: Motor, p: Point) -> Point { m * p * rev(m) }
    /// The circle through three points.
    fn circle(p: Point, q: Point, r: Point) -> Circle { p ^ q ^ r }
    /// The sphere through four points.
    fn sphere(p: Point, q: Point, r: Point, s: Point) -> Sphere { p ^ q ^ r ^ s }
}

/// Runs one kernel over and over.
#[derive(Parser)]
struct Arguments {
    /// Print kernels, contenders and the number of inputs of a round, separated by tabs.
    #[arg(long)]
    list: bool,
    /// The kernel.
    kernel: Option<String>,
    /// Who performs it.
    contender: Option<String>,
    /// How often it goes through all inputs.
    #[arg(default_value_t = 1)]
    rounds: usize,
}

/// A kernel that can go through all of its inputs.
struct Kernel {
    name: String,
    contender: &'static str,
    round: Box<dyn FnMut()>,
}

fn main() -> Result<()> {
    let arguments = Arguments::parse();
    let mut all = kernels::<f32>();
    all.extend(kernels::<f64>());
    if arguments.list {
        for kernel in all {
            println!("{}\t{}\t{INPUTS}", kernel.name, kernel.contender);
        }
        return Ok(());
    }
    let (name, contender) = arguments
        .kernel
        .zip(arguments.contender)
        .context("name a kernel and a contender; --list shows them")?;
    let mut kernel = all
        .into_iter()
        .find(|kernel| kernel.name == name && kernel.contender == contender)
        .with_context(|| format!("there is no kernel `{name}` of `{contender}`"))?;
    for _ in 0..arguments.rounds {
        (kernel.round)();
    }
    Ok(())
}

fn kernels<S: Precision>() -> Vec<Kernel> {
    let motors = inputs::list(1, Numbers::motor::<S>);
    let points = inputs::list(2, |numbers| [(); 4].map(|()| numbers.point::<S>()));
    let single: Vec<Point<S>> = points.iter().map(|[p, ..]| *p).collect();
    let lines: Vec<Line<S>> = points.iter().map(|[p, q, ..]| *p ^ *q ^ Infinity).collect();
    let planes: Vec<Plane<S>> = points
        .iter()
        .map(|[p, q, r, _]| *p ^ *q ^ *r ^ Infinity)
        .collect();
    let spheres: Vec<Sphere<S>> = points
        .iter()
        .map(|[p, q, r, s]| *p ^ *q ^ *r ^ *s)
        .collect();
    let circles: Vec<_> = points.iter().map(|[p, q, r, _]| *p ^ *q ^ *r).collect();
    let generators: Vec<_> = motors.iter().map(|m| m.log()).collect();
    let matrices: Vec<_> = motors.iter().map(|m| S::matrix(m.to_matrix())).collect();
    let affines: Vec<_> = motors.iter().map(|m| S::affine(m.to_matrix())).collect();
    let vectors: Vec<_> = single.iter().map(|p| S::vector(p.coordinates())).collect();

    let mut list = Kernels::<S>::default();
    list.pairs(
        "motor ≫ point",
        "nullcone",
        motors.clone(),
        single.clone(),
        |m, p| m.transform(*p),
    );
    list.pairs(
        "motor ≫ point",
        S::MATRIX,
        matrices,
        vectors.clone(),
        S::by_matrix,
    );
    list.pairs(
        "motor ≫ line",
        "nullcone",
        motors.clone(),
        lines.clone(),
        |m, x| m.transform(*x),
    );
    list.pairs(
        "motor ≫ plane",
        "nullcone",
        motors.clone(),
        planes.clone(),
        |m, x| m.transform(*x),
    );
    list.pairs(
        "motor ≫ sphere",
        "nullcone",
        motors.clone(),
        spheres.clone(),
        |m, x| m.transform(*x),
    );
    list.pairs(
        "motor ≫ circle",
        "nullcone",
        motors.clone(),
        circles,
        |m, x| m.transform(*x),
    );
    list.pairs(
        "motor · motor",
        "nullcone",
        motors.clone(),
        motors.clone(),
        |a, b| *a * *b,
    );
    list.pairs(
        "motor · motor",
        S::AFFINE,
        affines.clone(),
        affines.clone(),
        S::affine_product,
    );
    list.pairs(
        "p ∧ q ∧ r",
        "nullcone",
        points.clone(),
        single.clone(),
        |[p, q, r, _], _| circle(*p, *q, *r),
    );
    list.pairs(
        "p ∧ q ∧ r ∧ s",
        "nullcone",
        points,
        single.clone(),
        |[p, q, r, s], _| sphere(*p, *q, *r, *s),
    );
    list.pairs(
        "sphere ∨ plane",
        "nullcone",
        spheres.clone(),
        planes,
        |s, p| *s & *p,
    );
    list.pairs("line ∨ sphere", "nullcone", lines, spheres, |l, s| {
        *l & *s
    });
    list.pairs(
        "log of a motor",
        "nullcone",
        motors.clone(),
        single.clone(),
        |m, _| m.log(),
    );
    list.pairs(
        "exp of a generator",
        "nullcone",
        generators,
        single.clone(),
        |g, _| g.exp(),
    );
    let (motor, affine) = (motors[0], affines[0]);
    let moving = moving(motor);
    list.pairs(
        "one motor ≫ points",
        "nullcone",
        single.clone(),
        single,
        move |p, _| moving.apply(*p),
    );
    list.pairs(
        "one motor ≫ points",
        S::AFFINE,
        vectors.clone(),
        vectors,
        move |p, _| S::by_affine(&affine, p),
    );
    list.kernels
}

struct Kernels<S> {
    kernels: Vec<Kernel>,
    precision: std::marker::PhantomData<S>,
}

impl<S> Default for Kernels<S> {
    fn default() -> Self {
        Self {
            kernels: Vec::new(),
            precision: std::marker::PhantomData,
        }
    }
}

impl<S: Precision> Kernels<S> {
    fn pairs<A: 'static, B: 'static, R: 'static>(
        &mut self,
        name: &str,
        contender: &'static str,
        left: Vec<A>,
        right: Vec<B>,
        operation: impl Fn(&A, &B) -> R + 'static,
    ) {
        let mut results: Vec<R> = left
            .iter()
            .zip(&right)
            .map(|(a, b)| operation(a, b))
            .collect();
        let round = move || {
            let (left, right) = (black_box(left.as_slice()), black_box(right.as_slice()));
            let results = black_box(results.as_mut_slice());
            for ((result, a), b) in results.iter_mut().zip(left).zip(right) {
                *result = operation(a, b);
            }
        };
        self.kernels.push(Kernel {
            name: format!("{name}, {}", S::NAME),
            contender,
            round: Box::new(round),
        });
    }
}
