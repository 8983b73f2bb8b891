//! The pictures of a motion: the contact sheet and the sequence.

use anyhow::{Context, Result, ensure};
use ga_anim::clip::Clip;
use ga_anim::skin::Method;
use ga_image::picture::PictureView;
use ga_image::plane::Plane;
use ga_image::png::{self, Animation};
use ga_render::sheet::{Frame, Layout, Options, Sequence, Shooting, Subject, contact_sheet_of};
use ga_render::texture::{Mipmap, Sampler, Wrap};
use ga_render::{
    Appearance, Attribute, Light, Lighting, MaterialChoice, Object, Polyline, Style, ViewDirection,
};

use crate::figure::Figure;
use crate::model::ROUGHNESS;
use crate::overlay::Overlay;
use crate::storyboard::Storyboard;

/// The angle at which the camera looks at the figure from its front, in radians; 0 would be
/// straight from the front.
const ASIDE: f64 = 0.9;

/// The angle of the camera above the horizon, in radians.
const ABOVE: f64 = 0.2;

/// Columns and rows of a picture of the sequence.
const FILM_SIZE: [u32; 2] = [360, 480];

/// The most pictures of a sequence.
pub(crate) const MOST_PICTURES: usize = 1000;

/// A contact sheet as a file.
pub(crate) struct Sheet {
    pub(crate) png: Vec<u8>,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

/// Draws the moments, skinned by motors, and encodes the sheet.
pub(crate) fn draw(
    figure: &Figure,
    storyboard: &Storyboard,
    title: &str,
    overlay: &Overlay,
) -> Result<Sheet> {
    let options = Options {
        title: title.to_owned(),
        ..options(figure, storyboard)?
    };
    let moments = &storyboard.moments;
    let positions = moments
        .iter()
        .map(|moment| figure.skinned(&moment.pose, Method::Motor))
        .collect::<Result<Vec<_>, _>>()?;
    let marks = moments
        .iter()
        .map(|moment| overlay.marks(moment.time, &moment.pose))
        .collect::<Result<Vec<_>>>()?;
    let height = options.style.height;
    let lines: Vec<Vec<Polyline>> = marks.iter().map(|marks| marks.lines(height)).collect();
    let frames: Vec<Frame> = (0..moments.len())
        .map(|index| Frame {
            number: moments[index].number,
            time: moments[index].time,
            kind: moments[index].kind,
            positions: &positions[index],
            bones: &marks[index].bones,
            lines: &lines[index],
        })
        .collect();
    let image = with_subject(figure, |subject| {
        contact_sheet_of(&frames, &subject, &options).context("cannot draw the contact sheet")
    })?
    .image;
    Ok(Sheet {
        png: png::encode(&image).context("cannot encode the contact sheet")?,
        width: image.width() as u32,
        height: image.height() as u32,
    })
}

/// The frames of the clip as an animated PNG, seen from where the sheet sees the moments.
pub(crate) fn film(
    figure: &Figure,
    storyboard: &Storyboard,
    clip: &Clip,
    overlay: &Overlay,
) -> Result<Vec<u8>> {
    let count = clip.frames().len();
    ensure!(
        count <= MOST_PICTURES,
        "--film: the motion has {count} frames, more than {MOST_PICTURES}; choose fewer of them or \
         a lower rate"
    );
    let usual = options(figure, storyboard)?;
    let options = Options {
        style: Style {
            width: FILM_SIZE[0],
            height: FILM_SIZE[1],
            supersampling: 2,
            ..usual.style
        },
        ..usual
    };
    let mut sequence = Sequence::new(options);
    for (number, pose) in clip.frames().iter().enumerate() {
        let positions = figure.skinned(pose, Method::Motor)?;
        sequence.add(&Frame::new(number, &positions))?;
    }
    with_subject(figure, |subject| {
        let shooting = sequence.shoot(subject).context("cannot draw the film")?;
        let mut failure = None;
        let pictures = (0..count).map(|number| {
            // An encoder asks for pictures, not for errors: those after an error have no pixels.
            let picture = match failure {
                None => picture(figure, clip, overlay, &shooting, number)
                    .map_err(|error| failure = Some(error))
                    .ok(),
                Some(_) => None,
            };
            picture.unwrap_or_default()
        });
        let animation = Animation {
            frames_per_second: rate(clip.frame_time()),
            plays: 0,
        };
        let bytes = png::encode_animation(pictures, animation);
        match failure {
            Some(error) => Err(error),
            None => bytes.context("cannot encode the film"),
        }
    })
}

fn picture(
    figure: &Figure,
    clip: &Clip,
    overlay: &Overlay,
    shooting: &Shooting,
    number: usize,
) -> Result<Plane<[u8; 3]>> {
    let pose = &clip.frames()[number];
    let positions = figure.skinned(pose, Method::Motor)?;
    let marks = overlay.marks(number as f64 * clip.frame_time(), pose)?;
    let frame = Frame {
        bones: &marks.bones,
        lines: &marks.lines(FILM_SIZE[1]),
        ..Frame::new(number, &positions)
    };
    let picture = shooting.picture(number, &frame)?;
    Ok(PictureView::from(&picture.colour).to_rgb())
}

/// Frames in a second as a quotient of numbers of 16 bits.
fn rate(frame_time: f64) -> [u16; 2] {
    let denominator = (f64::from(u16::MAX) * frame_time)
        .clamp(1.0, 1000.0)
        .floor();
    // A cast from float saturates.
    [
        (denominator / frame_time).round().max(1.0) as u16,
        denominator as u16,
    ]
}

/// Calls `draw` with the figure in its painted skin, or in the colour of the style.
fn with_subject<T>(figure: &Figure, draw: impl FnOnce(Subject) -> Result<T>) -> Result<T> {
    let triangles = figure.mesh.triangles();
    let painted = figure.paint.as_ref().zip(figure.mesh.texture_coordinates());
    let Some((paint, coordinates)) = painted else {
        return draw(Subject::new(&triangles));
    };
    let sampler = Sampler {
        wrap: [Wrap::ClampToEdge; 2],
        ..Sampler::default()
    };
    let map = Mipmap::colour(paint, sampler).context("the painted skin has no pixels")?;
    let materials = [Appearance {
        base_colour_map: Some(&map),
        roughness: ROUGHNESS,
        ..Appearance::default()
    }];
    let corners: Vec<Option<[u32; 3]>> = figure
        .mesh
        .faces()
        .corner_triangles()
        .into_iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|corner| coordinates.corners[corner as usize]);
            Some([a?, b?, c?])
        })
        .collect();
    draw(Subject {
        object: Object {
            texture_coordinates: Some(Attribute::of_corners(&coordinates.values, &corners)),
            material: MaterialChoice::One(0),
            ..Object::new(&[], &triangles)
        },
        materials: &materials,
    })
}

