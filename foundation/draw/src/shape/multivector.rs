//! General multivectors, classified by their grades.

use ga_runtime::Element;
use ga_runtime::cga3::{Bivector, Motor, Multivector, Quadvector, RoundVector, Trivector};

use super::drawable::balanced;
use super::{Drawable, NotDrawable, Shape};

/// A coefficient counts as zero where it is at most this part of the largest one.
const TOLERANCE: f64 = 1e-12;

impl Drawable for Multivector<f64> {
    /// Vectors are read in dual form, as spheres, planes and points; other blades are read in
    /// direct form. A sum of even grades must be a motor.
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let element = balanced(self)?;
        let blades = Self::BLADES.iter().copied();
        let largest = |keep: &dyn Fn(u32) -> bool| {
            let kept = blades.clone().filter(|blade| keep(blade.count_ones()));
            kept.fold(0.0_f64, |largest, blade| {
                largest.max(element.coefficient(blade).abs())
            })
        };
        let whole = largest(&|_| true);
        let grades: Vec<u32> = (0..=5)
            .filter(|&grade| largest(&|other| other == grade) > TOLERANCE * whole)
            .collect();
        match grades[..] {
            [1] => part::<RoundVector<f64>>(self).shape(),
            [2] => {
                check_blade(&element)?;
                part::<Bivector<f64>>(self).shape()
            }
            [3] => {
                // A trivector is a blade where its dual bivector is a blade.
                check_blade(&element.dual())?;
                part::<Trivector<f64>>(self).shape()
            }
            [4] => part::<Quadvector<f64>>(self).shape(),
            [0] | [5] => Err(NotDrawable::NeitherBladeNorMotor),
            _ => motor(self)
                .ok_or(NotDrawable::NeitherBladeNorMotor)?
                .shape(),
        }
    }
}

/// The part of a multivector that is of a given type with free coefficients.
pub(crate) fn part<E: Element<Scalar = f64>>(element: &Multivector<f64>) -> E {
    debug_assert!(E::IS_FREE);
    E::from_coefficients_unchecked(&mut |blade| element.coefficient(blade))
}

/// An element as a multivector.
pub(crate) fn whole<E: Element<Scalar = f64>>(element: &E) -> Multivector<f64> {
    Multivector::from_coefficients_unchecked(&mut |blade| element.coefficient(blade))
}

/// Fails where a bivector B is not the outer product of two vectors, that is, where `B∧B ≠ 0`.
fn check_blade(bivector: &Multivector<f64>) -> Result<(), NotDrawable> {
    let square = bivector.wedge(*bivector);
    let size = |element: &Multivector<f64>| {
        let blades = Multivector::<f64>::BLADES.iter();
        blades.fold(0.0_f64, |size, &blade| {
            size.max(element.coefficient(blade).abs())
        })
    };
    if size(&square) > 1e-9 * size(bivector) * size(bivector) {
        return Err(NotDrawable::NeitherBladeNorMotor);
    }
    Ok(())
}

/// The element as a motor; `None` where it has other blades, or `M ~M` is not 1.
fn motor(element: &Multivector<f64>) -> Option<Motor<f64>> {
    let blades = Multivector::<f64>::BLADES.iter();
    let mut others = blades.filter(|blade| !Motor::<f64>::BLADES.contains(blade));
    if others.any(|&blade| element.coefficient(blade).abs() > TOLERANCE) {
        return None;
    }
    let candidate = Motor::from_coefficients_unchecked(&mut |blade| element.coefficient(blade));
    let norm = *element * element.reverse();
    let is_one = Multivector::<f64>::BLADES.iter().all(|&blade| {
        let one = f64::from(u8::from(blade == 0));
        (norm.coefficient(blade) - one).abs() <= 1e-9
    });
    is_one.then_some(candidate)
}
