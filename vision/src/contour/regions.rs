//! The borders of the bright regions of a picture.

use ga_image::plane::Plane;
use ga_image::threshold::{above, otsu};

use super::border::{Contour, borders};
use crate::contour::ContourError;

/// The borders of the regions above a threshold, of which small ones are left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Regions {
    /// The level above which pixels belong to regions.
    pub threshold: u8,
    /// The borders. A parent is an index into this list.
    pub contours: Vec<Contour>,
}

impl Regions {
    /// The borders that enclose `least_area` pixels or more, of the regions above a threshold, or
    /// above Otsu's. Where a parent is left out, its own parent takes its place.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    /// use ga_vision::contour::Regions;
    ///
    /// // A bright square of 12 × 12 pixels with a hole of one pixel.
    /// let picture = Plane::from_fn(20, 20, |column, row| {
    ///     let is_inside = (4..16).contains(&column) && (4..16).contains(&row);
    ///     if is_inside && (column, row) != (9, 9) { 200u8 } else { 10 }
    /// });
    /// assert_eq!(Regions::find(&picture, None, 0.0)?.contours.len(), 2);
    /// assert_eq!(Regions::find(&picture, Some(100), 50.0)?.contours.len(), 1);
    /// # Ok::<(), ga_vision::contour::ContourError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ContourError::OneLevel`] where no threshold is given and all pixels have one level, and
    /// [`ContourError::NoBorder`] where no border is left.
    pub fn find(
        picture: &Plane<u8>,
        threshold: Option<u8>,
        least_area: f64,
    ) -> Result<Self, ContourError> {
        let threshold = threshold
            .or_else(|| otsu(picture))
            .ok_or(ContourError::OneLevel)?;
        let all = borders(&above(picture, threshold));
        let is_kept: Vec<bool> = all.iter().map(|c| c.area() >= least_area).collect();
        let parent = |contour: &Contour| {
            let mut parent = contour.parent;
            while let Some(index) = parent.filter(|index| !is_kept[*index]) {
                parent = all[index].parent;
            }
            parent.map(|index| is_kept[..index].iter().filter(|kept| **kept).count())
        };
        let kept = all.iter().zip(&is_kept).filter(|(_, kept)| **kept);
        let contours: Vec<Contour> = kept
            .map(|(contour, _)| Contour {
                parent: parent(contour),
                ..contour.clone()
            })
            .collect();
        if contours.is_empty() {
            return Err(ContourError::NoBorder { least_area });
        }
        Ok(Self {
            threshold,
            contours,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parents_are_counted_among_the_borders_that_are_kept() {
        // Squares about the centre, bright, dark and bright, and first a small one in a corner.
        let picture = Plane::from_fn(41, 41, |column, row| {
            let distance = (column as i32 - 20).abs().max((row as i32 - 20).abs());
            let is_small = (1..3).contains(&column) && (1..3).contains(&row);
            match distance {
                0..=2 | 6..=12 => 200u8,
                _ if is_small => 200,
                _ => 10,
            }
        });
        let parents = |least_area: f64| -> Vec<Option<usize>> {
            let found = Regions::find(&picture, None, least_area).unwrap();
            found
                .contours
                .iter()
                .map(|contour| contour.parent)
                .collect()
        };
        assert_eq!(parents(0.0), [None, None, Some(1), Some(2)]);
        // Through the centres of pixels the large border is 24 × 24 pixels, its hole 12 × 12, the
        // square in it 4 × 4.
        assert_eq!(parents(10.0), [None, Some(0), Some(1)]);
        assert_eq!(parents(100.0), [None, Some(0)]);
        let error = Regions::find(&picture, None, 1000.0).unwrap_err();
        assert_eq!(error, ContourError::NoBorder { least_area: 1000.0 });
    }
}
