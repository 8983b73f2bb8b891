//! The members of the JSON text.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::view::{Projection, Up};

pub(super) type Place = [f64; 3];

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a scene: an object with the member `elements`"
)]
pub(super) struct SceneText {
    #[serde(default)]
    pub(super) title: String,
    #[serde(default)]
    pub(super) description: String,
    #[serde(default)]
    pub(super) view: ViewText,
    #[serde(default)]
    pub(super) size: Option<[u32; 2]>,
    #[serde(default)]
    pub(super) axes: bool,
    #[serde(default)]
    pub(super) grid: bool,
    #[serde(default)]
    pub(super) legend: Option<bool>,
    pub(super) elements: Vec<ElementText>,
}

#[derive(Default, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a view: an object with `turn`, `zoom`, `projection`, `up`"
)]
pub(super) struct ViewText {
    pub(super) turn: Option<[f64; 2]>,
    pub(super) zoom: Option<f64>,
    #[serde(default)]
    pub(super) projection: Projection,
    #[serde(default)]
    pub(super) up: Up,
}

/// An element: its style, and a member for its kind.
#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "an element: an object such as {\"point\": [0, 0, 0]}"
)]
pub(super) struct ElementText {
    pub(super) name: Option<String>,
    pub(super) label: Option<String>,
    pub(super) colour: Option<String>,
    pub(super) width: Option<f64>,
    pub(super) opacity: Option<f64>,
    #[serde(default)]
    pub(super) hidden: bool,
    pub(super) point: Option<Place>,
    pub(super) flat_point: Option<Place>,
    pub(super) point_pair: Option<[Place; 2]>,
    pub(super) circle: Option<CircleText>,
    pub(super) sphere: Option<SphereText>,
    pub(super) line: Option<LineText>,
    pub(super) plane: Option<PlaneText>,
    pub(super) direction: Option<Place>,
    pub(super) motor: Option<MotorText>,
    pub(super) trajectory: Option<TrajectoryText>,
    pub(super) blade: Option<BTreeMap<String, f64>>,
    pub(super) meet: Option<[String; 2]>,
    pub(super) join: Option<[String; 2]>,
    pub(super) moved: Option<MovedText>,
}

const CIRCLE: &str =
    "a circle is {\"through\": three points} or {\"centre\", \"normal\", \"radius\"}";

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "an object: a circle is {\"through\": three points} or {\"centre\", \"normal\", \"radius\"}"
)]
struct CircleMembers {
    through: Option<[Place; 3]>,
    centre: Option<Place>,
    normal: Option<Place>,
    radius: Option<f64>,
}

#[derive(Deserialize)]
#[serde(try_from = "CircleMembers")]
pub(super) enum CircleText {
    Through {
        through: [Place; 3],
    },
    About {
        centre: Place,
        normal: Place,
        radius: f64,
    },
}

impl TryFrom<CircleMembers> for CircleText {
    type Error = &'static str;

    fn try_from(members: CircleMembers) -> Result<Self, &'static str> {
        let CircleMembers {
            through,
            centre,
            normal,
            radius,
        } = members;
        match (through, centre, normal, radius) {
            (Some(through), None, None, None) => Ok(Self::Through { through }),
            (None, Some(centre), Some(normal), Some(radius)) => Ok(Self::About {
                centre,
                normal,
                radius,
            }),
            _ => Err(CIRCLE),
        }
    }
}

const SPHERE: &str = "a sphere is {\"through\": four points} or {\"centre\", \"radius\"}";

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "an object: a sphere is {\"through\": four points} or {\"centre\", \"radius\"}"
)]
struct SphereMembers {
    through: Option<[Place; 4]>,
    centre: Option<Place>,
    radius: Option<f64>,
}

#[derive(Deserialize)]
#[serde(try_from = "SphereMembers")]
pub(super) enum SphereText {
    Through { through: [Place; 4] },
    About { centre: Place, radius: f64 },
}

impl TryFrom<SphereMembers> for SphereText {
    type Error = &'static str;

    fn try_from(members: SphereMembers) -> Result<Self, &'static str> {
        let SphereMembers {
            through,
            centre,
            radius,
        } = members;
        match (through, centre, radius) {
            (Some(through), None, None) => Ok(Self::Through { through }),
            (None, Some(centre), Some(radius)) => Ok(Self::About { centre, radius }),
            _ => Err(SPHERE),
        }
    }
}

const LINE: &str = "a line is {\"through\": two points} or {\"point\", \"direction\"}";

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "an object: a line is {\"through\": two points} or {\"point\", \"direction\"}"
)]
struct LineMembers {
    through: Option<[Place; 2]>,
    point: Option<Place>,
    direction: Option<Place>,
}

