//! Retargeting: figures of every recording on every character, found from the places of joints
//! and without the checks of the crate.
//!
//! The environment variable `NULLCONE_PAIRS` names a folder with more recordings (`.bvh`) and
//! characters (`.gltf`, `.glb`, `rig.….json`); `--nocapture` shows the table.

use std::path::{Path, PathBuf};

use ga_anim::bvh;
use ga_anim::motion_file::{self, MotionFile};
use ga_anim::recording::Recording;
use ga_anim::retarget::{FootLocking, Options, Retarget, Soles, Source, Target};
use ga_anim::rig;
use ga_anim::skeleton::Skeleton;
use ga_anim::unit::likely_unit;
use ga_runtime::cga3::{Direction, Motor, Point};
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;

const UP: Vector<f64> = Vector {
    e1: 0.0,
    e2: 1.0,
    e3: 0.0,
};

/// The joints of a person: hips and head, and of each side thigh, shin, foot, upper arm, forearm
/// and hand.
#[derive(Clone, Copy, Debug)]
struct Person {
    hips: usize,
    head: usize,
    legs: [[usize; 3]; 2],
    arms: [[Option<usize>; 3]; 2],
}

/// The names of hips, head, thigh, shin, foot, upper arm, forearm and hand; `#` is `Left` or
/// `Right`, and `*` is `L` or `R`, both in small letters too. The numbers are those of nodes
/// without names.
const NAMES: [[[&str; 8]; 2]; 9] = [
    both([
        "Hips", "Head", "#UpLeg", "#Leg", "#Foot", "#Arm", "#ForeArm", "#Hand",
    ]),
    both([
        "Hips", "Head", "#UpLeg", "#Leg", "#Foot", "#Arm", "#ForeArm", "Palm2*",
    ]),
    both([
        "Hips",
        "Head",
        "#Hip",
        "#Knee",
        "#Ankle",
        "#Shoulder",
        "#Elbow",
        "#Wrist",
    ]),
    both([
        "pelvis",
        "head",
        "thigh_%",
        "calf_%",
        "foot_%",
        "upperarm_%",
        "lowerarm_%",
        "hand_%",
    ]),
    both([
        "pelvis",
        "neck",
        "thigh.*",
        "shin.*",
        "foot.*",
        "upper_arm.*",
        "forearm.*",
        "hand.*",
    ]),
    both([
        "spine",
        "spine.006",
        "thigh.*",
        "shin.*",
        "foot.*",
        "upper_arm.*",
        "forearm.*",
        "hand.*",
    ]),
    both([
        "root",
        "head",
        "upperleg01.*",
        "lowerleg01.*",
        "foot.*",
        "upperarm01.*",
        "lowerarm01.*",
        "wrist.*",
    ]),
    both([
        "hip", "head", "*Thigh", "*Shin", "*Foot", "*Shldr", "*ForeArm", "*Hand",
    ]),
    [
        [
            "node 2", "node 20", "node 7", "node 8", "node 9", "node 16", "node 17", "node 18",
        ],
        [
            "node 2", "node 20", "node 3", "node 4", "node 5", "node 13", "node 14", "node 15",
        ],
    ],
];

const fn both(names: [&str; 8]) -> [[&str; 8]; 2] {
    [names, names]
}

impl Person {
    fn new(names: &[&str]) -> Option<Self> {
        let place = |pattern: &str, side: usize| {
            let name = pattern
                .replace('#', ["Left", "Right"][side])
                .replace('*', ["L", "R"][side])
                .replace('%', ["l", "r"][side]);
            names
                .iter()
                .position(|other| other.rsplit(':').next() == Some(&name))
        };
        NAMES.iter().find_map(|sides| {
            let side = |k: usize| {
                let [_, _, rest @ ..] = sides[k];
                let [a, b, c, d, e, f] = rest.map(|pattern| place(pattern, k));
                Some(([a?, b?, c?], [d, e, f]))
            };
            let [left, right] = [side(0)?, side(1)?];
            Some(Self {
                hips: place(sides[0][0], 0)?,
                head: place(sides[0][1], 0)?,
                legs: [left.0, right.0],
                arms: [left.1, right.1],
            })
        })
    }
}

/// What a motion is transferred to.
struct Character {
    name: String,
    skeleton: Skeleton,
    soles: Option<Soles>,
}

