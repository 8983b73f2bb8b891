//! How a figure is seen: its side, and the light on it.

use ga_anim::skeleton::{Skeleton, SkeletonError};
use ga_render::sheet::{Layout, Options};
use ga_render::{Light, Lighting, Style, ViewDirection};

use crate::figure::Figure;
use crate::storyboard::Storyboard;

/// The angle at which the camera looks at the figure from its front, in radians; 0 would be
/// straight from the front.
const ASIDE: f64 = 0.9;

/// The angle of the camera above the horizon, in radians.
const ABOVE: f64 = 0.2;

/// How the moments are seen.
pub(crate) fn options(figure: &Figure, storyboard: &Storyboard) -> Result<Options, SkeletonError> {
    Ok(Options {
        view: ViewDirection {
            azimuth: heading(&figure.character.skeleton, storyboard)? + ASIDE,
            elevation: ABOVE,
        },
        layout: Layout::Columns(storyboard.columns),
        ground: Some(0.0),
        style: Style {
            width: 240,
            height: 320,
            supersampling: 3,
            lighting: lighting(),
            ..Style::default()
        },
        ..Options::default()
    })
}

/// The usual light with the main one higher, so that the shadow is short and the figure large.
fn lighting() -> Lighting {
    let usual = Style::default().lighting;
    Lighting {
        key: Light {
            direction: [-0.40, 1.0, 0.45],
            ..usual.key
        },
        ..usual
    }
}

/// The mean direction in which the figure looks, as an azimuth about the y axis from +z towards +x.
/// At rest it looks along +z; the motion of its root joint rotates that direction.
fn heading(skeleton: &Skeleton, storyboard: &Storyboard) -> Result<f64, SkeletonError> {
    let (mut x, mut z) = (0.0, 0.0);
    for moment in &storyboard.moments {
        let motions = moment.pose.motions(skeleton)?;
        let [across, _, along] = motions[0].to_matrix();
        x += across[2];
        z += along[2];
    }
    Ok(x.atan2(z))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use ga_anim::skin::Method;
    use ga_image::plane::Plane;
    use ga_mannequin::{Human, KEYS_PER_STRIDE, walk};
    use ga_render::sheet::{Caption, Frame, contact_sheet};

    use super::*;

    /// The pictures of the demo's moments, small and without the soft shadow under the feet.
    fn pictures(figure: &Figure, storyboard: &Storyboard, shadow: f64) -> Vec<Plane<[u8; 3]>> {
        let usual = options(figure, storyboard).unwrap();
        let options = Options {
            style: Style {
                width: 120,
                height: 160,
                supersampling: 1,
                shadow,
                occlusion: 0.0,
                ..usual.style
            },
            depth: false,
            ..usual
        };
        let moments = storyboard.moments.iter();
        let positions: Vec<_> = moments
            .map(|moment| {
                figure
                    .character
                    .skinned(&moment.pose, Method::Motor)
                    .unwrap()
            })
            .collect();
        let frames = positions.iter().map(|positions| Frame {
            caption: Caption::new(0),
            positions,
            bones: &[],
        });
        let frames: Vec<Frame> = frames.collect();
        let sheet = contact_sheet(&frames, &figure.character.mesh.triangles(), &options).unwrap();
        let pictures = sheet.pictures.into_iter();
        pictures.map(|picture| picture.colour).collect()
    }

    #[test]
    fn the_light_stands_higher_than_usual() {
        let figure = Figure::new("", Human::new().into());
        let storyboard = Storyboard::of_keys(&walk(2), KEYS_PER_STRIDE);
        let height = |lighting: Lighting| {
            let [x, y, z] = lighting.key.direction;
            y.atan2(x.hypot(z))
        };
        let found = height(options(&figure, &storyboard).unwrap().style.lighting);
        let usual = height(Style::default().lighting);
        // The shadow is shorter by a third.
        assert!(found.tan() > 1.5 * usual.tan(), "{found} {usual}");
    }

    #[test]
    fn the_shadow_of_the_demo_stays_inside_the_pictures() {
        let figure = Figure::new("", Human::new().into());
        let keys = walk(2);
        let storyboard = Storyboard::of_keys(&keys, KEYS_PER_STRIDE);
        let with = pictures(&figure, &storyboard, 0.42);
        let without = pictures(&figure, &storyboard, 1e-9);
        for (moment, (with, without)) in with.iter().zip(&without).enumerate() {
            let mut shadowed = 0;
            let pixels = with.values().iter().zip(without.values()).enumerate();
            for (index, (with_shadow, without)) in pixels {
                if with_shadow == without {
                    continue;
                }
                let (x, y) = (index % with.width(), index / with.width());
                shadowed += 1;
                let inside = (1..119).contains(&x) && (1..159).contains(&y);
                assert!(inside, "moment {moment}: shadow at ({x}, {y})");
            }
            assert!(
                shadowed > 100,
                "moment {moment}: {shadowed} pixels of shadow"
            );
        }
    }
}
