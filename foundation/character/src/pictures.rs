//! The pictures of a motion: the contact sheet and the film.

use std::io::Write;

use ga_anim::character::Character;
use ga_anim::pose::Pose;
use ga_anim::skin::Method;
use ga_image::film::{self, Rate};
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

/// Writes the frames of an animation as a film, seen from where the contact sheet sees the moments.
/// `progress` is told how many frames are drawn.
///
/// # Errors
///
/// As [`sheet`], and [`CharacterError::Encode`] where the film cannot be written.
pub fn write_film(
    figure: &Figure,
    animation: &Animation,
    overlay: &Overlay,
    writer: impl Write,
    format: film::Format,
    progress: &mut dyn FnMut(usize),
) -> Result<(), CharacterError> {
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
    let size = FILM_SIZE.map(|side| side as usize);
    let rate = Rate::new(clip.frame_time().recip()).unwrap_or(Rate::HIGHEST);
    let encoding = |source| CharacterError::Encode {
        what: "film",
        source,
    };
    with_subject(figure, |subject| {
        let shooting = sequence.shoot(subject).map_err(of_film)?;
        let frames = clip.frames();
        let film = film::Writer::new(writer, format, size, frames.len(), rate);
        let mut film = film.map_err(encoding)?;
        for (number, pose) in frames.iter().enumerate() {
            let time = number as f64 * clip.frame_time();
            let posed = Posed::new(&figure.character, overlay, time, pose)?;
            film.write(&picture(&shooting, number, &posed)?)
                .map_err(encoding)?;
            progress(number + 1);
        }
        film.finish().map_err(encoding)
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
    Ok(shooting.picture(number, &frame).map_err(of_film)?.colour)
}
