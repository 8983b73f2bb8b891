//! The colours of the ground and of the background.

use ga_image::colour::LinearColour;
use ga_runtime::scalar::smooth_step;

use crate::shadow::GroundShadow;
use crate::{Ground, Style, Vector};

/// What determines the colour of the ground at each place.
pub(crate) struct GroundShading<'a> {
    pub(crate) ground: Ground,
    pub(crate) style: &'a Style,
    /// What reaches the ground of the key light, and of the sky.
    pub(crate) key_shadow: Option<GroundShadow>,
    pub(crate) sky_shadow: Option<GroundShadow>,
    /// The place around which the ground is fully visible, and the distance at which it has faded.
    pub(crate) centre: Vector,
    pub(crate) fade: f64,
}

/// Share of the grid's period that a line takes.
const LINE: f64 = 0.03;

impl GroundShading<'_> {
    /// The ground's colour at a point of it, over a given background. `footprint` is the width of a
    /// pixel there.
    pub(crate) fn colour(
        &self,
        point: Vector,
        footprint: f64,
        behind: LinearColour,
    ) -> LinearColour {
        let (x, z) = (point.e1, point.e3);
        let offset = point - self.centre;
        let distance = offset.e1.hypot(offset.e3);
        let presence = 1.0 - smooth_step(0.15 * self.fade, self.fade, distance);
        if presence == 0.0 {
            return behind;
        }
        let line = |c: f64| line_share(c / self.ground.grid, footprint / self.ground.grid);
        let on_line = 1.0 - (1.0 - line(x)) * (1.0 - line(z));
        let base = self.style.ground.lerp(self.style.grid, on_line);

        let reaching =
            |shadow: &Option<GroundShadow>| shadow.as_ref().map_or(1.0, |s| s.visibility(x, z));
        let light = 1.0
            - self.style.shadow * (1.0 - reaching(&self.key_shadow))
            - self.style.occlusion * (1.0 - reaching(&self.sky_shadow));
        behind.lerp(base * light.max(0.0), presence)
    }
}

/// The background's colour at a row given as a fraction of the picture's height: a smooth passage
/// from the top colour to the bottom colour.
pub(crate) fn background(style: &Style, row: f64) -> LinearColour {
    let [top, bottom] = style.background;
    top.lerp(bottom, smooth_step(0.0, 1.0, row))
}

/// How much of a window of the given width around `c` is line, for lines of width [`LINE`] around
/// the integers.
fn line_share(c: f64, width: f64) -> f64 {
    if width >= 4.0 {
        return LINE;
    }
    let width = width.max(1e-6);
    // The integral of the line pattern up to a place.
    let covered = |c: f64| {
        let shifted = c + LINE / 2.0;
        shifted.floor() * LINE + (shifted - shifted.floor()).min(LINE)
    };
    (covered(c + width / 2.0) - covered(c - width / 2.0)) / width
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_sees_the_share_of_line_in_it() {
        assert_eq!(line_share(0.5, 0.1), 0.0);
        assert!((line_share(3.0, LINE / 2.0) - 1.0).abs() < 1e-9);
        assert!((line_share(-2.0, 2.0 * LINE) - 0.5).abs() < 1e-9);
        assert!((line_share(0.3, 1.0) - LINE).abs() < 1e-9);
    }
}
