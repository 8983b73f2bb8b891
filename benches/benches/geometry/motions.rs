//! Motors: made, read, applied, composed, inverted and interpolated.
//!
//! A motor stores its translation t as the quaternion `½ t q` beside its rotation q, where glam
//! keeps t itself. Rows "of a dual quaternion" do the same with glam as ours: they compute t from
//! that product, or the product from t.

use criterion::Criterion;
use ga_runtime::cga3::{DualQuaternion, Motor, Rotor, Translator};
use glam::{DAffine3, DMat3, DQuat, DVec3, DVec4};
use nullcone_benches::inputs::{self, Numbers};

use super::{by_hand, group};

/// A rotation, then a translation.
#[derive(Clone, Copy)]
struct Isometry {
    rotation: DQuat,
    translation: DVec3,
}

fn quaternion(rotor: Rotor<f64>) -> DQuat {
    let ([x, y, z], w) = rotor.to_quaternion();
    DQuat::from_xyzw(x, y, z, w)
}

fn isometry(motor: Motor<f64>) -> Isometry {
    Isometry {
        rotation: quaternion(motor.rotor()),
        translation: motor.translator().displacement().into(),
    }
}

fn affine(motor: Motor<f64>) -> DAffine3 {
    let Isometry {
        rotation,
        translation,
    } = isometry(motor);
    DAffine3::from_rotation_translation(rotation, translation)
}

/// q and `½ t q` of a rotation q and a translation t.
fn quaternions(motor: Motor<f64>) -> [DQuat; 2] {
    let parts = motor.to_dual_quaternion();
    [parts.real, parts.dual].map(|([x, y, z], w)| DQuat::from_xyzw(x, y, z, w))
}

/// The same of an isometry.
#[inline]
fn with_product(
    Isometry {
        rotation,
        translation,
    }: Isometry,
) -> [DQuat; 2] {
    let (half, vector) = (0.5 * translation, rotation.xyz());
    let product = half * rotation.w + half.cross(vector);
    [
        rotation,
        DQuat::from_vec4(product.extend(-half.dot(vector))),
    ]
}

/// The parts of a dual quaternion, in any basis in which both have the same order.
fn dual_quaternion(sum: DualQuaternion<f64>) -> (DVec4, DVec4) {
    let real = DVec4::new(sum.scalar, sum.e12, sum.e13, sum.e23);
    (real, DVec4::new(sum.e123i, -sum.e3i, sum.e2i, -sum.e1i))
}

/// The motion of a rotation vector and a velocity (Murray, Li and Sastry, A Mathematical
/// Introduction to Robotic Manipulation, 1994, proposition 2.9).
fn exponential(turn: DVec3, velocity: DVec3) -> Isometry {
    let square = turn.length_squared();
    let angle = square.sqrt();
    let (sine, cosine) = angle.sin_cos();
    let (first, second) = if square < 1e-8 {
        (0.5, 1.0 / 6.0)
    } else {
        ((1.0 - cosine) / square, (angle - sine) / (square * angle))
    };
    let across = turn.cross(velocity);
    Isometry {
        rotation: DQuat::from_scaled_axis(turn),
        translation: velocity + across * first + turn.cross(across) * second,
    }
}

/// The inverse of [`exponential`].
fn logarithm(motion: &Isometry) -> (DVec3, DVec3) {
    let turn = motion.rotation.to_scaled_axis();
    let square = turn.length_squared();
    let factor = if square < 1e-8 {
        1.0 / 12.0
    } else {
        let angle = square.sqrt();
        let (sine, cosine) = angle.sin_cos();
        (1.0 - 0.5 * angle * sine / (1.0 - cosine)) / square
    };
    let across = turn.cross(motion.translation);
    let velocity = motion.translation - across * 0.5 + turn.cross(across) * factor;
    (turn, velocity)
}

