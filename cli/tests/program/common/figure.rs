//! A figure of boxes and its motion, written by hand: what the program should make of it can be
//! worked out on paper.

use std::fmt::Write as _;
use std::path::Path;

/// Name, parent, head and tail of each bone: decimetres, y up, looking along z. It is 17 dm tall,
/// and its legs, from hip to ankle, are 8 dm long.
const BONES: [(&str, &str, [f64; 3], [f64; 3]); 9] = [
    ("hips", "", [0.0, 9.0, 0.0], [0.0, 12.0, 0.0]),
    ("chest", "hips", [0.0, 12.0, 0.0], [0.0, 15.0, 0.0]),
    ("head", "chest", [0.0, 15.0, 0.0], [0.0, 17.0, 0.0]),
    ("thigh l", "hips", [1.0, 9.0, 0.0], [1.0, 5.0, 0.0]),
    ("shin l", "thigh l", [1.0, 5.0, 0.0], [1.0, 1.0, 0.0]),
    ("foot l", "shin l", [1.0, 1.0, 0.0], [1.0, 0.5, 2.0]),
    ("thigh r", "hips", [-1.0, 9.0, 0.0], [-1.0, 5.0, 0.0]),
    ("shin r", "thigh r", [-1.0, 5.0, 0.0], [-1.0, 1.0, 0.0]),
    ("foot r", "shin r", [-1.0, 1.0, 0.0], [-1.0, 0.5, 2.0]),
];

/// The box round each bone: half its width, and where it begins and ends in y and z.
const BOXES: [(f64, [f64; 2], [f64; 2]); 9] = [
    (1.5, [9.0, 12.0], [-0.7, 0.7]),
    (1.7, [12.0, 15.0], [-0.8, 0.8]),
    (0.7, [15.0, 17.0], [-0.8, 0.8]),
    (0.6, [5.0, 9.0], [-0.6, 0.6]),
    (0.5, [1.0, 5.0], [-0.5, 0.5]),
    (0.5, [0.0, 1.0], [-0.5, 2.0]),
    (0.6, [5.0, 9.0], [-0.6, 0.6]),
    (0.5, [1.0, 5.0], [-0.5, 0.5]),
    (0.5, [0.0, 1.0], [-0.5, 2.0]),
];

/// Units of the motion in a metre.
pub(crate) const UNITS: f64 = 20.0;

/// Frames of the motion in a second.
pub(crate) const RATE: f64 = 50.0;

/// How far the body goes in each frame, in units of the motion.
pub(crate) const STEP: f64 = 0.4;

/// Writes `mesh.obj`, `rig.json`, `weights.json` and `motion.bvh` into a folder.
pub(crate) fn write(folder: &Path, frames: usize) {
    let write = |name: &str, text: String| std::fs::write(folder.join(name), text).unwrap();
    write("mesh.obj", obj());
    write("rig.json", rig());
    write("weights.json", weights());
    write("motion.bvh", bvh(frames, false));
}

/// The boxes, in group `body`, and a triangle high above in group `guide`.
pub(crate) fn obj() -> String {
    let mut text = "g body\n".to_owned();
    for ((_, _, head, _), (half, y, z)) in BONES.iter().zip(BOXES) {
        for corner in 0..8 {
            let x = head[0] + if corner & 1 == 0 { -half } else { half };
            let _ = writeln!(text, "v {x} {} {}", y[corner >> 1 & 1], z[corner >> 2]);
        }
        for [a, b, c, d] in [
            [1, 3, 4, 2],
            [5, 6, 8, 7],
            [1, 2, 6, 5],
            [3, 7, 8, 4],
            [1, 5, 7, 3],
            [2, 4, 8, 6],
        ] {
            let _ = writeln!(text, "f {} {} {} {}", a - 9, b - 9, c - 9, d - 9);
        }
    }
    text + "g guide\nv 0 30 0\nv 1 30 0\nv 0 31 0\nf -3 -2 -1\n"
}

/// The bones as Blender has them: z up, looking along -y, ten times as long a unit.
pub(crate) fn rig() -> String {
    let blender = |[x, y, z]: [f64; 3]| format!("[{}, {}, {}]", x / 10.0, -z / 10.0, y / 10.0);
    let bones = BONES.map(|(name, parent, head, tail)| {
        format!(
            r#""{name}": {{"head": {{"default_position": {}}}, "tail": {{"default_position": {}}}, "parent": "{parent}"}}"#,
            blender(head),
            blender(tail),
        )
    });
    format!("{{{}}}", bones.join(",\n"))
}

/// Each box follows its bone, the triangle the head; the lower edge of a shin follows the thigh a
/// little, too.
pub(crate) fn weights() -> String {
    let bones = BONES.iter().enumerate().map(|(bone, (name, ..))| {
        let mut list: Vec<String> = (8 * bone..8 * bone + 8)
            .map(|vertex| format!("[{vertex}, 0.75]"))
            .collect();
        if *name == "head" {
            list.extend((72..75).map(|vertex| format!("[{vertex}, 1]")));
        }
        if name.starts_with("thigh") {
            list.extend((8 * bone + 8..8 * bone + 10).map(|vertex| format!("[{vertex}, 0.25]")));
        }
        format!(r#""{name}": [{}]"#, list.join(", "))
    });
    format!(
        r#"{{"weights": {{{}}}}}"#,
        bones.collect::<Vec<_>>().join(",\n")
    )
}

/// The body goes ahead along z while its legs swing; the motion has no head. `calibration` puts a
/// frame before the others in which the body lies far to one side.
pub(crate) fn bvh(frames: usize, calibration: bool) -> String {
    let mut text = "HIERARCHY\n".to_owned();
    joint("", &mut text);
    let count = frames + usize::from(calibration);
    let _ = writeln!(text, "MOTION\nFrames: {count}\nFrame Time: {}", 1.0 / RATE);
    if calibration {
        text += &("30 18 0".to_owned() + &" 0".repeat(3 * 8) + "\n");
    }
    for frame in 0..frames {
        let swing = 30.0 * (0.5 * frame as f64).sin();
        let _ = write!(text, "0 18 {} 0 0 0 0 0 0", STEP * frame as f64);
        for side in [1.0, -1.0] {
            let _ = write!(text, " 0 0 {} 0 0 {} 0 0 0", side * swing, swing.abs());
        }
        text.push('\n');
    }
    text
}

/// The joints below `parent`, and what is below them.
fn joint(parent: &str, text: &mut String) {
    for (name, _, head, tail) in BONES
        .iter()
        .filter(|bone| bone.1 == parent && bone.0 != "head")
    {
        let above = BONES
            .iter()
            .find(|bone| bone.0 == parent)
            .map_or([0.0; 3], |bone| bone.2);
        let offset = |from: [f64; 3], to: [f64; 3]| {
            let [x, y, z] = [0, 1, 2].map(|axis| (to[axis] - from[axis]) * UNITS / 10.0);
            format!("OFFSET {x} {y} {z}\n")
        };
        let (keyword, channels, place) = if parent.is_empty() {
            (
                "ROOT",
                "6 Xposition Yposition Zposition ",
                "OFFSET 0 0 0\n".to_owned(),
            )
        } else {
            ("JOINT", "3 ", offset(above, *head))
        };
        *text += &format!(
            "{keyword} {name}\n{{\n{place}CHANNELS {channels}Zrotation Yrotation Xrotation\n"
        );
        joint(name, text);
        if !BONES.iter().any(|bone| bone.1 == *name && bone.0 != "head") {
            *text += &format!("End Site\n{{\n{}}}\n", offset(*head, *tail));
        }
        *text += "}\n";
    }
}
