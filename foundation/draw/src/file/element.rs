//! Elements from the numbers that define them.

use std::collections::BTreeMap;

use ga_runtime::Element;
use ga_runtime::cga3::{Circle, Line, Motor, Multivector, Plane, Point, Rotor, Sphere, Translator};
use ga_runtime::vga3::Vector;

use super::error::ElementProblem;
use super::format::{CircleText, LineText, MotorText, PlaneText, SphereText};
use super::made::{Made, blade, general};
use crate::shape::NotDrawable;

fn positive(radius: f64) -> Result<f64, ElementProblem> {
    if radius >= 0.0 {
        return Ok(radius);
    }
    Err(ElementProblem::Number {
        member: "radius",
        value: radius,
        expected: "at least 0",
    })
}

pub(super) fn circle(text: CircleText) -> Result<Made, ElementProblem> {
    match text {
        CircleText::Through { through } => {
            let [p, q, r] = through.map(Point::from);
            blade(Circle::through(p, q, r))
        }
        CircleText::About {
            centre,
            normal,
            radius,
        } => {
            if normal == [0.0; 3] {
                return Err(ElementProblem::NoDirection("normal"));
            }
            let circle =
                Circle::from_centre_normal_radius(centre.into(), normal, positive(radius)?);
            blade(circle.ok_or(NotDrawable::NotFinite(f64::INFINITY))?)
        }
    }
}

pub(super) fn sphere(text: SphereText) -> Result<Made, ElementProblem> {
    match text {
        SphereText::Through { through } => {
            let [p, q, r, s] = through.map(Point::from);
            blade(Sphere::through(p, q, r, s))
        }
        SphereText::About { centre, radius } => {
            blade(Sphere::from_centre_radius(centre.into(), positive(radius)?))
        }
    }
}

pub(super) fn line(text: LineText) -> Result<Made, ElementProblem> {
    match text {
        LineText::Through { through } => {
            let [p, q] = through.map(Point::from);
            blade(Line::through(p, q))
        }
        LineText::Along { point, direction } => {
            blade(Line::from_point_direction(point.into(), direction))
        }
    }
}

pub(super) fn plane(text: PlaneText) -> Result<Made, ElementProblem> {
    match text {
        PlaneText::Through { through } => {
            let [p, q, r] = through.map(Point::from);
            blade(Plane::through(p, q, r))
        }
        PlaneText::At { point, normal } => blade(Plane::from_point_normal(point.into(), normal)),
        PlaneText::Distant { normal, distance } => {
            let unit = Vector::from(normal)
                .normalized()
                .ok_or(ElementProblem::NoDirection("normal"))?;
            blade(Plane::from_point_normal(
                (unit * distance).into(),
                unit.into(),
            ))
        }
    }
}

pub(super) fn motor(text: &MotorText) -> Result<Motor<f64>, ElementProblem> {
    let rotor = match text.axis {
        Some(axis) => {
            let rotor = Rotor::from_axis_angle(axis, text.degrees.to_radians());
            rotor.ok_or(ElementProblem::NoDirection("axis"))?
        }
        None if text.degrees == 0.0 => Rotor::default(),
        None => return Err(ElementProblem::NoDirection("axis")),
    };
    let about = Motor::about(text.through.into(), rotor);
    Ok(Translator::from_displacement(text.translation) * about)
}

pub(super) fn coefficients(blades: BTreeMap<String, f64>) -> Result<Made, ElementProblem> {
    let mut sum = BTreeMap::new();
    for (name, value) in blades {
        let blade = blade_of(&name).ok_or(ElementProblem::UnknownBlade(name))?;
        sum.insert(blade, value);
    }
    general(Multivector::from_coefficients_unchecked(&mut |blade| {
        sum.get(&blade).copied().unwrap_or(0.0)
    }))
}

/// The bits of a blade by its name.
fn blade_of(name: &str) -> Option<usize> {
    if name == "scalar" {
        return Some(0);
    }
    let mut blade = 0;
    for letter in name.strip_prefix('e')?.chars() {
        let bit = 1 << "123oi".find(letter)?;
        // In ascending order, each once.
        if bit <= blade {
            return None;
        }
        blade |= bit;
    }
    (blade > 0).then_some(blade)
}
