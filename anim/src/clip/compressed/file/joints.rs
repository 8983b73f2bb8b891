//! The constants of a joint in a file.

use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;

use super::super::layout::{JointLayout, Part};
use super::cursor::{Cursor, is_short, put_rotor, put_short_rotor, put_variable, put_vector};
use crate::transform::Transform;

/// Constants that differ from those that most joints have, and are therefore written.
const SCALED: u8 = 1;
const ROTATED: u8 = 2;
const REST_ELSEWHERE: u8 = 4;
const REST_ROTATED: u8 = 8;
const REST_SCALED: u8 = 16;
/// Rotors in steps: those of the rotation, and the axes of the translation.
const SHORT_ROTATION: u8 = 32;
const SHORT_TRANSLATION: u8 = 64;

/// The factors of a joint that is not scaled.
fn unscaled() -> Vector<f32> {
    Vector::new(1.0, 1.0, 1.0)
}

pub(super) fn write(bytes: &mut Vec<u8>, layout: &JointLayout, rest: &Transform<f64>) {
    let (place, rotor, scale) = single(rest);
    let flags = [
        (SCALED, layout.scale.constant != unscaled()),
        (ROTATED, layout.middle != Rotor::default()),
        (REST_ELSEWHERE, place != layout.translation.constant),
        (REST_ROTATED, rotor != Rotor::default()),
        (REST_SCALED, scale != unscaled()),
        (
            SHORT_ROTATION,
            is_short(layout.middle) && is_short(layout.rotation.axes),
        ),
        (SHORT_TRANSLATION, is_short(layout.translation.axes)),
    ];
    let flags = flags
        .iter()
        .filter(|(_, set)| *set)
        .fold(0, |flags, (flag, _)| flags | flag);
    let live = [
        layout.translation.live,
        layout.scale.live,
        layout.rotation.live,
    ];
    put_variable(bytes, layout.parent.map_or(0, |parent| parent as u32 + 1));
    bytes.push((live[0] | live[1] << 2 | live[2] << 4) as u8);
    bytes.push(flags);
    put_vector(bytes, layout.translation.constant);
    if flags & SCALED != 0 {
        put_vector(bytes, layout.scale.constant);
    }
    let put = |bytes: &mut Vec<u8>, short: u8, rotor| match flags & short {
        0 => put_rotor(bytes, rotor),
        _ => put_short_rotor(bytes, rotor),
    };
    if flags & ROTATED != 0 {
        put(bytes, SHORT_ROTATION, layout.middle);
    }
    for (short, part) in [
        (SHORT_TRANSLATION, &layout.translation),
        (0, &layout.scale),
        (SHORT_ROTATION, &layout.rotation),
    ] {
        if part.live > 0 {
            put(bytes, short, part.axes);
        }
    }
    if flags & REST_ELSEWHERE != 0 {
        put_vector(bytes, place);
    }
    if flags & REST_ROTATED != 0 {
        put_rotor(bytes, rotor);
    }
    if flags & REST_SCALED != 0 {
        put_vector(bytes, scale);
    }
}

/// The joint at `index`; `None` unless the bytes are one, with a parent before it.
pub(super) fn read(cursor: &mut Cursor, index: usize) -> Option<(JointLayout, Transform<f32>)> {
    let parent = (cursor.variable()? as usize).checked_sub(1);
    if parent.is_some_and(|parent| parent >= index) {
        return None;
    }
    let (live, flags) = (cursor.u8()?, cursor.u8()?);
    let live = [live & 3, live >> 2 & 3, live >> 4].map(usize::from);
    if live[2] > 3 || flags >= 2 * SHORT_TRANSLATION {
        return None;
    }
    let has = |flag| flags & flag != 0;
    let translation = cursor.vector()?;
    let scale = if has(SCALED) {
        cursor.vector()?
    } else {
        unscaled()
    };
    let middle = match (has(ROTATED), has(SHORT_ROTATION)) {
        (false, _) => Rotor::default(),
        (true, false) => cursor.rotor()?,
        (true, true) => cursor.short_rotor()?,
    };
    let mut part = |constant, live, is_short| {
        let axes = match (live > 0, is_short) {
            (false, _) => Rotor::default(),
            (true, false) => cursor.rotor()?,
            (true, true) => cursor.short_rotor()?,
        };
        Some(Part {
            constant,
            live,
            axes,
        })
    };
    let layout = JointLayout {
        parent,
        translation: part(translation, live[0], has(SHORT_TRANSLATION))?,
        scale: part(scale, live[1], false)?,
        rotation: part(Vector::default(), live[2], has(SHORT_ROTATION))?,
        middle,
    };
    let place = if has(REST_ELSEWHERE) {
        cursor.vector()?
    } else {
        translation
    };
    let rotor = if has(REST_ROTATED) {
        cursor.rotor()?
    } else {
        Rotor::default()
    };
    let scale = if has(REST_SCALED) {
        cursor.vector()?
    } else {
        unscaled()
    };
    Some((layout, Transform::from_parts(place, rotor, scale)))
}

/// The parts of a transform in single precision.
fn single(transform: &Transform<f64>) -> (Vector<f32>, Rotor<f32>, Vector<f32>) {
    use super::super::layout::{single, single_rotor};
    (
        single(transform.translation()),
        single_rotor(transform.rotor()),
        single(transform.scale),
    )
}
