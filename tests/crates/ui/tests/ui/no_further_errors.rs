//! The types of a faulty declaration can be used in every way without further errors.

ga_runtime::algebra! {
    pub mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct E1 { e1 = 1 }
        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e32, e23 }
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12, e13, e23 }
        struct Even { scalar, e12, e13, e23 }

        products {
            wedge(Vector, Vector);
            sandwich(Rotor, Vector) -> Self;
        }
    }
}

mod names {
    pub use super::vga3::{Bivector, Rotor as Turn};

    pub fn turn_all(by: Turn<f64>, vectors: &mut [super::vga3::Vector<f64>]) {
        for vector in vectors {
            *vector = by.transform(*vector);
        }
    }
}

mod everything {
    use super::vga3::*;

    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Frame<S> {
        pub position: Vector<S>,
        pub attitude: Rotor<S>,
    }

    impl<S: ga_runtime::scalar::Real> Vector<S> {
        pub fn length(self) -> S {
            self.norm_squared().sqrt()
        }
    }

    impl From<Frame<f64>> for Even<f64> {
        fn from(frame: Frame<f64>) -> Self {
            Self {
                scalar: frame.position.e1 + METRIC.len() as f64,
                ..frame.attitude.into()
            }
        }
    }
}

mod kernels {
    ga_runtime::ga! { super::vga3;
        /// Moves a vector.
        pub fn turned(r: Rotor, v: Vector) -> Vector { r * v * rev(r) }
        pub(crate) fn turning(uniform r: Rotor, v: Vector) -> Vector { r * v * rev(r) }
        fn length(v: Vector) -> Scalar { sqrt(v | v) }
    }

    pub fn lengths(v: super::vga3::Vector<f64>) -> f64 {
        let area = ga_runtime::ga! { super::vga3; |a: Vector, b: Vector| -> Bivector { a ^ b } };
        length(v) + area(v, turned(Default::default(), v)).e12
    }

    pub struct Prepared {
        pub all: Vec<Turning<f64>>,
    }
}

mod more_kernels {
    use crate::kernels::turned;

    ga_runtime::ga! { crate::vga3;
        use super::kernels::{turned as moved, turning};
        pub fn twice(r: Rotor, v: Vector) -> Vector { moved(r, turning(r, v)) }
    }

    pub fn thrice(v: super::vga3::Vector<f64>) -> f64 {
        turned(Default::default(), twice(Default::default(), v)).e1
    }
}

mod tests {
    ga_runtime::testing::product_tests!(super::vga3);
    ga_runtime::testing::product_tests!(crate::vga3);
}

fn main() {
    use vga3::{E1, Vector};

    let vector = Vector::new(1.0, 2.0, 3.0);
    let Vector { e1, e2, .. } = Vector { e3: 1.0, ..vector };
    let area: names::Bivector<f64> = E1 ^ vector * 2.0;
    let turn = names::Turn::try_new(1.0, 0.0, 0.0, 0.0, 1e-12).unwrap();
    names::turn_all(turn, &mut [vector, Vector::default()]);
    let prepared = kernels::turning(turn);
    let all: Vec<_> = vec![vector].into_iter().map(|v| prepared.apply(v)).collect();
    assert_eq!(kernels::lengths(all[0]), more_kernels::thrice(vector));
    assert_eq!(kernels::Prepared { all: vec![prepared] }.all.len(), 1);
    assert_eq!(e1 + e2, area.e12 + vector.length());
    assert_eq!(size_of::<vga3::Rotor<f32>>(), 16);
}
