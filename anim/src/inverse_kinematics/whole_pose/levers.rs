//! What moves which marker.

use ga_runtime::vga3::Vector;

use super::Marker;
use crate::skeleton::Skeleton;

/// The markers by which a joint's rotation is seen directly.
#[derive(Clone, Debug, Default)]
pub(super) struct Levers {
    pub(super) markers: Vec<usize>,
    pub(super) at_head: Option<usize>,
}

/// The joints that move a marker, from the root on.
pub(super) fn movers(skeleton: &Skeleton, marker: &Marker) -> Vec<usize> {
    let joints = skeleton.joints();
    let mut movers = Vec::new();
    let mut above = Some(marker.joint);
    while let Some(joint) = above {
        // A joint does not move a marker at its own head.
        if joint != marker.joint || joints[joint].head != marker.at_rest {
            movers.push(joint);
        }
        above = joints[joint].parent;
    }
    movers.reverse();
    movers
}

/// For each joint, the markers that keep their distances from its head however other joints rotate:
/// those that it carries itself, those of joints that are in the same place, and those at the heads
/// of the joints below these.
pub(super) fn levers(skeleton: &Skeleton, markers: &[Marker]) -> Vec<Levers> {
    let joints = skeleton.joints();
    let mut levers: Vec<Levers> = vec![Levers::default(); joints.len()];
    for (index, marker) in markers.iter().enumerate() {
        let own = marker.joint;
        if marker.at_rest == joints[own].head {
            levers[own].at_head.get_or_insert(index);
        }
        // Up through joints in the place of the marker's pivot: the joint that carries it, or, for
        // a marker at a joint's head, the joint above.
        let mut above = match marker.at_rest == joints[own].head {
            true => joints[own].parent,
            false => Some(own),
        };
        let mut pivot = None;
        while let Some(joint) = above {
            let head = joints[joint].head;
            if head == marker.at_rest {
                levers[joint].at_head.get_or_insert(index);
            } else if pivot.is_none_or(|pivot| pivot == head) {
                pivot = Some(head);
                levers[joint].markers.push(index);
            } else {
                break;
            }
            above = joints[joint].parent;
        }
    }
    levers
}

/// The greatest distance of a marker from the first one at rest; 1 where there is none.
pub(super) fn extent(markers: &[Marker]) -> f64 {
    let first = Vector::from(markers[0].at_rest);
    let distances = markers
        .iter()
        .map(|marker| first.distance(marker.at_rest.into()));
    let extent = distances.fold(0.0, f64::max);
    if extent > 0.0 { extent } else { 1.0 }
}
