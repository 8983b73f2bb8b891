//! Dots in space: where the rays of two views to dots of one hue meet.

use ga_runtime::vga3::Vector;

use crate::marker::{Dot, Hue};
use ga_camera::Camera;
use ga_camera::triangulation::triangulate_views;

/// Two rays meet where the point is as near as this to both pixels.
const MEETING_PX: f64 = 1.0;
/// No place on a skin is seen from two directions with a greater angle, in radians.
const WIDEST: f64 = 2.2;
/// From directions with a smaller angle, its depth is not known.
const NARROWEST: f64 = 0.02;

/// A dot that two views show, or two dots of one hue that are taken for one.
#[derive(Clone, Copy, Debug)]
pub(super) struct SpaceDot {
    pub(super) hue: Hue,
    pub(super) position: Vector<f64>,
    /// View and dot of both.
    pub(super) seen: [(usize, usize); 2],
}

/// All places where dots can be.
pub(super) fn space_dots(cameras: &[Camera], dots: &[Vec<Dot>]) -> Vec<SpaceDot> {
    let mut found = Vec::new();
    for second in 0..cameras.len() {
        for first in 0..second {
            let pair = [cameras[first], cameras[second]];
            for (a, left) in dots[first].iter().enumerate() {
                for (b, right) in dots[second].iter().enumerate() {
                    if left.hue != right.hue {
                        continue;
                    }
                    let Ok(met) = triangulate_views(&pair, &[left.centre, right.centre]) else {
                        continue;
                    };
                    let is_met = met.error_px <= MEETING_PX
                        && (NARROWEST..WIDEST).contains(&met.angle)
                        && met.depth > 0.0;
                    if is_met {
                        found.push(SpaceDot {
                            hue: left.hue,
                            position: met.position.into(),
                            seen: [(first, a), (second, b)],
                        });
                    }
                }
            }
        }
    }
    found
}