/// What is measured of a motion on a character: angles in degrees, but those of bones in radians.
#[derive(Clone, Debug, Default)]
struct Figures {
    trunk: f64,
    bones: f64,
    /// The median and the 95 per cent of the soles while they stand.
    soles: [f64; 2],
    head: f64,
    stretch: f64,
    /// The greatest way of a standing ankle with foot locking, in millimetres.
    slide: f64,
    /// The greatest rotation of a joint from frame to frame beyond the greatest of the source.
    excess: f64,
    /// The median angle between a standing foot and where the pelvis looks.
    heading: f64,
    /// The parts of the frames in which a knee bends backwards.
    knees: f64,
    /// The height of the soles that a quarter of the frames is below, in legs.
    height: f64,
}

fn degrees(a: Vector<f64>, b: Vector<f64>) -> f64 {
    a.angle(b).map_or(0.0, f64::to_degrees)
}

fn horizontal(v: Vector<f64>) -> Vector<f64> {
    Vector::new(v.e1, 0.0, v.e3)
}

fn quantile(values: &mut [f64], part: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => 0.0,
        count => values[((count - 1) as f64 * part) as usize],
    }
}

/// The angle between two rotations.
fn turn(from: Motor<f64>, to: Motor<f64>) -> f64 {
    let (_, angle) = (to.rotor() * from.rotor().reverse()).to_axis_angle();
    let angle = angle.to_degrees().rem_euclid(360.0);
    angle.min(360.0 - angle)
}

/// The longest runs of frames in which consecutive places are nearer than a step.
fn runs(places: &[Vector<f64>], step: f64) -> Vec<std::ops::Range<usize>> {
    let mut runs = Vec::new();
    let mut first = 0;
    for frame in 1..=places.len() {
        if frame == places.len() || places[frame].distance(places[frame - 1]) > step {
            if frame - first > 2 {
                runs.push(first..frame);
            }
            first = frame;
        }
    }
    runs
}

