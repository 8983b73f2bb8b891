//! The places of labels.

use crate::camera::{Camera, Pixel};
use crate::picture::{Label, Picture};

/// The size of the letters in pixels.
pub(crate) const LETTER: f64 = 15.0;

/// A label with its place in the picture.
#[derive(Clone, Debug)]
pub(crate) struct PlacedLabel {
    /// Its index in the picture.
    pub(crate) label: usize,
    /// The middle of its box.
    pub(crate) middle: Pixel,
    /// Half the size of its box.
    half: Pixel,
    anchor: Pixel,
    /// The index of its gap.
    ring: usize,
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

/// Places labels beside their anchors and inside the picture, so that they cover neither each other
/// nor dots, nor lines where possible, nor the boxes that are taken, and so that they stand away
/// from the middle of the picture where possible. Where labels crowd, some stand farther away, at
/// the end of a line.
pub(crate) fn placed(
    picture: &Picture,
    camera: &Camera,
    size: Pixel,
    taken: &[Frame],
) -> Vec<PlacedLabel> {
    let mut taken = taken.to_vec();
    for dot in &picture.dots {
        let [x, y] = camera.project(dot.at);
        let r = dot.radius;
        taken.push([[x - r, y - r], [x + r, y + r]]);
    }
    // The labels of elements are placed before those of axes.
    let strength = [true, false].into_iter();
    let order: Vec<usize> = strength
        .flat_map(|strong| {
            let labels = picture.labels.iter().enumerate();
            labels.filter_map(move |(index, label)| (label.strong == strong).then_some(index))
        })
        .collect();
    let fixed = taken.len();
    let clear = picture.curves.iter().filter(|c| c.opacity > FAINTEST);
    let lines: Vec<Pixel> = clear
        .flat_map(|curve| &curve.points)
        .map(|point| camera.project(*point))
        .collect();
    let mut labels = Vec::new();
    for index in &order {
        let label = place(
            &picture.labels[*index],
            *index,
            camera,
            size,
            &lines,
            &taken,
        );
        taken.push(label.frame());
        labels.push(label);
    }
    // Early labels were placed before the later ones were there.
    for _ in 0..ROUNDS {
        for (k, index) in order.iter().enumerate() {
            let own = taken.remove(fixed + k);
            let label = place(
                &picture.labels[*index],
                *index,
                camera,
                size,
                &lines,
                &taken,
            );
            let is_better = label.cost(&lines, &taken) < labels[k].cost(&lines, &taken);
            let frame = if is_better { label.frame() } else { own };
            taken.insert(fixed + k, frame);
            if is_better {
                labels[k] = label;
            }
        }
    }
    labels
}

/// The best place for one label.
fn place(
    label: &Label,
    index: usize,
    camera: &Camera,
    size: Pixel,
    lines: &[Pixel],
    taken: &[Frame],
) -> PlacedLabel {
    let at = camera.project(label.at);
    let half = [0.5 * text_width(&label.text, LETTER), 0.5 * LETTER];
    let (away_x, away_y) = (at[0] - camera.middle[0], at[1] - camera.middle[1]);
    let preference = |[x, y]: &Pixel| x * away_x + y * away_y;
    let mut sides = SIDES;
    // A stable sort: of equal sides the first one listed stays first.
    sides.sort_by(|a, b| preference(b).total_cmp(&preference(a)));
    let candidates = GAPS.iter().enumerate().flat_map(|(ring, gap)| {
        sides.map(|[x, y]| {
            let inside = |k: usize, place: f64| {
                let margin = half[k] + EDGE;
                place.min(size[k] - margin).max(margin)
            };
            let middle = [
                inside(0, at[0] + x * (half[0] + gap)),
                inside(1, at[1] + y * (half[1] + gap)),
            ];
            PlacedLabel {
                label: index,
                middle,
                half,
                anchor: at,
                ring,
            }
        })
    });
    let first = PlacedLabel {
        label: index,
        middle: at,
        half,
        anchor: at,
        ring: 0,
    };
    let mut best = (f64::INFINITY, first);
    for candidate in candidates {
        let cost = candidate.cost(lines, taken);
        if cost < best.0 {
            best = (cost, candidate);
        }
    }
    best.1
}

impl PlacedLabel {
    fn frame(&self) -> Frame {
        let ([x, y], [width, height]) = (self.middle, self.half);
        [[x - width, y - height], [x + width, y + height]]
    }

