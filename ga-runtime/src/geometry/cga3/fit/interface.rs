//! The functions that fit each primitive.

use super::cloud::Weighted;
use super::result::{Located, PrimitiveFit, fitted};
use super::search::{cloud_of, least};
use super::shape::Shape;
use crate::cga3::Point;
use crate::geometry::FitError;
use crate::scalar::Real;
use crate::vga3::Vector;

/// Defines the name of a result and the fits of a primitive, given what makes vectors of its points
/// and the documentation of the first fit.
macro_rules! fits {
    ($Type:ident, $unknowns:literal, $Fit:ident, $place:expr; $(#[$documentation:meta])*) => {
        #[doc = concat!("A [`", stringify!($Type), "`] that was fitted to points.")]
        pub type $Fit<S> = $crate::geometry::fit::PrimitiveFit<$Type<S>, S, $unknowns>;

        impl<S: Real<Mask = bool>> $Type<S> {
            $(#[$documentation])*
            pub fn fit(points: &[Point<S>]) -> Result<$Fit<S>, FitError<S>> {
                let places = points.iter().map(|&point| (S::one(), $place(point)));
                super::interface::fit(places)
            }

            /// The same with weights: `Σ wᵢ dᵢ²` is least. A weight w says that the coordinates of
            /// the point have the variance `σ²/w`. Points of weight zero are ignored.
            ///
            /// # Errors
            /// Those of [`fit`](Self::fit), and weights that are negative or not finite, or all
            /// zero.
            pub fn fit_weighted(
                points: &[(S, Point<S>)],
            ) -> Result<$Fit<S>, FitError<S>> {
                let places = points.iter().map(|&(weight, point)| (weight, $place(point)));
                super::interface::fit(places)
            }

            /// The same in the presence of gross errors: random samples find the points that agree
            /// within a threshold, and an M-estimate of these follows. See
            /// [`RobustSettings`](crate::geometry::fit::RobustSettings).
            ///
            /// # Errors
            /// Those of [`fit`](Self::fit) for the points that agree; settings outside of their
            /// range; [`FitError::NoConsensus`] where too few points agree.
            pub fn fit_robustly(
                points: &[Point<S>],
                settings: &$crate::geometry::fit::RobustSettings<S>,
            ) -> Result<$crate::geometry::fit::RobustFit<Self, S, $unknowns>, FitError<S>>
            {
                let places = points.iter().map(|&point| $place(point)).collect();
                super::robust::fit(places, settings)
            }
        }

        impl<S: Real<Mask = bool>> $Fit<S> {
            /// The distance of a point from the primitive: signed for a surface, positive outside
            /// or on the side of the normal.
            #[must_use]
            pub fn residual(&self, point: Point<S>) -> S {
                self.located.residual::<$Type<S>, $unknowns>($place(point))
            }
        }
    };
}
pub(super) use fits;

/// The primitive with the least sum of squared distances.
pub(super) fn fit<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: impl ExactSizeIterator<Item = Weighted<S>>,
) -> Result<PrimitiveFit<P, S, N>, FitError<S>> {
    let cloud = cloud_of::<P, S, N>(points)?;
    let starts = P::starts(&cloud)?;
    let place = least::<P, S, N>(&cloud, &starts, None)?;
    fitted(&cloud, place, None)
}

/// The primitive of the algebraic fit.
pub(super) fn start<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: &[Point<S>],
) -> Result<P, FitError<S>> {
    let places = points.iter().map(|&point| (S::one(), Vector::from(point)));
    let cloud = cloud_of::<P, S, N>(places)?;
    let starts = P::starts(&cloud)?;
    let place = starts.first().ok_or(FitError::NotUnique)?;
    Located::new(&cloud, *place).element::<P, N>()
}
