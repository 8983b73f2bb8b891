//! The person that the program makes itself, with coloured dots on its skin.

use anyhow::Result;
use ga_body::marked::{Mark, MarkedBody};
use ga_body::marker::Hue;
use ga_body::{BodyModel, BodyPoint};
use ga_character::Figure;
use ga_mannequin::{Human, Marker};

use super::MANNEQUIN;

/// The mannequin with a dot of one hue at each of its places for dots.
pub(crate) struct Dotted {
    human: Human,
    dots: Vec<Marker>,
    hues: Vec<Hue>,
}

/// How the hues are drawn.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct HueSeed {
    /// The seed of the random hues of the dots: they are found by the seed with which they were
    /// painted.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
}

impl Dotted {
    pub(crate) fn new(HueSeed { seed }: HueSeed) -> Self {
        let human = Human::new();
        let dots = human.dots();
        let centres: Vec<[f64; 3]> = dots.iter().map(|dot| dot.centre).collect();
        let hues = Hue::scattered(&centres, seed);
        Self { human, dots, hues }
    }

    /// How many dots there are.
    pub(crate) fn count(&self) -> usize {
        self.dots.len()
    }

    /// The figure with a painted skin of this number of rows and columns.
    pub(crate) fn into_figure(self, size: usize) -> Figure {
        let colours: Vec<_> = self.hues.iter().map(|hue| [hue.colour(); 2]).collect();
        let paint = self.human.marked_texture(size, &self.dots, &colours);
        Figure {
            paint: Some(paint),
            ..Figure::new(MANNEQUIN, self.human.into())
        }
    }

    /// The body by which the dots are recognised.
    pub(crate) fn into_body(self) -> Result<MarkedBody> {
        let points = self.dots.iter().map(|dot| {
            let weights = dot.weights.iter();
            BodyPoint {
                name: dot.name.clone(),
                at_rest: dot.middle,
                joints: weights
                    .map(|influence| (influence.joint as usize, influence.weight))
                    .collect(),
            }
        });
        let model = BodyModel::new(self.human.skeleton, points.collect())?;
        let marks = self.dots.iter().zip(self.hues).map(|(dot, hue)| Mark {
            hue,
            normal: dot.normal,
        });
        Ok(MarkedBody::new(model, marks.collect())?)
    }
}