    /// The area that the label covers of other boxes, and what points of lines under it and its
    /// distance count for.
    fn cost(&self, lines: &[Pixel], taken: &[Frame]) -> f64 {
        let own = self.frame();
        let is_under =
            |point: &&Pixel| (0..2).all(|k| own[0][k] <= point[k] && point[k] <= own[1][k]);
        let under = lines.iter().filter(is_under).count() as f64;
        let covered: f64 = taken.iter().map(|other| overlap(&own, other)).sum();
        covered + LINE_COST * under + RING_COST * self.ring as f64
    }

    /// The line from the box of a label that stands far from its anchor to the anchor.
    pub(crate) fn leader(&self) -> Option<[Pixel; 2]> {
        let [low, high] = self.frame();
        let near = [0, 1].map(|k| self.anchor[k].min(high[k]).max(low[k]));
        let gap = (near[0] - self.anchor[0]).hypot(near[1] - self.anchor[1]);
        (gap > LEADER).then_some([near, self.anchor])
    }
}

/// The gaps between a label and its anchor that are tried, in pixels.
const GAPS: [f64; 4] = [8.0, 24.0, 44.0, 68.0];
/// What each further gap counts for, as covered pixels.
const RING_COST: f64 = 12.0;
/// What each point of a line under a label counts for, as covered pixels.
const LINE_COST: f64 = 8.0;
/// The opacity of lines from which on labels avoid them.
const FAINTEST: f64 = 0.7;
/// How often all labels are placed anew.
const ROUNDS: usize = 2;
/// The distance of labels from the edge of the picture.
const EDGE: f64 = 3.0;
/// The distance from which on a line joins a label to its anchor.
const LEADER: f64 = 16.0;

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

/// The area that two boxes have in common.
fn overlap(a: &Frame, b: &Frame) -> f64 {
    let side = |k: usize| (a[1][k].min(b[1][k]) - a[0][k].max(b[0][k])).max(0.0);
    side(0) * side(1)
}

#[cfg(test)]
mod tests {
    use ga_runtime::vga3::Vector;
    use proptest::prelude::*;

    use super::*;
    use crate::view::View;

    fn picture(places: &[[f64; 3]]) -> Picture {
        let labels = places.iter().enumerate().map(|(index, place)| Label {
            element: Some(index),
            at: Vector::from(*place),
            text: format!("label {index}"),
            strong: true,
        });
        Picture {
            labels: labels.collect(),
            ..Picture::default()
        }
    }

    fn camera() -> Camera {
        let mut camera = Camera::new(&View::default());
        (camera.scale, camera.middle) = (200.0, [400.0, 300.0]);
        camera
    }

    #[test]
    fn a_dozen_labels_of_one_place_do_not_overlap() {
        let picture = picture(&[[0.1, 0.2, 0.3]; 12]);
        let labels = placed(&picture, &camera(), [800.0, 600.0], &[]);
        assert_eq!(labels.len(), 12);
        for (k, label) in labels.iter().enumerate() {
            for other in &labels[..k] {
                let covered = overlap(&label.frame(), &other.frame());
                assert!(
                    covered < RING_COST,
                    "{label:?} covers {covered} of {other:?}"
                );
            }
        }
        // Some stand so far away that a line joins them to their anchor.
        assert!(labels.iter().any(|label| label.leader().is_some()));
        assert!(labels.iter().any(|label| label.leader().is_none()));
    }

    proptest! {
        #[test]
        fn labels_are_inside_the_picture(
            places in proptest::collection::vec(proptest::array::uniform3(-3.0..3.0), 1..8),
            size in [150.0..900.0, 60.0..700.0],
        ) {
            for label in placed(&picture(&places), &camera(), size, &[]) {
                let [low, high] = label.frame();
                for k in 0..2 {
                    prop_assert!(low[k] >= 0.0 && high[k] <= size[k], "{label:?}");
                }
            }
        }
    }
}
