//! Inverse kinematics against plain geometry, and there and back.

mod aim;
mod fabrik;
mod two_bone;
mod whole_pose;

use ga_anim::skeleton::{Joint, Skeleton};
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

fn points(size: f64) -> impl Strategy<Value = Point<f64>> {
    prop::array::uniform3(-size..size).prop_map(Point::from)
}

fn vectors() -> impl Strategy<Value = Vector<f64>> {
    prop::array::uniform3(-1.0..1.0_f64)
        .prop_map(Vector::from)
        .prop_filter("short", |vector| vector.length() > 0.1)
}

/// A chain of joints at these places, named a, b, c and so on, each with its bone to the next.
fn chain(places: &[[f64; 3]]) -> Skeleton {
    let joints = places.iter().enumerate().map(|(index, &head)| Joint {
        name: char::from(b'a' + index as u8).to_string(),
        parent: index.checked_sub(1),
        head,
        tail: places.get(index + 1).copied().unwrap_or(head),
    });
    Skeleton::new(joints.collect()).unwrap()
}
