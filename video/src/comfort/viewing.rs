//! How a stereoscopic picture is seen: the screen, the distance and the eyes.

use crate::comfort::ComfortError;

/// The metres of an inch.
const INCH: f64 = 0.0254;

/// The eyes before a screen.
///
/// The plane through both eyes and the middle of the screen is horizontal; the eyes have the same
/// distance from the screen, and the middle of the screen is straight ahead. A picture covers the
/// whole width of the screen, whatever its aspect.
///
/// A point that the left eye sees at x_L and the right eye at x_R, in shares of the picture's
/// width, has the *parallax* P = x_R − x_L. It is negative, or crossed, for what appears in front
/// of the screen, zero on it, and positive, or uncrossed, behind it.
///
/// ```
/// use ga_video::comfort::Viewing;
///
/// // 55 inches from three picture heights: 1 % of the width is a third of a degree.
/// let viewing = Viewing::default();
/// assert!((viewing.degrees_of_parallax(1.0) * 60.0 - 20.4).abs() < 0.05);
/// // Behind the parallax that is as wide as the eyes are apart, lines of sight diverge.
/// assert!((viewing.parallel_percent() - 5.17).abs() < 0.01);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewing {
    width: f64,
    distance: f64,
    interocular: f64,
}

impl Default for Viewing {
    /// A screen of 55 inches and 16:9, 1218 mm wide, at three picture heights, 2055 mm, with the
    /// eyes 63 mm apart.
    fn default() -> Self {
        let [width, height] = sixteen_to_nine(55.0);
        Self {
            width,
            distance: PICTURE_HEIGHTS * height,
            interocular: INTEROCULAR,
        }
    }
}

/// The distance from the screen, in heights of a screen of 16:9, where none is given.
const PICTURE_HEIGHTS: f64 = 3.0;

/// The distance between the eyes in metres, where none is given: the mean of adults.
const INTEROCULAR: f64 = 0.063;

/// The width and the height, in metres, of a screen of 16:9.
fn sixteen_to_nine(diagonal_inches: f64) -> [f64; 2] {
    [16.0, 9.0].map(|side| diagonal_inches * INCH * side / 16_f64.hypot(9.0))
}

impl Viewing {
    /// A screen of this width at this distance, for eyes that are so far apart, all in metres.
    ///
    /// # Errors
    ///
    /// [`ComfortError`] for a length that is not positive and finite.
    pub fn new(width: f64, distance: f64, interocular: f64) -> Result<Self, ComfortError> {
        let lengths = [
            ("width of the screen", width),
            ("distance of the screen", distance),
            ("distance between the eyes", interocular),
        ];
        for (quantity, metres) in lengths {
            if !(metres > 0.0 && metres.is_finite()) {
                return Err(ComfortError::Viewing { quantity, metres });
            }
        }
        Ok(Self {
            width,
            distance,
            interocular,
        })
    }

    /// A screen of 16:9 with this diagonal, for eyes 63 mm apart; at three heights of the screen
    /// where no distance is given.
    ///
    /// ```
    /// use ga_video::comfort::Viewing;
    ///
    /// assert_eq!(Viewing::of_screen(55.0, None)?, Viewing::default());
    /// assert!(Viewing::of_screen(0.0, Some(2.0)).is_err());
    /// # Ok::<(), ga_video::comfort::ComfortError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ComfortError`] for a length that is not positive and finite.
    pub fn of_screen(
        diagonal_inches: f64,
        distance_metres: Option<f64>,
    ) -> Result<Self, ComfortError> {
        let [width, height] = sixteen_to_nine(diagonal_inches);
        let distance = distance_metres.unwrap_or(PICTURE_HEIGHTS * height);
        Self::new(width, distance, INTEROCULAR)
    }

    /// The width of the screen in metres.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.width
    }

    /// The distance of the screen in metres.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// The distance between the eyes in metres.
    #[must_use]
    pub fn interocular(&self) -> f64 {
        self.interocular
    }

    /// By how much the eyes converge less on a point of this parallax than on the screen, in
    /// degrees; negative in front of the screen. The parallax is in per cent of the picture's
    /// width.
    ///
    /// Eyes at a distance e from each other converge by 2 atan(e / 2D) on the middle of a screen at
    /// the distance D, and by 2 atan((e − P) / 2D) on a point straight ahead whose images on the
    /// screen have the parallax P. This is the difference, without approximation. At P = e the
    /// lines of sight are parallel; beyond it they diverge.
    #[must_use]
    pub fn degrees_of_parallax(&self, percent: f64) -> f64 {
        let parallax = 0.01 * percent * self.width;
        (self.convergence(0.0) - self.convergence(parallax)).to_degrees()
    }

    /// The parallax in per cent of the picture's width at which the eyes converge by this many
    /// degrees less than on the screen: the inverse of
    /// [`degrees_of_parallax`](Self::degrees_of_parallax).
    ///
    /// ```
    /// use ga_video::comfort::Viewing;
    ///
    /// let viewing = Viewing::default();
    /// let percent = viewing.parallax_of_degrees(-1.0);
    /// assert!((viewing.degrees_of_parallax(percent) + 1.0).abs() < 1e-12);
    /// // The 1/30 rule: a degree is about 3 % of the width.
    /// assert!((percent + 2.94).abs() < 0.02);
    /// ```
    #[must_use]
    pub fn parallax_of_degrees(&self, degrees: f64) -> f64 {
        let half = 0.5 * (self.convergence(0.0) - degrees.to_radians());
        100.0 * (self.interocular - 2.0 * self.distance * half.tan()) / self.width
    }

    /// The parallax, in per cent of the picture's width, at which lines of sight are parallel: the
    /// distance between the eyes. No point of a real scene has a greater one.
    #[must_use]
    pub fn parallel_percent(&self) -> f64 {
        100.0 * self.interocular / self.width
    }

    /// The visual angle, in degrees, of a length on the screen in per cent of the picture's width,
    /// centred straight ahead: 2 atan(h / 2D).
    #[must_use]
    pub fn degrees_of_length(&self, percent: f64) -> f64 {
        let length = 0.01 * percent * self.width;
        2.0 * (0.5 * length / self.distance).atan().to_degrees()
    }

    /// The angle between the lines of sight to a point straight ahead of this parallax, in radians.
    fn convergence(&self, parallax: f64) -> f64 {
        2.0 * (0.5 * (self.interocular - parallax) / self.distance).atan()
    }
}
