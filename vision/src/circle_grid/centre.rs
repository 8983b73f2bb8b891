//! The images of the centres of discs, which are not the centres of their images.

use ga_numerics::order_statistics::median;
use ga_runtime::vga2::Vector;

use super::disc::Disc;
use crate::homography::Homography;

/// The images of the centres of the discs of a board, in its order. `places` are those of the
/// centres on the board. `None` where neighbours lie on one line.
pub(super) fn centres(
    discs: &[Disc],
    order: &[usize],
    places: &[[f64; 2]],
) -> Option<Vec<[f64; 2]>> {
    /// How far the neighbours are from whose places the homography of a disc is taken.
    const REACH: f64 = 2.9;
    let homography = |index: usize| {
        let distance = |k: usize| {
            let [x, y] = [0, 1].map(|axis| places[k][axis] - places[index][axis]);
            x.hypot(y)
        };
        let near: Vec<usize> = (0..places.len()).filter(|&k| distance(k) < REACH).collect();
        let from: Vec<[f64; 2]> = near.iter().map(|&k| places[k]).collect();
        let to: Vec<[f64; 2]> = near
            .iter()
            .map(|&k| discs[order[k]].centre.coordinates())
            .collect();
        Homography::from_pairs(&from, &to)
    };
    let homographies = (0..places.len()).map(homography);
    let homographies = homographies.collect::<Option<Vec<Homography>>>()?;
    let radii = homographies.iter().zip(order).zip(places);
    let radii = radii.map(|((homography, &disc), place)| {
        let area = area_of_unit(homography, *place)?;
        Some((discs[disc].area / (std::f64::consts::PI * area)).sqrt())
    });
    let mut radii = radii.collect::<Option<Vec<f64>>>()?;
    let radius = median(&mut radii)?;
    let centres = homographies.iter().zip(order).zip(places);
    let centres = centres.map(|((homography, &disc), place)| {
        let bias = centre_of_image(homography, *place, radius)? - image(homography, *place)?;
        Some((discs[disc].centre - bias).coordinates())
    });
    centres.collect()
}

fn image(homography: &Homography, place: [f64; 2]) -> Option<Vector<f64>> {
    homography.apply(place).map(|[u, v]| Vector::new(u, v))
}

/// The area of the image of a unit square about a place, to first order.
fn area_of_unit(homography: &Homography, [x, y]: [f64; 2]) -> Option<f64> {
    const STEP: f64 = 1e-3;
    let at = |dx: f64, dy: f64| image(homography, [x + dx * STEP, y + dy * STEP]);
    let along = at(1.0, 0.0)? - at(-1.0, 0.0)?;
    let down = at(0.0, 1.0)? - at(0.0, -1.0)?;
    Some((along ^ down).e12.abs() / (4.0 * STEP * STEP))
}

/// The centre of the ellipse that is the image of a circle. The dual conic of a circle with radius
/// r about c is `r² (e₁ e₁ᵀ + e₂ e₂ᵀ) − c cᵀ`, that of its image `H … Hᵀ`, and the centre of a
/// conic is the last column of its dual.
fn centre_of_image(homography: &Homography, [x, y]: [f64; 2], radius: f64) -> Option<Vector<f64>> {
    let [first, second, origin] = [0, 1, 2].map(|column| homography.column(column));
    let centre = first * x + second * y + origin;
    let squared = radius * radius;
    let column = first * (squared * first.e3) + second * (squared * second.e3) - centre * centre.e3;
    let place = Vector::new(column.e1 / column.e3, column.e2 / column.e3);
    (place.e1.is_finite() && place.e2.is_finite()).then_some(place)
}
