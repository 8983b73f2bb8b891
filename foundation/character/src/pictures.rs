//! The pictures of a motion: the contact sheet and the film.

use ga_anim::MotionFileError;
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_anim::skin::Method;
use ga_image::plane::Plane;
use ga_image::png;
use ga_mesh::gltf::Document;
use ga_render::model;
use ga_render::sheet::{Caption, Frame, Options, Sequence, SheetError, Shooting};
use ga_render::{Rendering, Scene, Style};

use crate::animated_scene::{AnimatedScene, Moment};
use crate::error::CharacterError;
use crate::figure::Figure;
use crate::gltf;
use crate::model::File;
use crate::overlay::{Marks, Overlay};
use crate::report::Animation;
use crate::staging::options;

/// The name of the contact sheet.
pub const SHEET: &str = "sheet.png";

/// Columns and rows of a picture of the film.
pub const FILM_SIZE: [u32; 2] = [360, 480];

/// The contact sheet of the moments of an animation as PNG, and what cannot be drawn as the
/// document of the figure asks, a sentence each.
///
/// A figure with a document is drawn as that has it: with its materials, the weights of its morph
/// targets, and meshes that no joint moves. Its vertices are moved by the linear blend, which is
/// what glTF says; those of other figures by motors. The camera sees all that joints move; morph
/// targets do not influence it.
///
/// # Errors
///
/// [`CharacterError::Draw`] and [`CharacterError::Encode`] where the sheet would be too large;
/// [`CharacterError::Skin`], [`CharacterError::Skeleton`] and [`CharacterError::Document`] for the
/// animation of another figure, [`CharacterError::Texture`] for a picture that cannot be read.
pub fn sheet(
    figure: &Figure,
    animation: &Animation,
    overlay: &Overlay,
) -> Result<(File, Vec<String>), CharacterError> {
    let Animation {
        storyboard, title, ..
    } = animation;
    let moments = storyboard.moments.iter().map(|moment| {
        let caption = Caption {
            number: moment.number,
            time: moment.time,
            kind: moment.kind,
        };
        (caption, &moment.pose)
    });
    let shots = Shots {
        what: "contact sheet",
        figure,
        overlay,
        options: Options {
            title: title.clone(),
            ..options(figure, storyboard)?
        },
        moments: moments.collect(),
    };
    let cameras = shots.cameras()?;
    let plan = cameras.plan().map_err(|error| shots.failed(error))?;
    let document = shots.document()?;
    let mut scene = shots.scene(&document)?;
    let numbers = 0..shots.moments.len();
    let pictures = numbers.map(|number| shots.picture(&mut scene, &cameras, number));
    let image = plan.sheet(pictures.collect::<Result<_, _>>()?).image;
    let contents = png::encode(&image).map_err(|source| CharacterError::Encode {
        what: shots.what,
        source,
    });
    let file = File {
        name: SHEET,
        contents: contents?,
        vertices: None,
        pixels: Some([image.width(), image.height()]),
    };
    Ok((file, scene.warnings().to_vec()))
}

/// Draws the frames of an animation as pictures of [`FILM_SIZE`], seen from where the contact sheet
/// sees the moments. `show` is given one after the other, with its number.
///
/// # Errors
///
/// As [`sheet`], and those of `show`.
pub fn film<E: From<CharacterError>>(
    figure: &Figure,
    animation: &Animation,
    overlay: &Overlay,
    mut show: impl FnMut(usize, &Plane<[u8; 3]>) -> Result<(), E>,
) -> Result<(), E> {
    let Animation {
        clip, storyboard, ..
    } = animation;
    let usual = options(figure, storyboard).map_err(CharacterError::from)?;
    let frames = clip.frames().iter().enumerate().map(|(number, pose)| {
        let caption = Caption {
            time: number as f64 * clip.frame_time(),
            ..Caption::new(number)
        };
        (caption, pose)
    });
    let shots = Shots {
        what: "film",
        figure,
        overlay,
        options: Options {
            style: Style {
                width: FILM_SIZE[0],
                height: FILM_SIZE[1],
                supersampling: 2,
                ..usual.style
            },
            ..usual
        },
        moments: frames.collect(),
    };
    let cameras = shots.cameras()?;
    let document = shots.document()?;
    let mut scene = shots.scene(&document)?;
    for number in 0..shots.moments.len() {
        let picture = shots.picture(&mut scene, &cameras, number)?;
        show(number, &picture.colour)?;
    }
    Ok(())
}

/// What is drawn of a figure, one moment after the other.
struct Shots<'a> {
    /// What the pictures become.
    what: &'static str,
    figure: &'a Figure,
    overlay: &'a Overlay<'a>,
    options: Options,
    moments: Vec<(Caption, &'a Pose)>,
}

impl Shots<'_> {
    fn marks(&self, (caption, pose): (Caption, &Pose)) -> Result<Marks, CharacterError> {
        Ok(self.overlay.marks(caption.time, pose)?)
    }

    /// The cameras, which see all that joints move.
    fn cameras(&self) -> Result<Shooting, CharacterError> {
        let mut sequence = Sequence::new(self.options.clone());
        for &(caption, pose) in &self.moments {
            let added = sequence.add(&Frame {
                caption,
                positions: &self.figure.character.skinned(pose, self.method())?,
                bones: &self.marks((caption, pose))?.bones,
            });
            added.map_err(|error| self.failed(error))?;
        }
        sequence.shoot().map_err(|error| self.failed(error))
    }

    /// The figure as glTF, moved by the pose of each moment at as many seconds as its number.
    fn document(&self) -> Result<Document, CharacterError> {
        let poses = self.moments.iter().map(|&(_, pose)| pose.clone());
        let clip = Clip::new(1.0, poses.collect()).map_err(MotionFileError::from)?;
        Ok(gltf::animated(self.figure, &clip, "moments")?.0)
    }

    fn scene<'a>(&self, document: &'a Document) -> Result<AnimatedScene<'a>, CharacterError> {
        let file = self.figure.file.as_ref();
        let scene = AnimatedScene::new(document, file.and_then(|file| file.parent()))?;
        Ok(scene.with_method(self.method()))
    }

    /// How vertices with several joints are moved.
    fn method(&self) -> Method {
        match self.figure.document {
            Some(_) => Method::Linear,
            None => Method::Motor,
        }
    }

    fn picture(
        &self,
        scene: &mut AnimatedScene<'_>,
        cameras: &Shooting,
        number: usize,
    ) -> Result<Rendering, CharacterError> {
        let marks = self.marks(self.moments[number])?;
        let model = scene.at(Moment {
            animation: Some(0),
            seconds: number as f64,
        })?;
        let drawn = model.with_scene(model::Options::default(), |scene| {
            let lines = [scene.lines, &marks.lines(self.options.style.height)].concat();
            let scene = Scene {
                lines: &lines,
                bones: &marks.bones,
                ..scene.clone()
            };
            cameras.picture(number, &scene)
        });
        drawn.map_err(|error| self.failed(error))
    }

    fn failed(&self, source: SheetError) -> CharacterError {
        CharacterError::Draw {
            what: self.what,
            source,
        }
    }
}
