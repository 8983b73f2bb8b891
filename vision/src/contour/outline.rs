//! The border of the largest thing in a picture.

use ga_image::plane::Plane;
use ga_image::threshold::{above, otsu};

use super::border::{Contour, borders};
use super::picture_border::is_at_border;
use crate::contour::ContourError;

/// The border that encloses the largest area: the outer border of a bright region or of a hole in
/// one, with the threshold of Otsu. A bright region that touches all four sides of the picture is a
/// background, and only its holes count.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::contour::outline;
///
/// // A dark square of 6 × 6 pixels on a bright ground: the pixels around it.
/// let picture = Plane::from_fn(20, 16, |column, row| {
///     if (5..11).contains(&column) && (4..10).contains(&row) { 20u8 } else { 220 }
/// });
/// let outline = outline(&picture, 4.0)?;
/// assert!(outline.is_hole);
/// assert_eq!(outline.bounding_box(), [4, 3, 8, 8]);
/// # Ok::<(), ga_vision::contour::ContourError>(())
/// ```
///
/// # Errors
///
/// [`ContourError`] where all pixels have one level, where no border encloses `least_area`, and
/// where the largest one touches the border of the picture.
pub fn outline(picture: &Plane<u8>, least_area: f64) -> Result<Contour, ContourError> {
    let level = otsu(picture).ok_or(ContourError::OneLevel)?;
    let size = [picture.width(), picture.height()];
    let is_background = |contour: &Contour| {
        let [_, _, width, height] = contour.bounding_box();
        !contour.is_hole && [width as usize, height as usize] == size
    };
    let largest = borders(&above(picture, level))
        .into_iter()
        .filter(|contour| !is_background(contour) && contour.area() >= least_area)
        .max_by(|a, b| a.area().total_cmp(&b.area()))
        .ok_or(ContourError::NoBorder { least_area })?;
    let touches = |pixel: &&[u32; 2]| is_at_border(pixel.map(f64::from), size, 0.0);
    let touching = largest.pixels.iter().find(touches).copied();
    match touching {
        None => Ok(largest),
        Some(pixel) => Err(ContourError::LeavesPicture { pixel, size }),
    }
}
