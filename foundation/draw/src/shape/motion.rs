//! Motors as frames.

use ga_runtime::Element;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;

use super::drawable::check_coefficients;
use super::{Drawable, NotDrawable, Shape};

impl Drawable for Motor<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let (origin, axes) = frame(self)?;
        Shape::Frame { origin, axes }.checked()
    }
}

impl Drawable for Rotor<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        Motor::from(*self).shape()
    }
}

impl Drawable for Translator<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        Motor::from(*self).shape()
    }
}

/// The images of the origin and of the axes.
pub(super) fn frame(motor: &Motor<f64>) -> Result<(Point<f64>, [Vector<f64>; 3]), NotDrawable> {
    let blades = Motor::<f64>::BLADES.iter();
    check_coefficients(blades.map(|&blade| motor.coefficient(blade)))?;
    let rows = motor.to_matrix();
    let column = |k: usize| rows.map(|row| row[k]);
    Ok((column(3).into(), [0, 1, 2].map(|k| column(k).into())))
}
