//! The places of labels.

use crate::camera::{Camera, Pixel};
use crate::picture::Picture;

/// The size of the letters in pixels.
pub(crate) const LETTER: f64 = 15.0;

/// The index of a label, and the middle of its box.
#[derive(Clone, Debug)]
pub(crate) struct PlacedLabel {
    pub(crate) label: usize,
    pub(crate) middle: Pixel,
}

/// A box: its upper left and its lower right corner.
pub(crate) type Frame = [Pixel; 2];

/// The approximate width of a text: 0.58 of the letter size for each letter, the whole size for the
/// wide letters of East Asia, and nothing for combining marks.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    let letters = text.chars().map(|letter| match letter as u32 {
        0x300..0x370 => 0.0,
        0x2e80.. => 1.0,
        _ => 0.58,
    });
    size * letters.sum::<f64>()
}

/// Places labels beside their anchors, so that they cover neither each other nor dots nor the boxes
/// that are taken, and so that they stand away from the middle of the picture where possible.
pub(crate) fn placed(
    picture: &Picture,
    camera: &Camera,
    [width, height]: Pixel,
    taken: &[Frame],
) -> Vec<PlacedLabel> {
    let mut taken = taken.to_vec();
    for dot in &picture.dots {
        let [x, y] = camera.project(dot.at);
        let r = dot.radius;
        taken.push([[x - r, y - r], [x + r, y + r]]);
    }
    let mut labels = Vec::new();
    // The labels of elements are placed before those of axes.
    for strong in [true, false] {
        for (index, label) in picture.labels.iter().enumerate() {
            if label.strong != strong {
                continue;
            }
            let at = camera.project(label.at);
            let half = [0.5 * text_width(&label.text, LETTER), 0.5 * LETTER];
            let (away_x, away_y) = (at[0] - camera.middle[0], at[1] - camera.middle[1]);
            let mut candidates: Vec<(f64, Pixel)> = SIDES
                .iter()
                .map(|[x, y]| {
                    let middle = [at[0] + x * (half[0] + 8.0), at[1] + y * (half[1] + 8.0)];
                    let preference = x * away_x + y * away_y;
                    (preference, middle)
                })
                .collect();
            // A stable sort: of equal candidates the first one listed stays first.
            candidates.sort_by(|a, b| b.0.total_cmp(&a.0));
            let cost = |middle: &Pixel| {
                let own = frame(*middle, half);
                let outside = own[0][0] < 2.0
                    || own[0][1] < 2.0
                    || own[1][0] > width - 2.0
                    || own[1][1] > height - 2.0;
                let covered: f64 = taken.iter().map(|other| overlap(&own, other)).sum();
                covered + if outside { 1e4 } else { 0.0 }
            };
            let best = candidates
                .iter()
                .map(|(_, middle)| *middle)
                .reduce(|best, next| {
                    if cost(&next) < cost(&best) {
                        next
                    } else {
                        best
                    }
                });
            let Some(middle) = best else { continue };
            taken.push(frame(middle, half));
            labels.push(PlacedLabel {
                label: index,
                middle,
            });
        }
    }
    labels
}

/// The directions in which a label may stand from its anchor.
const SIDES: [Pixel; 8] = [
    [0.8, -0.8],
    [-0.8, -0.8],
    [0.8, 0.8],
    [-0.8, 0.8],
    [1.0, 0.0],
    [-1.0, 0.0],
    [0.0, -1.0],
    [0.0, 1.0],
];

fn frame([x, y]: Pixel, [width, height]: Pixel) -> Frame {
    [[x - width, y - height], [x + width, y + height]]
}

/// The area that two boxes have in common.
fn overlap(a: &Frame, b: &Frame) -> f64 {
    let side = |k: usize| (a[1][k].min(b[1][k]) - a[0][k].max(b[0][k])).max(0.0);
    side(0) * side(1)
}