fn measure(source: &dyn Source, unit: f64, character: &Character) -> Option<Figures> {
    let Character {
        skeleton, soles, ..
    } = character;
    let there = Person::new(&source.names())?;
    let names: Vec<&str> = skeleton.joints().iter().map(|j| j.name.as_str()).collect();
    let here = Person::new(&names)?;
    let options = Options {
        soles: soles.as_ref(),
        ..Options::default()
    };
    let retarget = Retarget::new(source, skeleton, &options).unwrap();
    let Some(up) = retarget.found_up_axis() else {
        println!("{}: no person", character.name);
        return None;
    };
    let upright = up.axis.to_y();
    let map = ga_anim::retarget::JointMap::by_names_or_structure(source, skeleton).ok()?;
    let locked = retarget.with_foot_locking(&FootLocking::new(unit)).unwrap();
    let heads: Vec<Vector<f64>> = skeleton.joints().iter().map(|j| j.head.into()).collect();
    let leg = |[hip, knee, ankle]: [usize; 3]| {
        heads[hip].distance(heads[knee]) + heads[knee].distance(heads[ankle])
    };
    let leg = here.legs.map(leg).iter().sum::<f64>() / 2.0;
    let lowest_at_rest = heads
        .iter()
        .map(|head| head.e2)
        .fold(f64::INFINITY, f64::min);

    let mut figures = Figures::default();
    let (mut flat, mut heights) = (Vec::new(), Vec::new());
    let mut backwards = [0; 2];
    let mut source_ankles = [Vec::new(), Vec::new()];
    let mut locked_ankles = [Vec::new(), Vec::new()];
    let mut tilts = [Vec::new(), Vec::new()];
    let mut before: Option<[Vec<Motor<f64>>; 2]> = None;
    let count = source.frame_count();
    for frame in 0..count {
        let motors: Vec<Motor<f64>> = source.frames_of_joints(frame)?;
        let motors: Vec<Motor<f64>> = motors.into_iter().map(|motor| upright * motor).collect();
        let recorded = |joint: usize| Vector::from(motors[joint].transform(Point::default()));
        let motions = retarget.pose(frame).unwrap().motions(skeleton).unwrap();
        let place = |joint: usize| {
            let head = Point::from(skeleton.joints()[joint].head);
            Vector::from(motions[joint].transform(head))
        };
        let rotated = |joint: usize, v: Vector<f64>| {
            Vector::from(motions[joint].rotor().transform(Direction::from(v)))
        };
        let trunk = place(here.head) - place(here.hips);
        let angle = degrees(trunk, recorded(there.head) - recorded(there.hips));
        figures.trunk = figures.trunk.max(angle);
        figures.head = figures.head.max(degrees(rotated(here.head, UP), trunk));
        let mut bone = |[a, b]: [usize; 2], [c, d]: [usize; 2]| {
            let angle = (place(b) - place(a)).angle(recorded(d) - recorded(c));
            figures.bones = figures.bones.max(angle.unwrap_or(0.0));
            let now = place(b).distance(place(a)) / heads[b].distance(heads[a]);
            figures.stretch = figures.stretch.max((now - 1.0).abs());
        };
        for side in 0..2 {
            for k in 0..2 {
                let pair = |joints: [usize; 3]| [joints[k], joints[k + 1]];
                bone(pair(here.legs[side]), pair(there.legs[side]));
                let pair = |joints: [Option<usize>; 3]| Some([joints[k]?, joints[k + 1]?]);
                if let (Some(ours), Some(theirs)) = (pair(here.arms[side]), pair(there.arms[side]))
                {
                    bone(ours, theirs);
                }
            }
        }
        let left = heads[here.legs[0][0]] - heads[here.legs[1][0]];
        let forward = rotated(here.hips, left).cross(UP);
        for (side, [hip, knee, ankle]) in here.legs.into_iter().enumerate() {
            let (thigh, shin) = (place(knee) - place(hip), place(ankle) - place(knee));
            let hinge = thigh.cross(shin);
            if degrees(thigh, shin) > 15.0 && hinge.dot(rotated(hip, left)) < 0.0 {
                backwards[side] += 1;
            }
            source_ankles[side].push(recorded(there.legs[side][2]));
            tilts[side].push([
                degrees(rotated(ankle, UP), UP),
                degrees(
                    horizontal(rotated(ankle, left.cross(UP))),
                    horizontal(forward),
                ),
            ]);
            let motions = locked.pose(frame).unwrap().motions(skeleton).unwrap();
            let head = Point::from(skeleton.joints()[ankle].head);
            locked_ankles[side].push(Vector::from(motions[ankle].transform(head)));
        }
        let feet = here.legs.map(|[_, _, ankle]| place(ankle).e2);
        let at_rest = here
            .legs
            .map(|[_, _, ankle]| heads[ankle].e2 - lowest_at_rest);
        heights.push((feet[0] - at_rest[0]).min(feet[1] - at_rest[1]) / leg);
        if let Some([ours, theirs]) = &before {
            let greatest = |a: &[Motor<f64>], b: &[Motor<f64>]| {
                a.iter()
                    .zip(b)
                    .map(|(&a, &b)| turn(a, b))
                    .collect::<Vec<_>>()
            };
            let (ours, theirs) = (greatest(ours, &motions), greatest(theirs, &motors));
            for (joint, source) in map.source_of().iter().enumerate() {
                if let Some(source) = *source {
                    figures.excess = figures.excess.max(ours[joint] - theirs[source]);
                }
            }
        }
        before = Some([motions, motors]);
    }
    let step = 0.05 * source.frame_time() / unit;
    let mut turned = Vec::new();
    for side in 0..2 {
        for run in runs(&source_ankles[side], step) {
            let places = &locked_ankles[side][run.clone()];
            for place in places {
                let way = place.distance(places[0]);
                figures.slide = figures.slide.max(1e3 * way * 0.9 / leg);
            }
            let heights = source_ankles[side].iter().map(|place| place.e2);
            let low = heights.fold(f64::INFINITY, f64::min) + 0.1 * leg / retarget.scale();
            for frame in run.filter(|&frame| source_ankles[side][frame].e2 <= low) {
                let [tilt, heading] = tilts[side][frame];
                flat.push(tilt);
                turned.push(heading);
            }
        }
    }
    figures.soles = [0.5, 0.95].map(|part| quantile(&mut flat, part));
    figures.heading = quantile(&mut turned, 0.5);
    figures.height = quantile(&mut heights, 0.25);
    figures.knees = backwards
        .iter()
        .max()
        .map_or(0.0, |&most| f64::from(most) / count as f64);
    Some(figures)
}

