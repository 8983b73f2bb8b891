//! From the members of the JSON text to elements of the algebra.

use std::collections::BTreeMap;

use ga_runtime::Element;
use ga_runtime::cga3::{
    Circle, Direction, Infinity, Line, Motor, MotorGenerator, Multivector, Plane, Point, PointPair,
    Rotor, Sphere, Translator,
};
use ga_runtime::geometry::relation::Tolerance;
use ga_runtime::geometry::relation::meet::{CircleAndCircle, LineAndCircle, LineAndLine};

use super::format::{
    CircleText, ElementText, LineText, MotorText, Place, PlaneText, SceneText, SphereText,
    TrajectoryText,
};
use super::{ElementError, SceneError};
use crate::scene::Scene;
use crate::shape::{Drawable, NotDrawable, Shape, Trajectory, whole};
use crate::style::Style;
use crate::vector3::{along, cross, normalized, scaled};

/// The most steps of a trajectory.
const MOST_STEPS: u32 = 20_000;

pub(super) fn scene(text: SceneText) -> Result<Scene, SceneError> {
    let mut scene = Scene::new(text.title);
    scene.description = text.description;
    (scene.axes, scene.grid) = (text.axes, text.grid);
    scene.legend = text.legend.unwrap_or(true);
    if let Some(size) = text.size {
        if size.iter().any(|pixels| !(64..=8192).contains(pixels)) {
            return Err(SceneError::Member {
                member: "size",
                value: format!("{size:?}"),
                expected: "two numbers of pixels from 64 to 8192",
            });
        }
        scene.size = size;
    }
    (scene.view.projection, scene.view.up) = (text.view.projection, text.view.up);
    if let Some(turn) = text.view.turn {
        if turn[1].abs() > 90.0 || turn[0].abs() > 36000.0 {
            return Err(SceneError::Member {
                member: "turn",
                value: format!("{turn:?}"),
                expected: "azimuth and elevation in degrees, the elevation from -90 to 90",
            });
        }
        [scene.view.azimuth, scene.view.elevation] = turn;
    }
    if let Some(zoom) = text.view.zoom {
        if !(0.1..=20.0).contains(&zoom) {
            return Err(SceneError::Member {
                member: "zoom",
                value: zoom.to_string(),
                expected: "from 0.1 to 20",
            });
        }
        scene.view.zoom = zoom;
    }
    let mut named = BTreeMap::new();
    for (index, element) in text.elements.into_iter().enumerate() {
        let name = element.name.clone();
        add(&mut scene, &mut named, element).map_err(|problem| SceneError::Element {
            index,
            name,
            problem,
        })?;
    }
    Ok(scene)
}

/// What an element is made of, and whether others can be made from it.
struct Made {
    shape: Shape,
    blade: Option<Multivector<f64>>,
}

type Named = BTreeMap<String, Option<Multivector<f64>>>;

fn add(scene: &mut Scene, named: &mut Named, element: ElementText) -> Result<(), ElementError> {
    if let Some(name) = &element.name
        && named.contains_key(name)
    {
        return Err(ElementError::DuplicateName);
    }
    let style = Style {
        label: element.label.clone().or_else(|| element.name.clone()),
        colour: element.colour.as_deref().map(str::parse).transpose()?,
        width: within("width", element.width, 0.25, 20.0, "from 0.25 to 20")?,
        opacity: within("opacity", element.opacity, 0.0, 1.0, "from 0 to 1")?,
    };
    let (name, hidden) = (element.name.clone(), element.hidden);
    let made = made(element, named)?;
    if let Some(name) = name {
        named.insert(name, made.blade);
    }
    if !hidden {
        scene.add(made.shape, style)?;
    }
    Ok(())
}

fn within(
    member: &'static str,
    value: Option<f64>,
    low: f64,
    high: f64,
    expected: &'static str,
) -> Result<Option<f64>, ElementError> {
    match value {
        Some(value) if !(low..=high).contains(&value) => Err(ElementError::Number {
            member,
            value,
            expected,
        }),
        value => Ok(value),
    }
}

