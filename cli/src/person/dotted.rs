//! People with coloured dots on their skin.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use ga_anim::character::Character;
use ga_body::marked::{Mark, MarkedBody};
use ga_body::marker::Hue;
use ga_body::{BodyModel, BodyPoint};
use ga_character::Figure;
use ga_image::plane::Plane;
use ga_mannequin::{DISC_LIFT, Human, Marker, dots_on, with_discs};

use super::{CharacterFile, MANNEQUIN};
use crate::frame::Warning;

/// A person with a dot of one hue at each of its places for dots.
pub(crate) struct Dotted {
    name: String,
    body: Body,
    dots: Vec<Marker>,
    hues: Vec<Hue>,
}

enum Body {
    /// Its texture is painted.
    Mannequin(Box<Human>),
    /// Discs lie on its skin.
    Own(Box<Character>),
}

/// How the hues are drawn.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct HueSeed {
    /// The seed of the random hues of the dots: they are found by the seed with which they were
    /// painted.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
}

/// The character that has dots.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct DottedCharacter {
    /// The character: a skinned mesh in glTF, in metres with y up, or `mannequin` for the person of
    /// `nullcone demo`.
    #[arg(long, value_name = "C.glb|mannequin", default_value = MANNEQUIN)]
    character: PathBuf,
    #[command(flatten)]
    seed: HueSeed,
}

impl DottedCharacter {
    /// The file, where it is one.
    pub(crate) fn path(&self) -> Option<&Path> {
        CharacterFile(&self.character).path()
    }

    /// The seed of the hues.
    pub(crate) fn seed(&self) -> u64 {
        self.seed.seed
    }

    pub(crate) fn read(&self) -> Result<Dotted> {
        let Some(path) = self.path() else {
            return Ok(Dotted::mannequin(Human::new(), self.seed));
        };
        let figure = Figure::read_gltf(path, 1.0)?;
        let dotted = Dotted::own(figure.name, figure.character, self.seed);
        dotted.with_context(|| path.display().to_string())
    }
}

/// A body with fewer dots is not recognised.
const FEWEST: usize = 24;
/// A larger body, in metres, is not one on which dots of 15 mm are seen.
const LARGEST: f64 = 5.0;
/// Texels along the sides of the field of a colour, in a picture with so many fields.
const FIELD: usize = 16;
const FIELDS: usize = 8;
/// The grey of the skin in sRGB, darker than dots.
const GREY: [u8; 3] = [112; 3];

impl Dotted {
    pub(crate) fn mannequin(human: Human, seed: HueSeed) -> Self {
        let dots = human.dots();
        let body = Body::Mannequin(Box::new(human));
        Self::new(MANNEQUIN.to_owned(), body, dots, seed)
    }

    /// A character in metres.
    pub(crate) fn own(name: String, character: Character, seed: HueSeed) -> Result<Self> {
        let [low, high] = character
            .mesh
            .bounds()
            .context("the mesh has no vertices")?;
        let size = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
        ensure!(
            size <= LARGEST,
            "the character is {size:.1} m large, and dots are for people in metres"
        );
        let dots = dots_on(&character);
        ensure!(
            dots.len() >= FEWEST,
            "the skin has room for {} dots of 9.5 mm and more in radius, and {FEWEST} are needed: \
             the character is {size:.3} m large",
            dots.len()
        );
        Ok(Self::new(name, Body::Own(character.into()), dots, seed))
    }

    fn new(name: String, body: Body, dots: Vec<Marker>, HueSeed { seed }: HueSeed) -> Self {
        let centres: Vec<[f64; 3]> = dots.iter().map(|dot| dot.centre).collect();
        let hues = Hue::scattered(&centres, seed);
        Self {
            name,
            body,
            dots,
            hues,
        }
    }

    /// The name of the character.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// How many dots there are.
    pub(crate) fn count(&self) -> usize {
        self.dots.len()
    }

    /// The figure with its dots, and a warning where some have no room; the painted skin of the
    /// mannequin has this number of rows and columns.
    pub(crate) fn into_figure(self, size: usize) -> Result<(Figure, Option<Warning>)> {
        let mut left_out = Vec::new();
        let (character, paint) = match self.body {
            Body::Mannequin(human) => {
                let colours: Vec<_> = self.hues.iter().map(|hue| [hue.colour(); 2]).collect();
                let paint = human.marked_texture(size, &self.dots, &colours);
                ((*human).into(), paint)
            }
            Body::Own(character) => {
                let fields = self.hues.iter().map(|hue| field(1 + hue_number(*hue)));
                let discs: Vec<_> = self.dots.iter().zip(fields).collect();
                let (character, without) = with_discs(&character, &discs, field(0))?;
                left_out = without;
                (character, fields_of_colours())
            }
        };
        let names = left_out.iter().map(|&index| self.dots[index].name.as_str());
        let warning = (!left_out.is_empty()).then(|| {
            let message = format!(
                "dots for which the skin has no room are left out: {}",
                names.collect::<Vec<_>>().join(", ")
            );
            Warning::new("no_room", message)
        });
        let figure = Figure {
            paint: Some(paint),
            ..Figure::new(self.name, character)
        };
        Ok((figure, warning))
    }

    /// The body by which the dots are recognised.
    pub(crate) fn into_body(self) -> Result<MarkedBody> {
        let (skeleton, lift) = match self.body {
            Body::Mannequin(human) => (human.skeleton, 0.0),
            Body::Own(character) => (character.skeleton, DISC_LIFT),
        };
        let points = self.dots.iter().map(|dot| {
            let weights = dot.weights.iter();
            BodyPoint {
                name: dot.name.clone(),
                at_rest: [0, 1, 2].map(|k| dot.middle[k] + lift * dot.normal[k]),
                joints: weights
                    .map(|influence| (influence.joint as usize, influence.weight))
                    .collect(),
            }
        });
        let model = BodyModel::new(skeleton, points.collect())?;
        let marks = self.dots.iter().zip(self.hues).map(|(dot, hue)| Mark {
            hue,
            normal: dot.normal,
        });
        Ok(MarkedBody::new(model, marks.collect())?)
    }
}

fn hue_number(hue: Hue) -> usize {
    Hue::ALL.iter().position(|other| *other == hue).unwrap_or(0)
}

/// The texture coordinates of the middle of a field.
fn field(number: usize) -> [f64; 2] {
    [(number as f64 + 0.5) / FIELDS as f64, 0.5]
}

/// The picture of all colours: a field of grey, then one of each hue.
fn fields_of_colours() -> Plane<[u8; 3]> {
    Plane::from_fn(FIELDS * FIELD, FIELD, |column, _| {
        let hue = (column / FIELD).checked_sub(1);
        let hue = hue.and_then(|number| Hue::ALL.get(number));
        hue.map_or(GREY, |hue| hue.colour())
    })
}
