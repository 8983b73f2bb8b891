//! From the members of the JSON text to elements of the algebra.

use std::collections::BTreeMap;

use ga_runtime::cga3::{Direction, Infinity, Point};

use super::element::{circle, coefficients, line, motor, plane, sphere};
use super::error::{ElementProblem, SceneError};
use super::format::{ElementText, SceneText};
use super::made::{Made, blade, general, plain};
use super::relation::{Named, known, meet, moved};
use super::trajectory::trajectory;
use crate::scene::Scene;
use crate::style::Style;

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

fn add(scene: &mut Scene, named: &mut Named, element: ElementText) -> Result<(), ElementProblem> {
    if let Some(name) = &element.name
        && named.contains_key(name)
    {
        return Err(ElementProblem::DuplicateName);
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
) -> Result<Option<f64>, ElementProblem> {
    match value {
        Some(value) if !(low..=high).contains(&value) => Err(ElementProblem::Number {
            member,
            value,
            expected,
        }),
        value => Ok(value),
    }
}

fn made(element: ElementText, named: &Named) -> Result<Made, ElementProblem> {
    let mut found = Vec::new();
    let mut note = |kind: &'static str, made: Option<Result<Made, ElementProblem>>| {
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
        (None, _) => Err(ElementProblem::Kinds("none".to_owned())),
        _ => Err(ElementProblem::Kinds(kinds.join(" and "))),
    }
}