/// A blade that can be met, joined and moved.
fn blade<E: Element<Scalar = f64> + Drawable>(element: E) -> Result<Made, ElementError> {
    let shape = element.shape()?;
    let blade = Some(whole(&element));
    Ok(Made { shape, blade })
}

fn plain(element: impl Drawable) -> Result<Made, ElementError> {
    let shape = element.shape()?;
    Ok(Made { shape, blade: None })
}

fn made(element: ElementText, named: &Named) -> Result<Made, ElementError> {
    let mut found = Vec::new();
    let mut note = |kind: &'static str, made: Option<Result<Made, ElementError>>| {
        found.extend(made.map(|made| (kind, made)));
    };
    note(
        "point",
        element.point.map(|place| blade(Point::from(place))),
    );
    note(
        "flat_point",
        element
            .flat_point
            .map(|place| blade(Point::from(place) ^ Infinity)),
    );
    note(
        "point_pair",
        element.point_pair.map(|ends| {
            let [p, q] = ends.map(Point::from);
            blade(p ^ q)
        }),
    );
    note("circle", element.circle.map(circle));
    note("sphere", element.sphere.map(sphere));
    note("line", element.line.map(line));
    note("plane", element.plane.map(plane));
    note(
        "direction",
        element
            .direction
            .map(|vector| blade(Direction::from_vector(vector))),
    );
    note("motor", element.motor.map(|text| plain(motor(&text)?)));
    note(
        "trajectory",
        element.trajectory.map(|text| plain(trajectory(text)?)),
    );
    note("blade", element.blade.map(coefficients));
    note("meet", element.meet.map(|names| meet(names, named)));
    note(
        "join",
        element
            .join
            .map(|[a, b]| general(known(&a, named)? ^ known(&b, named)?)),
    );
    note(
        "moved",
        element
            .moved
            .map(|text| moved(known(&text.element, named)?, motor(&text.by)?)),
    );
    let kinds: Vec<_> = found.iter().map(|(kind, _)| format!("`{kind}`")).collect();
    match (found.pop(), kinds.len()) {
        (Some((_, made)), 1) => made,
        (None, _) => Err(ElementError::Kinds("none".to_owned())),
        _ => Err(ElementError::Kinds(kinds.join(" and "))),
    }
}

fn positive(radius: f64) -> Result<f64, ElementError> {
    if radius >= 0.0 {
        return Ok(radius);
    }
    Err(ElementError::Number {
        member: "radius",
        value: radius,
        expected: "at least 0",
    })
}

fn circle(text: CircleText) -> Result<Made, ElementError> {
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
                return Err(ElementError::NoDirection("normal"));
            }
            let circle =
                Circle::from_centre_normal_radius(centre.into(), normal, positive(radius)?);
            blade(circle.ok_or(NotDrawable::NotFinite(f64::INFINITY))?)
        }
    }
}

