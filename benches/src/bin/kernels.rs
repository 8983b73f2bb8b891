//! Runs one kernel repeatedly, for tools that count instructions: `kernels --list`,
//! `kernels KERNEL CONTENDER ROUNDS`.

use std::hint::black_box;

use anyhow::{Context, Result};
use clap::Parser;
use ga_runtime::cga3::{Infinity, Line, Motor, Plane, Point, Sphere};
use ga_runtime::ga;
use nullcone_benches::inputs::{self, INPUTS, Numbers};
use nullcone_benches::precision::Precision;
use nullcone_benches::scene;

ga! { ga_runtime::cga3;
    /// A motor that moves many points.
    fn moving(uniform m: Motor, p: Point) -> Point { m * p * rev(m) }
    /// The circle through three points.
    fn circle(p: Point, q: Point, r: Point) -> Circle { p ^ q ^ r }
    /// The sphere through four points.
    fn sphere(p: Point, q: Point, r: Point, s: Point) -> Sphere { p ^ q ^ r ^ s }
}

/// Runs one kernel repeatedly.
#[derive(Parser)]
struct Arguments {
    /// Print kernels, contenders and the number of inputs of a round, separated by tabs.
    #[arg(long)]
    list: bool,
    /// The kernel.
    kernel: Option<String>,
    /// The contender that performs it.
    contender: Option<String>,
    /// The number of passes through all inputs.
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
    all.extend(scenes());
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

/// The picture of the ray tracer, with as many pixels as other kernels have inputs.
fn scenes() -> Vec<Kernel> {
    let size = [32, INPUTS / 32];
    let contenders = scene::contenders().unwrap_or_default().into_iter();
    let kernel = |contender: scene::Contender| Kernel {
        name: "ray tracer, each pixel".into(),
        contender: contender.name,
        round: Box::new(move || {
            black_box((contender.render)(black_box(size)));
        }),
    };
    contenders.map(kernel).collect()
}

fn kernels<S: Precision>() -> Vec<Kernel> {
    let inputs = Inputs::<S>::new();
    let mut list = Kernels::default();
    list.actions(&inputs);
    list.products(&inputs);
    list.exponentials(&inputs);
    list.one_motor(&inputs);
    list.kernels
}

struct Inputs<S: Precision> {
    motors: Vec<Motor<S>>,
    points: Vec<[Point<S>; 4]>,
    single: Vec<Point<S>>,
    lines: Vec<Line<S>>,
    planes: Vec<Plane<S>>,
    spheres: Vec<Sphere<S>>,
    affines: Vec<S::Affine>,
    vectors: Vec<S::Vector>,
}

impl<S: Precision> Inputs<S> {
    fn new() -> Self {
        let motors = inputs::list(1, Numbers::motor::<S>);
        let points = inputs::list(2, |numbers| [(); 4].map(|()| numbers.point::<S>()));
        let single: Vec<Point<S>> = points.iter().map(|[p, ..]| *p).collect();
        let plane = |[p, q, r, _]: &[Point<S>; 4]| *p ^ *q ^ *r ^ Infinity;
        let sphere = |[p, q, r, s]: &[Point<S>; 4]| *p ^ *q ^ *r ^ *s;
        Self {
            lines: points.iter().map(|[p, q, ..]| *p ^ *q ^ Infinity).collect(),
            planes: points.iter().map(plane).collect(),
            spheres: points.iter().map(sphere).collect(),
            affines: motors.iter().map(|m| S::affine(m.to_matrix())).collect(),
            vectors: single.iter().map(|p| S::vector(p.coordinates())).collect(),
            motors,
            points,
            single,
        }
    }
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
    /// A motor moves an element.
    fn actions(&mut self, inputs: &Inputs<S>) {
        let motors = inputs.motors.iter();
        let matrices: Vec<_> = motors.map(|m| S::matrix(m.to_matrix())).collect();
        let points = inputs.points.iter();
        let circles: Vec<_> = points.map(|[p, q, r, _]| *p ^ *q ^ *r).collect();
        self.pairs(
            "motor ≫ point",
            "nullcone",
            inputs.motors.clone(),
            inputs.single.clone(),
            |m, p| m.transform(*p),
        );
        self.pairs(
            "motor ≫ point",
            S::MATRIX,
            matrices,
            inputs.vectors.clone(),
            S::by_matrix,
        );
        self.pairs(
            "motor ≫ line",
            "nullcone",
            inputs.motors.clone(),
            inputs.lines.clone(),
            |m, x| m.transform(*x),
        );
        self.pairs(
            "motor ≫ plane",
            "nullcone",
            inputs.motors.clone(),
            inputs.planes.clone(),
            |m, x| m.transform(*x),
        );
        self.pairs(
            "motor ≫ sphere",
            "nullcone",
            inputs.motors.clone(),
            inputs.spheres.clone(),
            |m, x| m.transform(*x),
        );
        self.pairs(
            "motor ≫ circle",
            "nullcone",
            inputs.motors.clone(),
            circles,
            |m, x| m.transform(*x),
        );
    }

    /// Geometric, outer and regressive products.
    fn products(&mut self, inputs: &Inputs<S>) {
        self.pairs(
            "motor · motor",
            "nullcone",
            inputs.motors.clone(),
            inputs.motors.clone(),
            |a, b| *a * *b,
        );
        self.pairs(
            "motor · motor",
            S::AFFINE,
            inputs.affines.clone(),
            inputs.affines.clone(),
            S::affine_product,
        );
        self.pairs(
            "p ∧ q ∧ r",
            "nullcone",
            inputs.points.clone(),
            inputs.single.clone(),
            |[p, q, r, _], _| circle(*p, *q, *r),
        );
        self.pairs(
            "p ∧ q ∧ r ∧ s",
            "nullcone",
            inputs.points.clone(),
            inputs.single.clone(),
            |[p, q, r, s], _| sphere(*p, *q, *r, *s),
        );
        self.pairs(
            "sphere ∨ plane",
            "nullcone",
            inputs.spheres.clone(),
            inputs.planes.clone(),
            |s, p| *s & *p,
        );
        self.pairs(
            "line ∨ sphere",
            "nullcone",
            inputs.lines.clone(),
            inputs.spheres.clone(),
            |l, s| *l & *s,
        );
    }

    fn exponentials(&mut self, inputs: &Inputs<S>) {
        let generators: Vec<_> = inputs.motors.iter().map(|m| m.log()).collect();
        self.pairs(
            "log of a motor",
            "nullcone",
            inputs.motors.clone(),
            inputs.single.clone(),
            |m, _| m.log(),
        );
        self.pairs(
            "exp of a generator",
            "nullcone",
            generators,
            inputs.single.clone(),
            |g, _| g.exp(),
        );
    }

    /// One motor moves many points.
    fn one_motor(&mut self, inputs: &Inputs<S>) {
        let (motor, affine) = (inputs.motors[0], inputs.affines[0]);
        let moving = moving(motor);
        self.pairs(
            "one motor ≫ points",
            "nullcone",
            inputs.single.clone(),
            inputs.single.clone(),
            move |p, _| moving.apply(*p),
        );
        self.pairs(
            "one motor ≫ points",
            S::AFFINE,
            inputs.vectors.clone(),
            inputs.vectors.clone(),
            move |p, _| S::by_affine(&affine, p),
        );
    }

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
