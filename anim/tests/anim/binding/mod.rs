//! Skins bound once for many frames: against single vertices computed from the definitions, for all
//! instructions.

mod whole;

use ga_anim::skin::{Posed, SkinScalar};
use ga_anim::weights::SkinWeights;
use ga_runtime::batch::skin::{AffinePalette, MotorPalette, Skin};
use ga_runtime::batch::{Batch, InstructionSet};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use glam::{DMat3, DMat4, DQuat, DVec3};

const JOINTS: usize = 40;

/// Reproducible numbers in [−1, 1).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1 << 30) - 1.0
    }

    fn vector(&mut self) -> [f64; 3] {
        [(); 3].map(|()| self.next())
    }

    fn index(&mut self, count: usize) -> usize {
        ((self.next() + 1.0) * 0.5 * count as f64) as usize % count
    }
}

/// A mesh whose vertices have from one to nine influences, in no order.
struct Case {
    rest: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    tangents: Vec<[f64; 3]>,
    weights: SkinWeights,
    rotations: Vec<DQuat>,
    shifts: Vec<DVec3>,
}

fn case(vertices: usize) -> Case {
    let mut numbers = Numbers(7);
    let rows: Vec<Vec<(u32, f64)>> = (0..vertices)
        .map(|_| {
            let (first, count) = (numbers.index(JOINTS), 1 + numbers.index(9));
            // Joints that follow each other by 7 are all different.
            let joint = |k: usize| ((first + 7 * k) % JOINTS) as u32;
            (0..count)
                .map(|k| (joint(k), 1.1 + numbers.next()))
                .collect()
        })
        .collect();
    let mut list = |count: usize| (0..count).map(|_| numbers.vector()).collect::<Vec<_>>();
    let (rest, normals, tangents) = (list(vertices), list(vertices), list(vertices));
    let (axes, shifts) = (list(JOINTS), list(JOINTS));
    Case {
        rest,
        normals,
        tangents,
        weights: SkinWeights::new(JOINTS, rows).unwrap(),
        rotations: axes
            .iter()
            .map(|&v| DQuat::from_scaled_axis(DVec3::from(v) * 1.5))
            .collect(),
        shifts: shifts.into_iter().map(DVec3::from).collect(),
    }
}

fn scalars<S: SkinScalar>(p: [f64; 3]) -> [S; 3] {
    p.map(S::from_f64)
}

fn double<S: SkinScalar>(p: [S; 3]) -> DVec3 {
    DVec3::from(p.map(Into::<f64>::into))
}

impl Case {
    fn points<S: SkinScalar>(&self) -> Vec<Point<S>> {
        self.rest.iter().map(|&p| Point::from(scalars(p))).collect()
    }

    fn motors<S: SkinScalar>(&self) -> Vec<Motor<S>> {
        let motor = |(q, t): (&DQuat, &DVec3)| {
            let rotor = Rotor::from_quaternion(scalars([q.x, q.y, q.z]), S::from_f64(q.w)).unwrap();
            Translator::from_displacement(scalars(t.to_array())) * rotor
        };
        self.rotations.iter().zip(&self.shifts).map(motor).collect()
    }

    fn matrices(&self, scale: DMat3) -> Vec<DMat4> {
        let matrix = |(q, t): (&DQuat, &DVec3)| {
            DMat4::from_rotation_translation(*q, *t) * DMat4::from_mat3(scale)
        };
        self.rotations
            .iter()
            .zip(&self.shifts)
            .map(matrix)
            .collect()
    }

    /// The mean of the matrices of a vertex.
    fn mean(&self, matrices: &[DMat4], vertex: usize) -> DMat4 {
        let influences = self.weights.influences(vertex).iter();
        influences.fold(DMat4::ZERO, |sum, i| {
            sum + matrices[i.joint as usize] * i.weight
        })
    }

    /// The blend of dual quaternions of a vertex, as a matrix (Kavan et al., 2008).
    fn blend(&self, vertex: usize) -> DMat4 {
        let influences = self.weights.influences(vertex);
        let heaviest = influences.iter().fold(&influences[0], |best, next| {
            if next.weight > best.weight {
                next
            } else {
                best
            }
        });
        let guide = self.rotations[heaviest.joint as usize];
        let (mut real, mut dual) = (
            DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0),
            DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0),
        );
        for influence in influences {
            let (q, t) = (
                self.rotations[influence.joint as usize],
                self.shifts[influence.joint as usize],
            );
            let weight = if q.dot(guide) < 0.0 {
                -influence.weight
            } else {
                influence.weight
            };
            real += q * weight;
            dual += DQuat::from_xyzw(t.x, t.y, t.z, 0.0) * q * (0.5 * weight);
        }
        let length = real.length();
        let (real, dual) = (real * length.recip(), dual * length.recip());
        let shift = dual * real.conjugate();
        DMat4::from_rotation_translation(real, 2.0 * DVec3::new(shift.x, shift.y, shift.z))
    }
}

#[track_caller]
fn assert_near<S: SkinScalar>(ours: [S; 3], known: DVec3, bound: f64, what: &str) {
    let error = (double(ours) - known).length();
    assert!(
        error <= bound,
        "{what}: {ours:?} instead of {known}: {error:e}"
    );
}

/// All lists, moved by a palette with given instructions.
struct Moved<S> {
    points: Vec<Point<S>>,
    normals: Vec<Vector<S>>,
    tangents: Vec<Vector<S>>,
}