fn files(folder: &Path, endings: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let Ok(entries) = std::fs::read_dir(folder) else {
        return found;
    };
    for entry in entries.flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(files(&path, endings));
        } else if path
            .extension()
            .is_some_and(|ending| endings.iter().any(|other| ending == *other))
        {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn recordings(folders: &[PathBuf]) -> Vec<(String, Recording)> {
    let mut found = Vec::new();
    for path in folders.iter().flat_map(|folder| files(folder, &["bvh"])) {
        let Ok(motion) = bvh::read(&path) else {
            continue;
        };
        if Person::new(&Source::names(&motion)).is_some() {
            found.push((name(&path), Recording::from_bvh(&motion, 1.0).unwrap()));
        }
    }
    for path in folders
        .iter()
        .flat_map(|folder| files(folder, &["gltf", "glb"]))
    {
        let Ok(document) = ga_mesh::gltf::read(&path) else {
            continue;
        };
        if let Ok(recording) = Recording::from_gltf(&document, 0, 1.0, None)
            && Person::new(&Source::names(&recording)).is_some()
        {
            found.push((name(&path), recording));
        }
    }
    found
}

fn characters(folders: &[PathBuf]) -> Vec<Character> {
    let mut found = Vec::new();
    let mut add = |path: &Path, skeleton: &Skeleton, soles: Option<Soles>| {
        let names: Vec<&str> = skeleton.joints().iter().map(|j| j.name.as_str()).collect();
        if Person::new(&names).is_some() {
            found.push(Character {
                name: name(path),
                skeleton: skeleton.clone(),
                soles,
            });
        }
    };
    for path in folders
        .iter()
        .flat_map(|folder| files(folder, &["gltf", "glb"]))
    {
        let Ok(file) = MotionFile::read(&path, motion_file::Options::default()) else {
            continue;
        };
        if let Ok(target) = Target::new(file) {
            add(&path, target.skeleton(), target.soles().cloned());
        }
    }
    for path in folders.iter().flat_map(|folder| files(folder, &["json"])) {
        if name(&path).starts_with("rig.")
            && let Ok(skeleton) = rig::read(&path)
        {
            add(&path, &skeleton.scaled(rig::METRES_PER_UNIT).unwrap(), None);
        }
    }
    found
}

fn name(path: &Path) -> String {
    path.file_stem().unwrap().to_string_lossy().into_owned()
}

#[test]
fn every_recording_moves_every_character_as_recorded() {
    let Some(data) = shared("data/anim") else {
        return;
    };
    let Some(cases) = shared("cases/motion") else {
        return;
    };
    let more = std::env::var_os("NULLCONE_PAIRS").map(PathBuf::from);
    let folders: Vec<PathBuf> = [data, cases].into_iter().chain(more).collect();
    let (recordings, characters) = (recordings(&folders), characters(&folders));
    let counts = [recordings.len(), characters.len()];
    assert!(counts[0] >= 8 && counts[1] >= 7, "{counts:?}");
    println!(
        "{:16} {:16} {:>7} {:>8} {:>6} {:>6} {:>6} {:>8} {:>7} {:>7} {:>7} {:>6} {:>7}",
        "recording",
        "character",
        "trunk",
        "bones",
        "sole",
        "95 %",
        "head",
        "stretch",
        "slide",
        "excess",
        "heading",
        "knees",
        "height"
    );
    let mut beyond = Vec::new();
    for (recording, source) in &recordings {
        let unit = likely_unit(source).metres;
        for character in &characters {
            let Some(f) = measure(source, unit, character) else {
                continue;
            };
            println!(
                "{recording:16.16} {:16.16} {:7.3} {:8.1e} {:6.1} {:6.1} {:6.1} {:8.1e} {:7.2} {:7.2} {:7.1} {:6.3} {:7.3}",
                character.name,
                f.trunk,
                f.bones,
                f.soles[0],
                f.soles[1],
                f.head,
                f.stretch,
                f.slide,
                f.excess,
                f.heading,
                f.knees,
                f.height
            );
            let bounds = [
                ("the trunk in degrees", f.trunk, 0.1),
                ("thighs, shins and arms in radians", f.bones, 1e-6),
                ("soles in degrees", f.soles[0], 5.0),
                ("the head in degrees", f.head, 60.0),
                ("bones, as a part of their lengths", f.stretch, 1e-6),
                ("a standing foot in millimetres", f.slide, 5.0),
                ("a rotation in degrees a frame", f.excess, 60.0),
                ("a foot's direction in degrees", f.heading, 60.0),
                ("the frames with a knee bent backwards", f.knees, 0.05),
            ];
            for (what, found, most) in bounds {
                if found > most {
                    beyond.push(format!("{recording} on {}: {what} {found}", character.name));
                }
            }
        }
    }
    assert!(beyond.is_empty(), "{beyond:#?}");
}