fn sphere(text: SphereText) -> Result<Made, ElementError> {
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

fn line(text: LineText) -> Result<Made, ElementError> {
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

fn plane(text: PlaneText) -> Result<Made, ElementError> {
    match text {
        PlaneText::Through { through } => {
            let [p, q, r] = through.map(Point::from);
            blade(Plane::through(p, q, r))
        }
        PlaneText::At { point, normal } => blade(Plane::from_point_normal(point.into(), normal)),
        PlaneText::Distant { normal, distance } => {
            let unit = normalized(normal).ok_or(ElementError::NoDirection("normal"))?;
            blade(Plane::from_point_normal(
                scaled(unit, distance).into(),
                unit,
            ))
        }
    }
}

fn motor(text: &MotorText) -> Result<Motor<f64>, ElementError> {
    let rotor = match text.axis {
        Some(axis) => {
            let turn = Rotor::from_axis_angle(axis, text.degrees.to_radians());
            turn.ok_or(ElementError::NoDirection("axis"))?
        }
        None if text.degrees == 0.0 => Rotor::default(),
        None => return Err(ElementError::NoDirection("axis")),
    };
    let about = Motor::about(text.through.into(), rotor);
    Ok(Translator::from_displacement(text.translation) * about)
}

fn trajectory(text: TrajectoryText) -> Result<Trajectory, ElementError> {
    let count = |steps: Option<u32>, default| match steps.unwrap_or(default) {
        steps @ 1..=MOST_STEPS => Ok(steps),
        steps => Err(ElementError::Number {
            member: "steps",
            value: steps.into(),
            expected: "from 1 to 20000",
        }),
    };
    let carried =
        |path: Trajectory, point: Place, frames| path.carrying(point.into()).with_frames(frames);
    Ok(match text {
        TrajectoryText::Points { points } => {
            Trajectory::through(points.into_iter().map(Point::from))
        }
        TrajectoryText::Motors {
            motors,
            steps,
            point,
            frames,
        } => {
            let steps = count(steps, 32)?;
            let motors = motors.iter().map(motor).collect::<Result<Vec<_>, _>>()?;
            let mut path: Vec<Motor<f64>> = motors.first().copied().into_iter().collect();
            for pair in motors.windows(2) {
                let t = |k: u32| f64::from(k) / f64::from(steps);
                path.extend((1..=steps).map(|k| pair[0].interpolate(pair[1], t(k))));
            }
            carried(Trajectory::of_motors(path), point, frames)
        }
        TrajectoryText::Screw {
            screw,
            steps,
            point,
            frames,
        } => {
            let axis = normalized(screw.axis).ok_or(ElementError::NoDirection("axis"))?;
            let angle = screw.degrees.to_radians();
            let default = (screw.degrees.abs() / 5.0).clamp(48.0, 2000.0) as u32;
            // −½(θB + t ei) about the origin, with t what the turn about another axis brings along.
            let turn = scaled(axis, -0.5 * angle);
            let shift = along(scaled(axis, screw.shift), cross(screw.through, axis), angle);
            let shift = scaled(shift, -0.5);
            let generator =
                MotorGenerator::new(turn[2], -turn[1], turn[0], shift[0], shift[1], shift[2]);
            let steps = count(steps, default)? as usize;
            carried(Trajectory::screw(generator, steps), point, frames)
        }
    })
}

fn coefficients(blades: BTreeMap<String, f64>) -> Result<Made, ElementError> {
    let mut sum = BTreeMap::new();
    for (name, value) in blades {
        let place = place_of(&name).ok_or(ElementError::UnknownBlade(name))?;
        sum.insert(place, value);
    }
    general(Multivector::from_coefficients_unchecked(&mut |blade| {
        sum.get(&blade).copied().unwrap_or(0.0)
    }))
}

/// The number of a blade by its name.
fn place_of(name: &str) -> Option<usize> {
    if name == "scalar" {
        return Some(0);
    }
    let mut place = 0;
    for letter in name.strip_prefix('e')?.chars() {
        let bit = 1 << "123oi".find(letter)?;
        // In rising order, each once.
        if bit <= place {
            return None;
        }
        place |= bit;
    }
    (place > 0).then_some(place)
}

/// An element of any kind; those that are no motors can be met, joined and moved.
fn general(element: Multivector<f64>) -> Result<Made, ElementError> {
    let shape = element.shape()?;
    let blade = (!matches!(shape, Shape::Frame { .. })).then_some(element);
    Ok(Made { shape, blade })
}

fn known(name: &str, named: &Named) -> Result<Multivector<f64>, ElementError> {
    match named.get(name) {
        None => Err(ElementError::UnknownName(name.to_owned())),
        Some(None) => Err(ElementError::NotABlade(name.to_owned())),
        Some(Some(blade)) => Ok(*blade),
    }
}

fn meet([a, b]: [String; 2], named: &Named) -> Result<Made, ElementError> {
    let (first, second) = (known(&a, named)?, known(&b, named)?);
    if let Some(found) = curves_meet(first, second) {
        return found.map_or(Err(ElementError::NoMeet(a, b)), general);
    }
    let meet = first & second;
    let is_null = |vector: &Multivector<f64>| {
        let square = vector.e1 * vector.e1 + vector.e2 * vector.e2 + vector.e3 * vector.e3
            - 2.0 * vector.eo * vector.ei;
        square.abs() <= 1e-9 * (vector.eo * vector.ei).abs()
    };
    let has_vector = [meet.e1, meet.e2, meet.e3, meet.eo, meet.ei] != [0.0; 5];
    // A vector that is no point holds none.
    if has_vector && !is_null(&meet) {
        return Err(ElementError::NoMeet(a, b));
    }
    match general(meet) {
        Err(ElementError::NotDrawable(NotDrawable::Zero | NotDrawable::NeitherBladeNorMotor)) => {
            Err(ElementError::NoMeet(a, b))
        }
        other => other,
    }
}

/// What two lines or circles share; `None` for other elements. The product of two that lie in one
/// plane vanishes, although they may cross.
fn curves_meet(a: Multivector<f64>, b: Multivector<f64>) -> Option<Option<Multivector<f64>>> {
    let [a, b] = [curve(a)?, curve(b)?];
    let tolerance = Tolerance::new(1e-9, 1e-9);
    let line = |c: Circle<f64>| {
        is_flat(c).then(|| Line::new(c.e12i, c.e13i, c.e23i, c.e1oi, c.e2oi, c.e3oi))
    };
    let point = |p: Point<f64>| Some(Multivector::from(p));
    let tangent = |p, direction| PointPair::tangent(p, direction).map(Multivector::from);
    Some(match (line(a), line(b)) {
        (Some(l), Some(m)) => match l.meet(m, tolerance)? {
            LineAndLine::Point(p) => Some(Multivector::from(p ^ Infinity)),
            LineAndLine::Coincident(line) => Some(line.into()),
            LineAndLine::Parallel { .. } | LineAndLine::Skew(_) => None,
        },
        (Some(line), None) | (None, Some(line)) => {
            let circle = if is_flat(a) { b } else { a };
            match line.meet(circle, tolerance)? {
                LineAndCircle::Points(pair) | LineAndCircle::Imaginary(pair) => Some(pair.into()),
                LineAndCircle::Tangent {
                    point: p,
                    direction,
                } => tangent(p, direction),
                LineAndCircle::Point(p) => point(p),
                LineAndCircle::Apart => None,
            }
        }
        (None, None) => match a.meet(b, tolerance)? {
            CircleAndCircle::Points(pair) | CircleAndCircle::Imaginary(pair) => Some(pair.into()),
            CircleAndCircle::Tangent {
                point: p,
                direction,
            } => tangent(p, direction),
            CircleAndCircle::Point(p) => point(p),
            CircleAndCircle::Coincident(circle) => Some(circle.into()),
            CircleAndCircle::Apart | CircleAndCircle::Concentric => None,
        },
    })
}

/// A line or circle, as a circle; `None` for what has blades of another grade.
fn curve(element: Multivector<f64>) -> Option<Circle<f64>> {
    let is_other = |blade: usize| blade.count_ones() != 3 && element.coefficient(blade) != 0.0;
    let circle = Circle::from_coefficients_unchecked(&mut |blade| element.coefficient(blade));
    (!(0..32).any(is_other) && circle != Circle::default()).then_some(circle)
}

fn is_flat(c: Circle<f64>) -> bool {
    [c.e123, c.e12o, c.e13o, c.e23o] == [0.0; 4]
}

/// Moved as the type that it is, so that what is flat stays so.
fn moved(element: Multivector<f64>, motor: Motor<f64>) -> Result<Made, ElementError> {
    let moved = whole(&motor).sandwich(element);
    let infinity = Multivector::from_coefficients_unchecked(&mut |blade| {
        f64::from(u8::from(blade == 0b10000))
    });
    let flat = element.wedge(infinity) == Multivector::default();
    let moved = if flat {
        // Nothing but rounding errors in the blades without infinity.
        Multivector::from_coefficients_unchecked(&mut |blade| {
            if blade & 0b10000 == 0 {
                0.0
            } else {
                moved.coefficient(blade)
            }
        })
    } else {
        moved
    };
    general(moved)
}
