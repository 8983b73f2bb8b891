//! Skins: 100,000 vertices with four influences on 64 joints, the human of the shared data with its
//! painted weights, and a million vertices on one and on two threads.
//!
//! The rival is a plain loop with glam: the sum of the matrices times their weights, then
//! `transform_point3`. Every frame takes new motions, and their preparation is timed with it.

use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use ga_anim::rig;
use ga_anim::skin::{Binding, Method, Posed};
use ga_anim::weights::SkinWeights;
use ga_mesh::obj;
use ga_runtime::batch::skin::{AffinePalette, MotorPalette, Skin};
use ga_runtime::batch::{Batch, InstructionSet};
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use glam::{Mat4, Vec3};
use nullcone_benches::comparison;
use nullcone_benches::inputs::Numbers;
use nullcone_shared_data::shared;

/// A mesh at rest, and the motions of a frame.
struct Scene {
    points: Vec<Point<f32>>,
    normals: Vec<Vector<f32>>,
    weights: SkinWeights,
    motions: Vec<Motor<f32>>,
    matrices: Vec<Mat4>,
}

impl Scene {
    fn new(points: Vec<Point<f32>>, weights: SkinWeights) -> Self {
        let mut numbers = Numbers::new(1);
        let motions: Vec<Motor<f32>> = (0..weights.joint_count())
            .map(|_| numbers.motor::<f32>())
            .collect();
        let normals = points.iter().map(|&point| Vector::from(point)).collect();
        let matrices = motions
            .iter()
            .map(|motion| matrix(motion.to_matrix()))
            .collect();
        Self {
            points,
            normals,
            weights,
            motions,
            matrices,
        }
    }

    /// Points with four influences on random joints.
    fn random(count: usize) -> Self {
        const JOINTS: u32 = 64;
        let mut numbers = Numbers::new(2);
        let points: Vec<Point<f32>> = (0..count).map(|_| numbers.point::<f32>()).collect();
        let mut state = 1u32;
        let mut random = |below: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) % below
        };
        let rows: Vec<[(u32, f64); 4]> = (0..count)
            .map(|_| {
                let (first, step) = (random(JOINTS), 1 + random(15));
                [0, 1, 2, 3].map(|k| ((first + k * step) % JOINTS, f64::from(1 + random(1000))))
            })
            .collect();
        let weights = SkinWeights::new(JOINTS as usize, rows).expect("valid weights");
        Self::new(points, weights)
    }

    /// The rival's lists.
    fn vectors(&self) -> Vec<Vec3> {
        self.points
            .iter()
            .map(|point| Vec3::from(point.coordinates()))
            .collect()
    }

    fn four(&self) -> Option<Vec<[(u32, f32); 4]>> {
        let row = |row: Vec<(u32, f32)>| row.try_into().ok();
        self.rows().into_iter().map(row).collect()
    }

    fn rows(&self) -> Vec<Vec<(u32, f32)>> {
        let pair = |i: &ga_anim::weights::Influence| (i.joint, i.weight as f32);
        self.weights
            .iter()
            .map(|row| row.iter().map(pair).collect())
            .collect()
    }
}

fn matrix(rows: [[f32; 4]; 3]) -> Mat4 {
    Mat4::from_cols_array_2d(&[rows[0], rows[1], rows[2], [0.0, 0.0, 0.0, 1.0]]).transpose()
}

/// The rival, with the influences of each vertex in a list of its own or four each.
fn plain<R: AsRef<[(u32, f32)]>>(
    matrices: &[Mat4],
    points: &[Vec3],
    rows: &[R],
    moved: &mut [Vec3],
) {
    for ((point, row), moved) in points.iter().zip(rows).zip(moved) {
        let terms = row
            .as_ref()
            .iter()
            .map(|&(joint, weight)| matrices[joint as usize] * weight);
        let sum = terms
            .reduce(|sum, term| sum + term)
            .unwrap_or(Mat4::IDENTITY);
        *moved = sum.transform_point3(*point);
    }
}

fn plain_four(matrices: &[Mat4], points: &[Vec3], rows: &[[(u32, f32); 4]], moved: &mut [Vec3]) {
    for ((point, row), moved) in points.iter().zip(rows).zip(moved) {
        let term = |k: usize| matrices[row[k].0 as usize] * row[k].1;
        *moved = (term(0) + term(1) + term(2) + term(3)).transform_point3(*point);
    }
}

fn rival(group: &mut BenchmarkGroup<'_, WallTime>, scene: &Scene) {
    let points = scene.vectors();
    let mut moved = points.clone();
    match scene.four() {
        Some(rows) => group.bench_function("glam", |bench| {
            bench.iter(|| plain_four(&scene.matrices, &points, &rows, black_box(&mut moved)));
        }),
        None => {
            let rows = scene.rows();
            group.bench_function("glam", |bench| {
                bench.iter(|| plain(&scene.matrices, &points, &rows, black_box(&mut moved)));
            })
        }
    };
}