fn check_linear<S: SkinScalar>(set: InstructionSet, with_tangents: bool, bound: f64) {
    let case = case(5003);
    let points = case.points::<S>();
    let directions = |list: &[[f64; 3]]| {
        list.iter()
            .map(|&v| Vector::from(scalars(v)))
            .collect::<Vec<_>>()
    };
    let rows = case
        .weights
        .iter()
        .map(|row| row.iter().map(|i| (i.joint, S::from_f64(i.weight))));
    let skin = Skin::new(JOINTS, &points, rows)
        .and_then(|skin| skin.with_normals(&directions(&case.normals)))
        .and_then(|skin| skin.with_tangents(&directions(&case.tangents)))
        .unwrap();
    // A scale with shear, so that normals and tangents differ.
    let scale = DMat3::from_cols(
        DVec3::new(1.5, 0.1, 0.0),
        DVec3::new(0.2, 0.7, 0.0),
        DVec3::Z,
    );
    let matrices = case.matrices(scale);
    let maps: Vec<Affine<S>> = matrices
        .iter()
        .map(|m| {
            let row = |r: usize| scalars([m.col(0)[r], m.col(1)[r], m.col(2)[r]]);
            Affine::new(
                [row(0), row(1), row(2)],
                scalars([m.col(3)[0], m.col(3)[1], m.col(3)[2]]),
            )
        })
        .collect();
    let mut palette = AffinePalette::new(&skin);
    palette.set(&maps).unwrap();
    let mut moved = Moved {
        points: points.clone(),
        normals: vec![Vector::default(); points.len()],
        tangents: vec![Vector::default(); if with_tangents { points.len() } else { 0 }],
    };
    for chunk in skin.chunks() {
        let range = chunk.range();
        let tangents = if with_tangents { range.clone() } else { 0..0 };
        let posed = Posed {
            points: &mut moved.points[range.clone()],
            normals: &mut moved.normals[range],
            tangents: &mut moved.tangents[tangents],
        };
        Batch::on(set)
            .skin_by_affine_maps(chunk, &palette, posed)
            .unwrap();
    }
    for vertex in 0..points.len() {
        let mean = case.mean(&matrices, vertex);
        let linear = DMat3::from_mat4(mean);
        let known = mean.transform_point3(case.rest[vertex].into());
        assert_near(moved.points[vertex].coordinates(), known, bound, "point");
        let cofactors = DMat3::from_cols(
            linear.y_axis.cross(linear.z_axis),
            linear.z_axis.cross(linear.x_axis),
            linear.x_axis.cross(linear.y_axis),
        );
        let normal = cofactors * DVec3::from(case.normals[vertex]).normalize();
        // Where the mean nearly vanishes, the direction is badly conditioned.
        let bound = bound / normal.length().min(1.0);
        assert_near(
            moved.normals[vertex].coordinates(),
            normal.normalize(),
            4.0 * bound,
            "normal",
        );
        if with_tangents {
            let tangent = linear * DVec3::from(case.tangents[vertex]).normalize();
            let bound = bound / tangent.length().min(1.0);
            assert_near(
                moved.tangents[vertex].coordinates(),
                tangent.normalize(),
                4.0 * bound,
                "tangent",
            );
        }
    }
}

const SETS: [InstructionSet; 3] = [
    InstructionSet::Baseline,
    InstructionSet::Avx2,
    InstructionSet::Avx512,
];

#[test]
fn linear_blends_are_means_of_matrices() {
    for set in SETS {
        for with_tangents in [false, true] {
            check_linear::<f32>(set, with_tangents, 3e-6);
            check_linear::<f64>(set, with_tangents, 1e-14);
        }
    }
}

fn check_motors<S: SkinScalar>(set: InstructionSet, bound: f64) {
    let case = case(5003);
    let points = case.points::<S>();
    let rows = case
        .weights
        .iter()
        .map(|row| row.iter().map(|i| (i.joint, S::from_f64(i.weight))));
    let normals: Vec<Vector<S>> = case
        .normals
        .iter()
        .map(|&v| Vector::from(scalars(v)))
        .collect();
    let skin = Skin::new(JOINTS, &points, rows)
        .and_then(|skin| skin.with_normals(&normals))
        .unwrap();
    let mut palette = MotorPalette::new(&skin);
    palette.set(&case.motors()).unwrap();
    let (mut moved, mut turned) = (points.clone(), normals);
    for chunk in skin.chunks() {
        let posed = Posed {
            points: &mut moved[chunk.range()],
            normals: &mut turned[chunk.range()],
            tangents: &mut [],
        };
        Batch::on(set)
            .skin_by_motors(chunk, &palette, posed)
            .unwrap();
    }
    for vertex in 0..points.len() {
        let blend = case.blend(vertex);
        // Of eleven rotations about all axes little may be left.
        let known = blend.transform_point3(case.rest[vertex].into());
        assert_near(moved[vertex].coordinates(), known, bound, "point");
        let normal = blend.transform_vector3(DVec3::from(case.normals[vertex]).normalize());
        assert_near(turned[vertex].coordinates(), normal, bound, "normal");
    }
}

#[test]
fn motor_blends_are_blends_of_dual_quaternions() {
    for set in SETS {
        check_motors::<f32>(set, 2e-5);
        check_motors::<f64>(set, 1e-13);
    }
}
