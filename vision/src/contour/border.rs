//! Borders of regions, followed pixel by pixel.

use ga_image::plane::PlaneView;

use super::polygon::{perimeter, signed_area};

/// A border of a region, as a closed chain of pixels each of which is one of the eight neighbours
/// of the one before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contour {
    /// Column and row of each pixel of the region at the border, in their order along it. A pixel
    /// at which the region is one pixel wide occurs more than once.
    pub pixels: Vec<[u32; 2]>,
    /// Whether this is the border between the region and a hole in it, rather than the region's
    /// outer border.
    pub is_hole: bool,
    /// The index of the border that directly surrounds this one: for the outer border of a region,
    /// the hole in which it lies, and for a hole, the outer border of its region. `None` at the
    /// outermost. A parent comes before what it surrounds, and borders of one parent have the order
    /// in which their first pixels are met from the top left, row by row.
    pub parent: Option<usize>,
}

impl Contour {
    /// The centres of the pixels.
    #[must_use]
    pub fn points(&self) -> Vec<[f64; 2]> {
        let points = self.pixels.iter().map(|pixel| pixel.map(f64::from));
        points.collect()
    }

    /// The area that the polygon through the centres of the pixels encloses, in pixels.
    #[must_use]
    pub fn area(&self) -> f64 {
        signed_area(&self.points()).abs()
    }

    /// The length of the polygon through the centres of the pixels.
    #[must_use]
    pub fn perimeter(&self) -> f64 {
        perimeter(&self.points())
    }

    /// The least rectangle of pixels that contains the border: left, top, width and height.
    #[must_use]
    pub fn bounding_box(&self) -> [u32; 4] {
        let range = |axis: usize| {
            let places = self.pixels.iter().map(move |pixel| pixel[axis]);
            let least = places.clone().min().unwrap_or_default();
            (
                least,
                places.max().map_or(0, |greatest| greatest - least + 1),
            )
        };
        let ((left, width), (top, height)) = (range(0), range(1));
        [left, top, width, height]
    }
}

/// The borders of the regions of pixels that are not 0, from the top, after S. Suzuki and K. Abe,
/// "Topological structural analysis of digitized binary images by border following", 1985.
///
/// Pixels of a region are connected to eight neighbours, those of the background to four. Beyond
/// the picture lies background. Outer borders run counterclockwise as seen in the picture, from
/// their leftmost pixel in the top row, and holes clockwise.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::contour::borders;
///
/// // A ring of 12 pixels round a hole of 2 × 2.
/// let ring = Plane::from_fn(6, 6, |column, row| {
///     let is_inside = |low, high| (low..high).contains(&column) && (low..high).contains(&row);
///     u8::from(is_inside(1, 5) && !is_inside(2, 4))
/// });
/// let borders = borders(&ring);
/// assert_eq!(borders.len(), 2);
/// assert_eq!((borders[0].pixels.len(), borders[0].area()), (12, 9.0));
/// assert!(borders[1].is_hole && borders[1].parent == Some(0));
/// ```
#[must_use]
pub fn borders<'a>(picture: impl Into<PlaneView<'a, u8>>) -> Vec<Contour> {
    let mut labels = Labels::new(picture.into());
    let mut contours = Vec::new();
    for row in 0..labels.height {
        let mut last = OUTSIDE;
        let start = (row + 1) * labels.stride + 1;
        for at in start..start + labels.stride - 2 {
            let label = labels.values[at];
            if label == 0 {
                continue;
            }
            let number = contours.len() as i32 + 2;
            let from = if label == 1 && labels.values[at - 1] == 0 {
                Some((at - 1, false))
            } else if label >= 1 && labels.values[at + 1] == 0 {
                if label > 1 {
                    last = label;
                }
                Some((at + 1, true))
            } else {
                None
            };
            if let Some((from, is_hole)) = from {
                contours.push(Contour {
                    parent: parent(&contours, last, is_hole),
                    pixels: labels.follow(at, from, number),
                    is_hole,
                });
            }
            if labels.values[at] != 1 {
                last = labels.values[at].abs();
            }
        }
    }
    contours
}

/// The label of what surrounds everything. Contour *k* has the label *k* + 2.
const OUTSIDE: i32 = 1;

/// The border that surrounds a new one, where `last` is the label of the border met last.
fn parent(contours: &[Contour], last: i32, is_hole: bool) -> Option<usize> {
    let index = usize::try_from(last - 2).ok()?;
    let met = contours.get(index)?;
    // Borders of the same kind that follow each other lie beside each other.
    if met.is_hole == is_hole {
        met.parent
    } else {
        Some(index)
    }
}

/// The picture, with a pixel of background round it: 0 for the background, 1 for a pixel whose
/// border has not been followed, and the label of the border afterwards, negative where the
/// background is on its right.
struct Labels {
    values: Vec<i32>,
    stride: usize,
    height: usize,
}

impl Labels {
    fn new(picture: PlaneView<'_, u8>) -> Self {
        let (stride, height) = (picture.width() + 2, picture.height());
        let mut values = vec![0; stride * (height + 2)];
        for (row, pixels) in picture.rows().enumerate() {
            let labels = &mut values[(row + 1) * stride + 1..];
            for (label, pixel) in labels.iter_mut().zip(pixels) {
                *label = i32::from(*pixel != 0);
            }
        }
        Self {
            values,
            stride,
            height,
        }
    }

    /// The neighbour in a direction: 0 to the right, and on clockwise in steps of 45°.
    fn neighbour(&self, at: usize, direction: usize) -> usize {
        let (right, down) = [
            (2, 1),
            (2, 2),
            (1, 2),
            (0, 2),
            (0, 1),
            (0, 0),
            (1, 0),
            (2, 0),
        ][direction % 8];
        at + right + down * self.stride - self.stride - 1
    }

    fn pixel(&self, at: usize) -> [u32; 2] {
        [at % self.stride - 1, at / self.stride - 1].map(|place| place as u32)
    }

    /// Follows the border from a pixel whose neighbour on the left or right is background.
    fn follow(&mut self, start: usize, background: usize, number: i32) -> Vec<[u32; 2]> {
        let mut pixels = vec![self.pixel(start)];
        let from = if background > start { 0 } else { 4 };
        let is_region =
            |labels: &Self, at, direction| labels.values[labels.neighbour(at, direction)] != 0;
        let Some(first) = (from + 1..from + 8).find(|k| is_region(self, start, *k)) else {
            self.values[start] = -number;
            return pixels;
        };
        let end = self.neighbour(start, first);
        let (mut at, mut towards) = (start, first % 8);
        loop {
            // Counterclockwise from the pixel before this one, which is found again at last.
            let mut right_is_background = false;
            let mut next = towards + 7;
            while next > towards && !is_region(self, at, next) {
                right_is_background |= next % 8 == 0;
                next -= 1;
            }
            if right_is_background {
                self.values[at] = -number;
            } else if self.values[at] == 1 {
                self.values[at] = number;
            }
            let following = self.neighbour(at, next % 8);
            if following == start && at == end {
                return pixels;
            }
            pixels.push(self.pixel(following));
            at = following;
            towards = (next + 4) % 8;
        }
    }
}