fn nullcone(group: &mut BenchmarkGroup<'_, WallTime>, scene: &Scene) {
    let binding = Binding::new(&scene.points, &scene.weights)
        .and_then(|binding| binding.with_normals(&scene.normals))
        .expect("weights for all vertices");
    let (mut points, mut normals) = (scene.points.clone(), scene.normals.clone());
    for (name, method) in [("linear", Method::Linear), ("motor", Method::Motor)] {
        let mut palette = binding.palette(method);
        group.bench_function(name, |bench| {
            bench.iter(|| {
                palette
                    .set_motions(&scene.motions)
                    .expect("a motion for each joint");
                let posed = Posed::of_points(black_box(&mut points));
                binding
                    .pose(&palette, posed)
                    .expect("a place for each vertex");
            });
        });
        group.bench_function(format!("{name} with normals"), |bench| {
            bench.iter(|| {
                palette
                    .set_motions(&scene.motions)
                    .expect("a motion for each joint");
                let posed = Posed {
                    points: black_box(&mut points),
                    normals: black_box(&mut normals),
                    tangents: &mut [],
                };
                binding
                    .pose(&palette, posed)
                    .expect("a place for each vertex");
            });
        });
    }
}

/// The same with a given set of instructions.
fn on_set(group: &mut BenchmarkGroup<'_, WallTime>, scene: &Scene, set: InstructionSet, of: &str) {
    if !set.is_available() {
        return;
    }
    let batch = Batch::on(set);
    let rows = scene.rows();
    let skin = Skin::new(scene.motions.len(), &scene.points, rows).expect("valid weights");
    let mut maps = AffinePalette::new(&skin);
    let affine: Vec<_> = scene
        .motions
        .iter()
        .map(|&motion| Affine::from(motion))
        .collect();
    maps.set(&affine).expect("a map for each joint");
    let mut motors = MotorPalette::new(&skin);
    motors.set(&scene.motions).expect("a motor for each joint");
    let mut points = scene.points.clone();
    group.bench_function(format!("linear {of}"), |bench| {
        bench.iter(|| {
            for chunk in skin.chunks() {
                let posed = Posed::of_points(&mut points[chunk.range()]);
                batch
                    .skin_by_affine_maps(chunk, &maps, posed)
                    .expect("a place for each");
            }
        });
    });
    group.bench_function(format!("motor {of}"), |bench| {
        bench.iter(|| {
            for chunk in skin.chunks() {
                let posed = Posed::of_points(&mut points[chunk.range()]);
                batch
                    .skin_by_motors(chunk, &motors, posed)
                    .expect("a place for each");
            }
        });
    });
}

fn hundred_thousand(criterion: &mut Criterion) {
    let scene = Scene::random(100_000);
    let mut group = criterion.benchmark_group("skinning/100k-f32");
    group.throughput(Throughput::Elements(100_000));
    rival(&mut group, &scene);
    nullcone(&mut group, &scene);
    on_set(&mut group, &scene, InstructionSet::Avx2, "avx2");
    on_set(&mut group, &scene, InstructionSet::Baseline, "baseline");
}

fn human(criterion: &mut Criterion) {
    let (Some(mesh), Some(skeleton), Some(weights)) = (
        shared("data/anim/human_base.obj"),
        shared("data/anim/human/rig.cmu_mb.json"),
        shared("data/anim/human/weights.cmu_mb.json"),
    ) else {
        return;
    };
    let mesh = obj::read(mesh).expect("a mesh");
    let skeleton = rig::read(skeleton).expect("a skeleton");
    let weights = rig::read_weights(weights, &skeleton, mesh.vertex_count()).expect("weights");
    let points: Vec<Point<f32>> = mesh
        .coordinates()
        .map(|p| Point::from(p.map(|x| x as f32)))
        .collect();
    let scene = Scene::new(points, weights);
    let mut group = criterion.benchmark_group("skinning/human-f32");
    group.throughput(Throughput::Elements(scene.points.len() as u64));
    rival(&mut group, &scene);
    nullcone(&mut group, &scene);
}

fn threads(criterion: &mut Criterion) {
    let scene = Scene::random(1_000_000);
    let binding = Binding::new(&scene.points, &scene.weights).expect("weights for all vertices");
    let mut points = scene.points.clone();
    let mut group = criterion.benchmark_group("skinning/threads-1m-f32");
    group
        .sample_size(10)
        .throughput(Throughput::Elements(1_000_000));
    for (name, method) in [("linear", Method::Linear), ("motor", Method::Motor)] {
        let mut palette = binding.palette(method);
        palette
            .set_motions(&scene.motions)
            .expect("a motion for each joint");
        for count in [1, 2] {
            let threads = rayon::ThreadPoolBuilder::new().num_threads(count).build();
            let threads = threads.expect("threads");
            group.bench_function(format!("{name} {count}"), |bench| {
                threads.install(|| {
                    bench.iter(|| {
                        let posed = Posed::of_points(black_box(&mut points));
                        binding
                            .pose(&palette, posed)
                            .expect("a place for each vertex");
                    });
                });
            });
        }
    }
}

fn all(criterion: &mut Criterion) {
    hundred_thousand(criterion);
    human(criterion);
    threads(criterion);
}

criterion_group! { name = benches; config = comparison::criterion(); targets = all }
criterion_main!(benches);