#[derive(Deserialize)]
#[serde(try_from = "LineMembers")]
pub(super) enum LineText {
    Through { through: [Place; 2] },
    Along { point: Place, direction: Place },
}

impl TryFrom<LineMembers> for LineText {
    type Error = &'static str;

    fn try_from(members: LineMembers) -> Result<Self, &'static str> {
        let LineMembers {
            through,
            point,
            direction,
        } = members;
        match (through, point, direction) {
            (Some(through), None, None) => Ok(Self::Through { through }),
            (None, Some(point), Some(direction)) => Ok(Self::Along { point, direction }),
            _ => Err(LINE),
        }
    }
}

const PLANE: &str =
    "a plane is {\"through\": three points}, {\"point\", \"normal\"} or {\"normal\", \"distance\"}";

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "an object: a plane is {\"through\": three points}, {\"point\", \"normal\"} or {\"normal\", \"distance\"}"
)]
struct PlaneMembers {
    through: Option<[Place; 3]>,
    point: Option<Place>,
    normal: Option<Place>,
    distance: Option<f64>,
}

#[derive(Deserialize)]
#[serde(try_from = "PlaneMembers")]
pub(super) enum PlaneText {
    Through { through: [Place; 3] },
    At { point: Place, normal: Place },
    Distant { normal: Place, distance: f64 },
}

impl TryFrom<PlaneMembers> for PlaneText {
    type Error = &'static str;

    fn try_from(members: PlaneMembers) -> Result<Self, &'static str> {
        let PlaneMembers {
            through,
            point,
            normal,
            distance,
        } = members;
        match (through, point, normal, distance) {
            (Some(through), None, None, None) => Ok(Self::Through { through }),
            (None, Some(point), Some(normal), None) => Ok(Self::At { point, normal }),
            (None, None, Some(normal), Some(distance)) => Ok(Self::Distant { normal, distance }),
            _ => Err(PLANE),
        }
    }
}

/// A rotation about an axis, followed by a translation.
#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a motor: an object with `axis`, `through`, `degrees`, `translation`"
)]
pub(super) struct MotorText {
    pub(super) axis: Option<Place>,
    #[serde(default)]
    pub(super) through: Place,
    #[serde(default)]
    pub(super) degrees: f64,
    #[serde(default)]
    pub(super) translation: Place,
}

const TRAJECTORY: &str = "a trajectory is {\"points\"}, {\"motors\"} or {\"screw\"}, the last two with \"steps\", \"point\", \"frames\"";

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "an object: a trajectory is {\"points\"}, {\"motors\"} or {\"screw\"}, the last two with \"steps\", \"point\", \"frames\""
)]
struct TrajectoryMembers {
    points: Option<Vec<Place>>,
    motors: Option<Vec<MotorText>>,
    screw: Option<ScrewText>,
    steps: Option<u32>,
    point: Option<Place>,
    frames: Option<usize>,
}

#[derive(Deserialize)]
#[serde(try_from = "TrajectoryMembers")]
pub(super) enum TrajectoryText {
    Points {
        points: Vec<Place>,
    },
    Motors {
        motors: Vec<MotorText>,
        steps: Option<u32>,
        point: Place,
        frames: usize,
    },
    Screw {
        screw: ScrewText,
        steps: Option<u32>,
        point: Place,
        frames: usize,
    },
}

impl TryFrom<TrajectoryMembers> for TrajectoryText {
    type Error = &'static str;

    fn try_from(members: TrajectoryMembers) -> Result<Self, &'static str> {
        let TrajectoryMembers {
            points,
            motors,
            screw,
            steps,
            point,
            frames,
        } = members;
        match (points, motors, screw, steps, point, frames) {
            (Some(points), None, None, None, None, None) => Ok(Self::Points { points }),
            (None, Some(motors), None, steps, point, frames) => Ok(Self::Motors {
                motors,
                steps,
                point: point.unwrap_or_default(),
                frames: frames.unwrap_or_default(),
            }),
            (None, None, Some(screw), steps, point, frames) => Ok(Self::Screw {
                screw,
                steps,
                point: point.unwrap_or_default(),
                frames: frames.unwrap_or_default(),
            }),
            _ => Err(TRAJECTORY),
        }
    }
}

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a screw: an object with `axis`, `through`, `degrees`, `shift`"
)]
pub(super) struct ScrewText {
    pub(super) axis: Place,
    #[serde(default)]
    pub(super) through: Place,
    #[serde(default)]
    pub(super) degrees: f64,
    #[serde(default)]
    pub(super) shift: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "an object with `element` and `by`")]
pub(super) struct MovedText {
    pub(super) element: String,
    pub(super) by: MotorText,
}
