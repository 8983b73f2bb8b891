//! The pictures of a motion: the contact sheet and the film.

use ga_anim::character::Character;
use ga_anim::pose::Pose;
use ga_anim::skin::Method;
use ga_image::frames;
use ga_image::picture::PictureView;
use ga_image::plane::Plane;
use ga_image::png;
use ga_render::Style;
use ga_render::sheet::{Frame, Options, Sequence, SheetError, Shooting, contact_sheet_of};

use crate::error::CharacterError;
use crate::figure::Figure;
use crate::model::File;
use crate::overlay::{Marks, Overlay};
use crate::report::Animation;
use crate::staging::{options, with_subject};
use crate::storyboard::Moment;

/// The name of the contact sheet.
pub const SHEET: &str = "sheet.png";

/// Columns and rows of a picture of the film.
const FILM_SIZE: [u32; 2] = [360, 480];

/// A character in a pose, and what is drawn over it.
struct Posed {
    positions: Vec<[f64; 3]>,
    marks: Marks,
}

impl Posed {
    fn new(
        character: &Character,
        overlay: &Overlay,
        time: f64,
        pose: &Pose,
    ) -> Result<Self, CharacterError> {
        Ok(Self {
            positions: character.skinned(pose, Method::Motor)?,
            marks: overlay.marks(time, pose)?,
        })
    }
}

/// The contact sheet of the moments of an animation, skinned by motors, as PNG.
///
/// # Errors
///
/// [`CharacterError::Draw`] and [`CharacterError::Encode`] where the sheet would be too large, and
/// [`CharacterError::Skin`] and [`CharacterError::Skeleton`] for the animation of another figure.
pub fn sheet(
    figure: &Figure,
    animation: &Animation,
    overlay: &Overlay,
) -> Result<File, CharacterError> {
    let Animation {
        storyboard, title, ..
    } = animation;
    let options = Options {
        title: title.clone(),
        ..options(figure, storyboard)?
    };
    let moments = &storyboard.moments;
    let posed = |moment: &Moment| Posed::new(&figure.character, overlay, moment.time, &moment.pose);
    let posed = moments.iter().map(posed).collect::<Result<Vec<_>, _>>()?;
    let lines = posed.iter().map(|p| p.marks.lines(options.style.height));
    let lines: Vec<_> = lines.collect();
    let frames: Vec<Frame> = (0..moments.len())
        .map(|index| Frame {
            number: moments[index].number,
            time: moments[index].time,
            kind: moments[index].kind,
            positions: &posed[index].positions,
            bones: &posed[index].marks.bones,
            lines: &lines[index],
        })
        .collect();
    let what = "contact sheet";
    let drawn = with_subject(figure, |subject| {
        contact_sheet_of(&frames, &subject, &options)
    })?;
    let image = drawn
        .map_err(|source| CharacterError::Draw { what, source })?
        .image;
    let contents = png::encode(&image);
    Ok(File {
        name: SHEET,
        contents: contents.map_err(|source| CharacterError::Encode { what, source })?,
        vertices: None,
        pixels: Some([image.width(), image.height()]),
    })
}

/// The frames of an animation as an animated PNG, seen from where the contact sheet sees the
/// moments.
///
/// # Errors
///
/// As [`sheet`].
pub fn film(
    figure: &Figure,
    animation: &Animation,
    overlay: &Overlay,
) -> Result<Vec<u8>, CharacterError> {
    let Animation {
        clip, storyboard, ..
    } = animation;
    let usual = options(figure, storyboard)?;
    let mut sequence = Sequence::new(Options {
        style: Style {
            width: FILM_SIZE[0],
            height: FILM_SIZE[1],
            supersampling: 2,
            ..usual.style
        },
        ..usual
    });
    for (number, pose) in clip.frames().iter().enumerate() {
        let positions = figure.character.skinned(pose, Method::Motor)?;
        sequence
            .add(&Frame::new(number, &positions))
            .map_err(of_film)?;
    }
    with_subject(figure, |subject| {
        let shooting = sequence.shoot(subject).map_err(of_film)?;
        let poses = clip.frames().iter().enumerate();
        let pictures = poses.map(|(number, pose)| {
            let time = number as f64 * clip.frame_time();
            let posed = Posed::new(&figure.character, overlay, time, pose)?;
            picture(&shooting, number, &posed)
        });
        let animation = png::Animation {
            frames_per_second: rate(clip.frame_time()),
            plays: 0,
        };
        let encoded = frames::encode(pictures, |frames| png::encode_animation(frames, animation));
        encoded?.map_err(|source| CharacterError::Encode {
            what: "film",
            source,
        })
    })?
}

fn of_film(source: SheetError) -> CharacterError {
    CharacterError::Draw {
        what: "film",
        source,
    }
}

fn picture(
    shooting: &Shooting,
    number: usize,
    posed: &Posed,
) -> Result<Plane<[u8; 3]>, CharacterError> {
    let frame = Frame {
        bones: &posed.marks.bones,
        lines: &posed.marks.lines(FILM_SIZE[1]),
        ..Frame::new(number, &posed.positions)
    };
    let picture = shooting.picture(number, &frame).map_err(of_film)?;
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

#[cfg(test)]
mod tests {
    use super::*;

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