/// How the moments are seen.
fn options(figure: &Figure, storyboard: &Storyboard) -> Result<Options> {
    Ok(Options {
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

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use ga_mannequin::{Human, KEYS_PER_STRIDE, walk};

    use super::*;
    use crate::storyboard::{Numbering, spans_of_keys};

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
            .map(|moment| figure.skinned(&moment.pose, Method::Motor).unwrap())
            .collect();
        let frames: Vec<Frame> = positions.iter().map(|p| Frame::new(0, p)).collect();
        let triangles = figure.mesh.triangles();
        let sheet = contact_sheet_of(&frames, &Subject::new(&triangles), &options).unwrap();
        let pictures = sheet.pictures.into_iter();
        pictures.map(|picture| picture.colour).collect()
    }

    #[test]
    fn the_shadow_of_the_demo_stays_inside_the_pictures() {
        let human = Human::new();
        let figure = Figure {
            name: String::new(),
            mesh: human.mesh,
            skeleton: human.skeleton,
            weights: human.weights,
            paint: None,
        };
        let keys = walk(2);
        let numbering = Numbering {
            first: 0,
            per_frame: 4,
        };
        let storyboard = Storyboard::new(&keys, &spans_of_keys(&keys, KEYS_PER_STRIDE), numbering);
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

    #[test]
    fn rates_are_quotients() {
        for (rate_, quotient) in [
            (25.0, [25_000, 1000]),
            (1000.0, [65_000, 65]),
            (0.5, [500, 1000]),
        ] {
            assert_eq!(rate(1.0 / rate_), quotient);
        }
        assert_eq!(rate(1e9), [1, 1000]);
        assert_eq!(rate(1e-9), [u16::MAX, 1]);
    }
}
