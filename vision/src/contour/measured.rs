//! A closed curve of a picture in numbers.

use ga_runtime::cga2::{self, Point};
use serde::Serialize;

use super::fit::{Ellipse, ellipse};
use super::picture_border::{REACH_OF_SNAKES, is_at_border};
use super::polygon::{perimeter, signed_area};

/// What is known of a closed curve. Serialised, lengths have `px` and areas `px2` in their names.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeasuredContour {
    /// Whether it is the border of a hole.
    #[serde(rename = "hole")]
    pub is_hole: bool,
    /// The index of the curve that directly surrounds it.
    pub parent: Option<usize>,
    /// The area that the polygon through the points encloses, in pixels.
    #[serde(rename = "area_px2")]
    pub area: f64,
    /// The length of that polygon.
    #[serde(rename = "perimeter_px")]
    pub perimeter: f64,
    /// How many points are at the border of the picture, which cuts off what it shows. They are
    /// part of the polygon, and not of what circle and ellipse are fitted to.
    #[serde(rename = "points_at_border")]
    pub at_border: usize,
    /// The circle nearest to the points, where they determine one.
    pub circle: Option<NearestCircle>,
    /// The ellipse nearest to the points, where they determine one.
    pub ellipse: Option<Ellipse>,
    /// The points.
    #[serde(rename = "points_px")]
    pub points: Vec<[f64; 2]>,
}

/// A circle in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct NearestCircle {
    /// The centre.
    #[serde(rename = "centre_px")]
    pub centre: [f64; 2],
    /// The radius.
    #[serde(rename = "radius_px")]
    pub radius: f64,
}

impl MeasuredContour {
    /// Measures the border of a region in a picture with these columns and rows.
    ///
    /// ```
    /// use ga_vision::contour::MeasuredContour;
    ///
    /// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    /// let square = square.map(|corner| corner.map(|x| x + 3.0));
    /// let measured = MeasuredContour::new(square.to_vec(), false, None, [12, 12]);
    /// assert_eq!((measured.area, measured.perimeter), (16.0, 16.0));
    /// let circle = measured.circle.unwrap();
    /// assert!((circle.radius - 8f64.sqrt()).abs() < 1e-12);
    /// // Four points are on many ellipses.
    /// assert_eq!(measured.ellipse, None);
    /// ```
    #[must_use]
    pub fn new(
        points: Vec<[f64; 2]>,
        is_hole: bool,
        parent: Option<usize>,
        size: [usize; 2],
    ) -> Self {
        let is_inside = |point: &[f64; 2]| !is_at_border(*point, size, 0.0);
        Self::measured(points, is_hole, parent, is_inside)
    }

    /// Measures a snake in a picture with these columns and rows.
    #[must_use]
    pub fn of_snake(points: Vec<[f64; 2]>, size: [usize; 2]) -> Self {
        let is_inside = |point: &[f64; 2]| !is_at_border(*point, size, REACH_OF_SNAKES);
        Self::measured(points, false, None, is_inside)
    }

    fn measured(
        points: Vec<[f64; 2]>,
        is_hole: bool,
        parent: Option<usize>,
        is_inside: impl Fn(&[f64; 2]) -> bool,
    ) -> Self {
        let mut inside = points.clone();
        inside.retain(is_inside);
        let places: Vec<_> = inside.iter().copied().map(Point::from).collect();
        let circle = cga2::Circle::fit(&places).ok().map(|fit| {
            let [u, v, _] = fit.origin().coordinates();
            NearestCircle {
                centre: [u, v],
                radius: fit.radius(),
            }
        });
        Self {
            is_hole,
            parent,
            area: signed_area(&points).abs(),
            perimeter: perimeter(&points),
            at_border: points.len() - inside.len(),
            circle,
            ellipse: ellipse(&inside).ok(),
            points,
        }
    }
}
