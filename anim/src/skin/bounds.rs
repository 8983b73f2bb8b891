use ga_runtime::cga3::Point;
use ga_runtime::scalar::Real;
use ga_runtime::vga3::Vector;

/// The corners of the box about points, along the axes: the lowest and the highest coordinates.
/// `None` without points.
///
/// ```
/// use ga_runtime::cga3::Point;
/// let moved = [Point::new(1.0, 5.0, 2.0), Point::new(3.0, 4.0, 2.0)];
/// let [low, high] = ga_anim::skin::bounds(&moved).ok_or("no points")?;
/// assert_eq!((low.coordinates(), high.coordinates()), ([1.0, 4.0, 2.0], [3.0, 5.0, 2.0]));
/// # Ok::<(), &str>(())
/// ```
#[must_use]
pub fn bounds<S: Real<Mask = bool>>(points: &[Point<S>]) -> Option<[Point<S>; 2]> {
    let (first, others) = points.split_first()?;
    let first = Vector::from(*first);
    let corners = others.iter().fold([first; 2], |[low, high], &point| {
        let point = Vector::from(point);
        [low.min(point), high.max(point)]
    });
    Some(corners.map(Point::from))
}