pub(crate) fn all(criterion: &mut Criterion) {
    let motors = inputs::list(1, |numbers| {
        (numbers.motor::<f64>(), numbers.motor::<f64>())
    });
    let points = inputs::list(2, Numbers::point::<f64>);
    let times: Vec<f64> = inputs::list(3, |numbers| 0.5 + 0.5 * numbers.number::<f64>());
    let isometries: Vec<_> = motors
        .iter()
        .map(|(a, b)| (isometry(*a), isometry(*b)))
        .collect();
    let affines: Vec<_> = motors
        .iter()
        .map(|(a, b)| (affine(*a), affine(*b)))
        .collect();
    let vectors: Vec<_> = points.iter().map(|p| by_hand::point(*p)).collect();
    let generators: Vec<_> = motors.iter().map(|(a, _)| a.log()).collect();
    let velocities: Vec<_> = isometries.iter().map(|(a, _)| logarithm(a)).collect();
    let parts: Vec<_> = motors
        .iter()
        .map(|(a, _)| (a.rotor(), a.translator().displacement()))
        .collect();
    let matrices: Vec<_> = motors.iter().map(|(a, _)| a.to_matrix()).collect();
    let quaternions: Vec<_> = motors.iter().map(|(a, _)| quaternions(*a)).collect();

    let mut g = group(criterion, "motion from rotation and translation");
    g.map("nullcone", &parts, |(rotor, displacement)| {
        Translator::from_displacement(*displacement) * *rotor
    });
    g.map("glam DAffine3", &isometries, |(m, _)| {
        DAffine3::from_rotation_translation(m.rotation, m.translation)
    });
    g.map("glam, of a dual quaternion", &isometries, |(m, _)| {
        with_product(*m)
    });
    drop(g);

    let mut g = group(criterion, "rotation from axis and angle");
    g.zip("nullcone", &points, &times, |p, t| {
        Rotor::from_axis_angle(p.coordinates(), *t)
    });
    g.zip("glam DQuat", &vectors, &times, |v, t| {
        Some(DQuat::from_axis_angle(v.try_normalize()?, *t))
    });
    drop(g);

    let mut g = group(criterion, "matrix of a motion");
    g.map("nullcone", &motors, |(a, _)| a.to_matrix());
    g.map("glam DAffine3", &isometries, |(m, _)| {
        DAffine3::from_rotation_translation(m.rotation, m.translation)
    });
    g.map(
        "glam DAffine3, of a dual quaternion",
        &quaternions,
        |[real, dual]| {
            let translation = 2.0 * (*dual * real.conjugate()).xyz();
            DAffine3::from_rotation_translation(*real, translation)
        },
    );
    drop(g);

    let isometry_of_matrix = |a: &DAffine3| {
        let rows = a.matrix3;
        let is_rotation = (rows * rows.transpose()).abs_diff_eq(DMat3::IDENTITY, 1e-8)
            && (rows.determinant() - 1.0).abs() < 1e-8;
        is_rotation.then(|| Isometry {
            rotation: DQuat::from_mat3(&rows),
            translation: a.translation,
        })
    };
    let mut g = group(criterion, "motion from a matrix");
    g.map("nullcone", &matrices, |rows| Motor::from_matrix(*rows));
    g.map("glam", &affines, |(a, _)| isometry_of_matrix(a));
    g.map("glam, of a dual quaternion", &affines, |(a, _)| {
        isometry_of_matrix(a).map(with_product)
    });
    drop(g);

    let mut g = group(criterion, "motion of a point");
    g.zip("nullcone", &motors, &points, |(a, _), p| a.transform(*p));
    g.zip("glam DQuat", &isometries, &vectors, |(m, _), v| {
        m.rotation * *v + m.translation
    });
    g.zip("glam DAffine3", &affines, &vectors, |(a, _), v| {
        a.transform_point3(*v)
    });
    drop(g);

    let mut g = group(criterion, "composition of motions");
    g.map("nullcone", &motors, |(a, b)| *a * *b);
    g.map("glam DAffine3", &affines, |(a, b)| *a * *b);
    g.map("glam DQuat", &isometries, |(a, b)| Isometry {
        rotation: a.rotation * b.rotation,
        translation: a.rotation * b.translation + a.translation,
    });
    drop(g);

    let mut g = group(criterion, "inverse of a motion");
    g.map("nullcone", &motors, |(a, _)| a.reverse());
    g.map("glam DQuat", &isometries, |(m, _)| {
        let rotation = m.rotation.conjugate();
        Isometry {
            rotation,
            translation: -(rotation * m.translation),
        }
    });
    g.map("glam DAffine3", &affines, |(a, _)| a.inverse());
    drop(g);

    let mut g = group(criterion, "exponential");
    g.map("nullcone", &generators, |g| g.exp());
    g.map("glam", &velocities, |(turn, velocity)| {
        exponential(*turn, *velocity)
    });
    g.map("glam DQuat, rotations alone", &velocities, |(turn, _)| {
        DQuat::from_scaled_axis(*turn)
    });
    drop(g);

    let mut g = group(criterion, "logarithm");
    g.map("nullcone", &motors, |(a, _)| a.log());
    g.map("glam", &isometries, |(m, _)| logarithm(m));
    g.map("glam DQuat, rotations alone", &isometries, |(m, _)| {
        m.rotation.to_scaled_axis()
    });
    drop(g);

    let mut g = group(criterion, "interpolation of motions");
    g.zip("nullcone", &motors, &times, |(a, b), t| {
        a.interpolate(*b, *t)
    });
    g.zip("glam, along a screw", &isometries, &times, |(a, b), t| {
        let inverse = a.rotation.conjugate();
        let between = Isometry {
            rotation: inverse * b.rotation,
            translation: inverse * (b.translation - a.translation),
        };
        let (turn, velocity) = logarithm(&between);
        let part = exponential(turn * *t, velocity * *t);
        Isometry {
            rotation: a.rotation * part.rotation,
            translation: a.rotation * part.translation + a.translation,
        }
    });
    g.zip(
        "glam DQuat, slerp and lerp",
        &isometries,
        &times,
        |(a, b), t| Isometry {
            rotation: a.rotation.slerp(b.rotation, *t),
            translation: a.translation.lerp(b.translation, *t),
        },
    );
    drop(g);

    let mut g = group(criterion, "motor nearest to a sum");
    let sums: Vec<_> = motors.iter().map(|(a, b)| *a * 0.4 + *b * 0.6).collect();
    let plain_sums: Vec<_> = sums.iter().map(|sum| dual_quaternion(*sum)).collect();
    g.map("nullcone", &sums, |sum| sum.normalize());
    g.map("glam", &plain_sums, |(real, dual)| {
        let square = real.length_squared();
        let scale = square.sqrt().recip();
        let change = real.dot(*dual) / square;
        scale
            .is_finite()
            .then(|| (*real * scale, (*dual - *real * change) * scale))
    });
}
