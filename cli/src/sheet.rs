//! The contact sheet of a motion.

use anyhow::{Context, Result};
use ga_anim::skin::Method;
use ga_render::sheet::{Frame, Layout, Options, contact_sheet};
use ga_render::{Light, Lighting, Style, ViewDirection};

use crate::figure::Figure;
use crate::storyboard::Storyboard;

/// The angle at which the camera looks at the figure from its front, in radians; 0 would be
/// straight from the front.
const ASIDE: f64 = 0.9;

/// The angle of the camera above the horizon, in radians.
const ABOVE: f64 = 0.2;

/// A contact sheet as a file.
pub(crate) struct Sheet {
    pub(crate) png: Vec<u8>,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

/// Draws the moments, skinned by motors, and encodes the sheet.
pub(crate) fn draw(figure: &Figure, storyboard: &Storyboard, title: &str) -> Result<Sheet> {
    let moments = &storyboard.moments;
    let positions = moments
        .iter()
        .map(|moment| figure.skinned(&moment.pose, Method::Motor))
        .collect::<Result<Vec<_>, _>>()?;
    let frames: Vec<Frame> = moments
        .iter()
        .zip(&positions)
        .map(|(moment, positions)| Frame {
            number: moment.number,
            time: moment.time,
            kind: moment.kind,
            positions,
            bones: &[],
            lines: &[],
        })
        .collect();
    let options = Options {
        title: title.to_owned(),
        view: ViewDirection {
            azimuth: heading(figure, storyboard)? + ASIDE,
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
    };
    let image = contact_sheet(&frames, &figure.mesh.triangles(), &options)
        .context("cannot draw the contact sheet")?
        .image;
    Ok(Sheet {
        png: ga_image::png::encode(&image).context("cannot encode the contact sheet")?,
        width: image.width(),
        height: image.height(),
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
fn heading(figure: &Figure, storyboard: &Storyboard) -> Result<f64> {
    let (mut x, mut z) = (0.0, 0.0);
    for moment in &storyboard.moments {
        let motions = moment.pose.motions(&figure.skeleton)?;
        let [across, _, along] = motions[0].to_matrix();
        x += across[2];
        z += along[2];
    }
    Ok(x.atan2(z))
}
